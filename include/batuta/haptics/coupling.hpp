// SPDX-License-Identifier: MIT
#pragma once
// Virtual coupling: a spring and a damper, along and about all axes, between where the hand is
// commanded to be and where what it holds really is. The held body is the god object: the world
// moves it, never lets it penetrate anything, however thin, and the spring tells the hand how far
// it is kept away. Nothing is ever felt of a depth of penetration, for there is none.
// Frames: W world, H the hand, B the held body, origin in its centre of mass. SI units.
// Mathematics: src/haptics/coupling.md. Which stiffness is stable: haptics/gain_advisor.hpp.

#include "batuta/haptics/force_map.hpp"

namespace batuta::haptics {

/// Springs and dampers between a hand and what it holds.
template <class Scalar>
struct CouplingSettings {
  Scalar stiffness = Scalar(400);       ///< N/m, >= 0
  Scalar damping = Scalar(2);           ///< N s/m, >= 0
  Scalar turn_stiffness = Scalar(4);    ///< N m/rad, >= 0
  Scalar turn_damping = Scalar(0.02F);  ///< N m s/rad, >= 0
  /// A spring stretched further pulls no harder, N and N m, > 0. Holds for each of the two vectors.
  Scalar max_force = Scalar(60);
  Scalar max_moment = Scalar(6);  ///< N m
};

/// @returns kOk | kInvalidArgument: out of range or not finite
template <class Scalar>
Status validate(const CouplingSettings<Scalar>& settings);

/// Where a frame is and how its origin and itself move.
template <class Scalar>
struct MovingFrame {
  Pose<Scalar> X_W;     ///< of the frame in W
  Twist<Scalar> twist;  ///< of its origin, and of itself
};

/// What the coupling does to `commanded`, about its origin: it is pulled towards `actual`. What it
/// does to `actual` is the opposite, about the same point (moved(), negated): together they take
/// energy away or keep it, never give any, whatever both do. The turn goes the shortest way; of a
/// turn by pi exactly, either.
/// @returns a wrench of at most max_force and max_moment; zero where a number is not finite
/// @pre settings valid; quaternions unit. Bound: no loop.
template <class Scalar>
Wrench<Scalar> coupling_wrench(const CouplingSettings<Scalar>& settings,
                               const MovingFrame<Scalar>& commanded,
                               const MovingFrame<Scalar>& actual);

/// As coupling_wrench(), but not finite where a number is not: who asks can tell that from a
/// coupling that is slack. @pre as coupling_wrench()
template <class Scalar>
Wrench<Scalar> raw_coupling_wrench(const CouplingSettings<Scalar>& settings,
                                   const MovingFrame<Scalar>& commanded,
                                   const MovingFrame<Scalar>& actual);

/// Whether a wrench of coupling_wrench() is held at one of the two limits, or fits it exactly: to
/// rounding, they are the same. Bound: no loop.
template <class Scalar>
bool is_at_limit(const CouplingSettings<Scalar>& settings, const Wrench<Scalar>& wrench);

/// What the springs hold, J: coupling_wrench() without dampers is its slope, also where a limit
/// holds. Infinite or NaN where a number is not finite. @pre as coupling_wrench()
template <class Scalar>
Scalar stored_energy(const CouplingSettings<Scalar>& settings, const Pose<Scalar>& commanded_W,
                     const Pose<Scalar>& actual_W);

/// Both sides at once, for a body that flies by its momenta (FreeFlight): changes the body's
/// momenta by what the coupling does to it over the coming step, and returns the mean wrench on the
/// commanded frame over it, about the *body's* centre of mass. Implicit in the body's motion: for
/// any stiffness, damping, mass, limit and dt no energy comes from the integration, but to second
/// order in the turn of a step. What a hand feels of a body that is kept where it is has the gains
/// K / s and (B + K dt) / s, s = 1 + dt (K dt + B) / mass: these are for check() of
/// gain_advisor.hpp.
/// @param commanded_W  where B should be, and how it should move, at the start of the step
/// @returns kInvalidArgument: not finite, also in the result, or dt <= 0; then nothing is changed.
///   A body that cannot be moved is not, but is felt.
/// @pre settings valid. Bound: no loop.
template <class Scalar>
Result<Wrench<Scalar>> couple(const CouplingSettings<Scalar>& settings,
                              const MovingFrame<Scalar>& commanded_W, Body<Scalar>& body,
                              Scalar dt);

}  // namespace batuta::haptics
