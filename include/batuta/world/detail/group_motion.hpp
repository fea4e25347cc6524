// SPDX-License-Identifier: MIT
#pragma once
// How bodies that go on together turn about their common centre (src/world/world.md, "Together").
// Frame W, SI units.

#include "batuta/mechanics/motion.hpp"

namespace batuta::detail {

/// Adds the inertia of a body about a point that its centre is at r_W from, axes of W.
/// @pre inverse mass > 0
template <class Scalar>
void add_inertia(Mat3<Scalar>& inertia_W, const Body<Scalar>& body, const Vec3<Scalar>& r_W);

/// The constant angular velocity with which what has this inertia and angular momentum goes on for
/// `duration`: that of the middle of it, where the turn of the first half is taken to be steady. Of
/// second order in the turn; zero where that is half a turn or more.
template <class Scalar>
Vec3<Scalar> group_spin(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W, Scalar duration);

/// w with I w = L, to the rounding of L: solved by cofactors, and once more for what is left. An
/// inertia that is thinner than rounding about an axis counts as that.
template <class Scalar>
Vec3<Scalar> spin_for(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W);

}  // namespace batuta::detail
