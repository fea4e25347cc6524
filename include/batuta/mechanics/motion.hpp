// SPDX-License-Identifier: MIT
#pragma once
// Where a body is during a step: what the paper's black box answers [Kavan §2.1]. Over one step
// every motion is a constant twist; still, linear and turning motion are the special cases with
// zero terms.

#include "batuta/mechanics/body.hpp"

namespace batuta {

/// Pose at t in [0, duration]: p_W + v_W t, exp(w_W t) q_WB.
template <class Scalar>
struct Motion {
  Pose<Scalar> X_WB;    ///< at t = 0
  Twist<Scalar> twist;  ///< constant
  Scalar duration = 0;  ///< s, >= 0
};

/// The motion of what stays where it is.
template <class Scalar>
Motion<Scalar> still(const Pose<Scalar>& X_WB, Scalar duration);
/// The motion of what does not turn.
template <class Scalar>
Motion<Scalar> linear(const Pose<Scalar>& X_WB, const Vec3<Scalar>& v_W, Scalar duration);

/// The constant twist that carries X0 into X1 in `duration` on the shortest way.
/// @pre duration > 0
template <class Scalar>
Motion<Scalar> motion_between(const Pose<Scalar>& X0_WB, const Pose<Scalar>& X1_WB,
                              Scalar duration);

/// Torque-free flight from the body's momenta (src/mechanics/motion.md).
/// Exact for the geometry of an axisymmetric body whose spin does not show: the axis turns steadily
/// about the angular momentum at |b| / I_t, and spin about the axis itself, which no capsule on it
/// shows, is left out. Exact at the end of the motion for an axisymmetric body whose spin shows.
/// Other bodies: of fourth order in the duration, and the energy at the end is that of the start,
/// or of the flight that the body is on (move_along()). Between the ends these two move with the
/// constant twist that joins them.
/// @pre duration >= 0
/// @returns a motion that is not valid (see is_valid()) where such a body turns by half a turn or
///   more in the time, because that could not be told from a shorter turn; or would end with more
///   energy, by a 1024th, than it has
/// Bound: kMostParts = 26 parts of six turns each.
template <class Scalar>
Motion<Scalar> free_flight(const Body<Scalar>& body, Scalar duration);

/// Moves a body along a motion that free_flight() planned for it, to pose_at(motion, t). A body
/// with three unlike moments remembers the energy of its flight, so that steps that follow each
/// other keep it, until the angular momentum changes.
/// @pre those of pose_at()
template <class Scalar>
void move_along(Body<Scalar>& body, const Motion<Scalar>& motion, Scalar t);

namespace detail {

/// Whether the capsule lies on the axis of an axisymmetric body (to rounding), so that spin about
/// the axis does not show. False where all three moments are unlike or one is zero. Bound: no loop.
template <class Scalar>
bool hides_spin(const Body<Scalar>& body, const Capsule<Scalar>& capsule_B);

/// Whether its flight is bent: three unlike moments, or two equal ones and the spin shows. Between
/// the ends of a flight it is then on a chord. Bound: no loop.
template <class Scalar>
bool flies_bent(const Body<Scalar>& body);

/// free_flight() of a body whose flight is not bent, without the rest of its code: the same bits,
/// or to rounding where all three moments are equal and the spin shows. Of others: it goes on as it
/// turns now. @pre duration >= 0
template <class Scalar>
Motion<Scalar> steady_flight(const Body<Scalar>& body, Scalar duration);

/// Whether the three moments are unlike (to rounding), so that a flight has something to remember.
template <class Scalar>
bool tumbles(const Body<Scalar>& body);

/// Of the energy of a turn: what a contact may find it off that of the flight, and what a flight
/// may end with besides it.
template <class Scalar>
inline constexpr Scalar kOffFlight = Scalar(1) / 1024;

/// By how much the energy of a turn is off that of the flight that the body is on, where a motion
/// that free_flight() planned for it has it after t; of the latter. 0 where its flight is not bent,
/// or the turn is so short that it is off by no more than kOffFlight (src/mechanics/motion.md, "The
/// energy on the chord"). @pre 0 <= t <= duration
template <class Scalar>
Scalar off_flight_energy(const Body<Scalar>& body, const Motion<Scalar>& motion, Scalar t);

}  // namespace detail

/// The pose at time t, the quaternion renewed; exactly X_WB at t = 0.
/// @pre 0 <= t <= duration; |w| t <= kMaxAngle
template <class Scalar>
Pose<Scalar> pose_at(const Motion<Scalar>& motion, Scalar t);

/// Finite at both ends, 0 <= duration, turn |w| duration <= kMaxAngle.
template <class Scalar>
bool is_valid(const Motion<Scalar>& motion);

}  // namespace batuta
