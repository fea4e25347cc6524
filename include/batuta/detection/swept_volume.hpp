// SPDX-License-Identifier: MIT
#pragma once
// Volumes that hold a moving capsule during a whole step [Kavan §3.2, eq. 19]: if two do not meet,
// neither do the capsules.

#include "batuta/detection/moving_pair.hpp"
#include "batuta/geometry/kdop.hpp"

namespace batuta {

namespace detail {

/// The ball about the centre of mass that holds the capsule however it turns, swept along the
/// motion: its centres run from start_W to end_W.
template <class Scalar>
struct SweptSphere {
  Vec3<Scalar> start_W = zero<Scalar>();  ///< the centre of mass at t = 0, m
  Vec3<Scalar> end_W = zero<Scalar>();    ///< the centre of mass at the end, m
  Scalar radius = 0;                      ///< m, rounded outward
};
/// The swept ball of a moving capsule, rounded outward. @pre `moving` valid. Bound: two ends.
template <class Scalar>
SweptSphere<Scalar> swept_sphere(const MovingCapsule<Scalar>& moving);

/// What the supports of one moving capsule share, whatever the direction.
template <class Scalar>
struct CapsuleSweep {
  CapsulePath<Scalar> path;                ///< seen from the centre of mass at t = 0
  Vec3<Scalar> start_W = zero<Scalar>();   ///< the centre of mass at t = 0, m
  Vec3<Scalar> travel_W = zero<Scalar>();  ///< what it moves by, v T, m
  Scalar turn = 0;                         ///< |w| T, rad
  SinCos<Scalar> at_end;                   ///< of the turn, where that is <= kMaxAngle
  Scalar outward = 0;       ///< what a support is rounded outward by, m: its error bound
  bool is_bounded = false;  ///< the lengths sum up to at most kLargestCoordinate
};
/// @pre `moving` valid. Bound: one sine/cosine.
template <class Scalar>
CapsuleSweep<Scalar> capsule_sweep(const MovingCapsule<Scalar>& moving);

/// max of direction . x over all points of the capsule at all times of its motion, in closed form
/// [Kavan §3.2 leaves it open]. Never less than that; more by at most |direction| times twice
/// `outward` and 12 u turn of the longer lever. Beyond kMaxAngle that of whole circles carried
/// along; max() where the sweep is not bounded. Derivation and rounding:
/// src/detection/swept_volume.md.
/// @param direction  in W, no component above 1 in size, otherwise of any length
/// Bound: for each end a square root and two arc tangents; none of them where it rises or falls all
/// the way.
template <class Scalar>
Scalar swept_support(const CapsuleSweep<Scalar>& sweep, const Vec3<Scalar>& direction);

}  // namespace detail

/// The smallest box in W that holds the capsule at every time of its motion, rounded outward like
/// swept_support(). Without bounds (lowest() ... max()) where the lengths sum up to more than
/// kLargestCoordinate.
template <class Scalar>
Aabb<Scalar> swept_aabb(const MovingCapsule<Scalar>& moving);

namespace detail {

/// The same in k directions. Bound: K / 2 directions.
template <class Scalar, int K>
Kdop<Scalar, K> swept_kdop(const MovingCapsule<Scalar>& moving);

/// A box that holds the capsule at every time of its motion without an arc tangent: both ends of
/// the step, grown by how far an arc can leave its chord. Each face is further out than that of
/// swept_aabb() by at most turn^2 / 8 of an end's lever, and no face further than that of the swept
/// sphere. Up to a turn of 1/16 rad it has no sine either: each end along its tangent, and turn^2 /
/// 2 of the lever aside; then a face is further out by at most turn^2 of the lever. It takes a
/// quarter of the time of swept_aabb() there, and less from about half a radian on.
template <class Scalar>
Aabb<Scalar> coarse_swept_aabb(const MovingCapsule<Scalar>& moving);

/// The same in k directions. Bound: K / 2 directions.
template <class Scalar, int K>
Kdop<Scalar, K> coarse_swept_kdop(const MovingCapsule<Scalar>& moving);

}  // namespace detail

/// Whether two swept spheres meet, rounded towards yes.
template <class Scalar>
bool overlaps(const detail::SweptSphere<Scalar>& P, const detail::SweptSphere<Scalar>& Q);

}  // namespace batuta
