// SPDX-License-Identifier: MIT
#pragma once
// From the hand to the stick: a wrench on the hand becomes a force on the stick's two coordinates
// through the transposed Jacobian of the key poses, the map by which the stick moved the hand
// [Kavan §5, Fig. 5]. The same map both ways: what the stick gives, the hand gets, as power.
// Frame W, SI units. Mathematics: src/haptics/force_map.md.

#include "batuta/control/keyframes.hpp"

namespace batuta::haptics {

/// A force and its moment about a point that the function names, axes of W.
template <class Scalar>
struct Wrench {
  Vec3<Scalar> force_W = Vec3<Scalar>::Zero();   ///< N
  Vec3<Scalar> moment_W = Vec3<Scalar>::Zero();  ///< N m
};

/// The same wrench with its moment about another point.
/// @param p_from_W, p_to_W  m
template <class Scalar>
Wrench<Scalar> moved(const Wrench<Scalar>& about_from, const Vec3<Scalar>& p_from_W,
                     const Vec3<Scalar>& p_to_W);

/// J^T w: the force on the stick's coordinates that does the same work as `wrench` on the hand,
/// N m for each unit of the stick. Zero along a coordinate that is beyond the rim. No loop bound:
/// 2 x 6 products.
/// @param wrench  about the hand's origin
template <class Scalar>
Vec2<Scalar> stick_force(const StickJacobian<Scalar>& jacobian, const Wrench<Scalar>& wrench);

}  // namespace batuta::haptics
