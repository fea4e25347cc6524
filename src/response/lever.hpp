// SPDX-License-Identifier: MIT
#pragma once
// Where an impulse meets a body. Internal to the room: what K = 1/m - [r] I^-1 [r] is made of,
// never the matrix itself, because a quadratic form of moments in the body's own axes is a sum of
// squares in which unequal inertias cancel nothing [Kavan eq. 28, 29].

#include "batuta/response/impulse.hpp"

namespace batuta {

/// Where a body is pushed.
template <class Scalar>
struct Lever {
  Vec3<Scalar> arm_W = Vec3<Scalar>::Zero();  ///< r, from the centre of mass to the point
  Mat3<Scalar> R_WB = Mat3<Scalar>::Identity();
};

template <class Scalar>
Lever<Scalar> lever_of(const Collider<Scalar>& body, const Contact<Scalar>& contact) {
  return {contact.point_W - body.X_WB.p_W, detail::to_matrix(body.X_WB.q_WB)};
}

/// Torque of an impulse d at the point about the centre of mass, in the body's axes.
template <class Scalar>
Vec3<Scalar> moment_of(const Lever<Scalar>& lever, const Vec3<Scalar>& d_W) {
  return lever.R_WB.transpose() * lever.arm_W.cross(d_W);
}

/// Impulse J at the end of the arm, and its torque about the centre of mass.
template <class Scalar>
Momentum<Scalar> impulse_on(const Vec3<Scalar>& arm_W, const Vec3<Scalar>& J_W) {
  return {J_W, arm_W.cross(J_W)};
}

/// Whether all that a blow comes to is finite: one infinity or NaN spoils the sum.
template <class Scalar>
bool is_sound(const Impulse<Scalar>& hit);

}  // namespace batuta
