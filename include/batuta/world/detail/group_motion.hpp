// SPDX-License-Identifier: MIT
#pragma once
// How bodies that go on together turn about their common centre (src/world/world.md, "Together").
// Frame W, SI units.

#include "batuta/mechanics/motion.hpp"

namespace batuta::detail {

/// Inertia of a body about a point that its centre is at r_W from, axes of W.
/// @pre inverse mass > 0
template <class Scalar>
Mat3<Scalar> inertia_about(const Body<Scalar>& body, const Vec3<Scalar>& r_W);

/// The constant angular velocity that brings what has this inertia and angular momentum to where
/// free_flight() has it after `duration`; zero where that is half a turn or more away.
template <class Scalar>
Vec3<Scalar> group_spin(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W, Scalar duration);

/// w with I w = L, to the rounding of L: solved along the principal axes, and once more for what is
/// left.
template <class Scalar>
Vec3<Scalar> spin_for(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W);

}  // namespace batuta::detail
