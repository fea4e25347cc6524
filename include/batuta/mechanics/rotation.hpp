// SPDX-License-Identifier: MIT
#pragma once
// The three ways to write a rotation [Kavan §2] and all ways between them. Convention: R_WB, q_WB
// turn components in B into components in W; a rotation vector is axis times angle, rad, and the
// same in both frames. Unit quaternions q and -q are one rotation; where a unique answer is needed,
// the one with w >= 0.

#include "batuta/mechanics/trigonometry.hpp"

namespace batuta {

namespace detail {

/// A turn by `angle` about the unit vector `axis`. The identity has angle 0 and the x axis.
template <class Scalar>
struct AxisAngle {
  Vec3<Scalar> axis = detail::unit_x<Scalar>();  ///< unit; the same in both frames
  Scalar angle = 0;                              ///< rad; answers lie in [0, pi]
};

}  // namespace detail

/// q scaled to unit length; the identity if q is zero or not finite.
template <class Scalar>
Quat<Scalar> renewed(const Quat<Scalar>& q);

namespace detail {

/// q_AB q_BC, scaled to unit length.
template <class Scalar>
Quat<Scalar> composed(const Quat<Scalar>& q_AB, const Quat<Scalar>& q_BC);

/// R of q. @pre q unit
template <class Scalar>
Mat3<Scalar> to_matrix(const Quat<Scalar>& q);
/// R of a turn. @pre axis unit; |angle| / 2 <= kMaxAngle
template <class Scalar>
Mat3<Scalar> to_matrix(const AxisAngle<Scalar>& turn);

/// The q of R with w >= 0.
/// @pre R is a rotation to within rounding. The largest of the four components is computed first:
/// no cancellation.
template <class Scalar>
Quat<Scalar> to_quaternion(const Mat3<Scalar>& R);
/// The q of a turn with w >= 0. @pre axis unit; |angle| / 2 <= kMaxAngle
template <class Scalar>
Quat<Scalar> to_quaternion(const AxisAngle<Scalar>& turn);

/// The turn of q, angle in [0, pi]. @pre q unit
template <class Scalar>
AxisAngle<Scalar> to_axis_angle(const Quat<Scalar>& q);
/// The turn of R, angle in [0, pi]. @pre R is a rotation to within rounding
template <class Scalar>
AxisAngle<Scalar> to_axis_angle(const Mat3<Scalar>& R);

}  // namespace detail

/// Rotation vector -> unit quaternion; without cancellation for small and for large angles.
/// @pre |rotation_vector| <= kMaxAngle
template <class Scalar>
Quat<Scalar> exp_map(const Vec3<Scalar>& rotation_vector);

/// Unit quaternion -> the rotation vector of length <= pi; without cancellation near 0 and near pi.
template <class Scalar>
Vec3<Scalar> log_map(const Quat<Scalar>& q);

namespace detail {

/// The matrix J with exp_map(r + dr) = exp_map(J dr) exp_map(r) to first order: the angular
/// velocity, in the frame that exp_map(r) turns into, is J r'. Used for the Jacobian of the
/// keyframe grid.
template <class Scalar>
Mat3<Scalar> left_jacobian(const Vec3<Scalar>& rotation_vector);

/// Of the squared length of a quaternion: what is further from 1 is no rotation that rounding has
/// brought off its length.
template <class Scalar>
inline constexpr Scalar kUnitWithin = Scalar(1) / 512;

/// Of the squared length of a quaternion that the library has made: what rounding leaves.
template <class Scalar>
inline constexpr Scalar kUnitRounding = 32 * kRoundOff<Scalar>;

/// How far the squared length of q is from 1.
template <class Scalar>
Scalar off_unit(const Quat<Scalar>& q) {
  const Scalar square = (q.x() * q.x() + q.y() * q.y()) + (q.z() * q.z() + q.w() * q.w());
  return std::abs(square - Scalar(1));
}
/// Whether q is one, to within kUnitWithin.
template <class Scalar>
bool is_turn(const Quat<Scalar>& q) {
  return off_unit(q) <= kUnitWithin<Scalar>;
}
/// Whether q has a direction: an orientation, of whatever length.
template <class Scalar>
bool points(const Quat<Scalar>& q) {
  return is_finite(q) && !(q.coeffs().array() == Scalar(0)).all();
}
/// A quaternion of a caller's that points: of unit length as it is, to the last bit; any other
/// renewed.
template <class Scalar>
Quat<Scalar> unit_of(const Quat<Scalar>& q) {
  const bool is_unit = off_unit(q) <= kUnitRounding<Scalar>;
  return is_unit ? q : renewed(q);
}

}  // namespace detail

/// The rotation on the shortest way from q0 (t = 0) to q1 (t = 1) at a constant rate; exact at both
/// ends.
template <class Scalar>
Quat<Scalar> interpolated(const Quat<Scalar>& q0, const Quat<Scalar>& q1, Scalar t);

}  // namespace batuta
