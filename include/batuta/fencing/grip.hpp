// SPDX-License-Identifier: MIT
#pragma once
// A hand that holds a blade, loses it to a blow and catches it again [Kavan §5, eq. 32]. A
// controller (world/controller.hpp). Frames: W world, B the blade's body frame. Mathematics:
// src/fencing/grip.md.

#include "batuta/world/controller.hpp"

namespace batuta::fencing {

/// How firmly a hand holds.
template <class Scalar>
struct GripSettings {
  Scalar strength = Scalar(4);       ///< N, > 0: the force with which the hand takes a blade back
  Scalar min_regain = Scalar(0.02);  ///< s, > 0; shortest t_b - t_a after a blow
  Scalar max_regain = Scalar(0.4);   ///< s, >= min_regain; longest
  /// s, > 0: time constant in which a blade that was pushed away returns
  Scalar recover_time = Scalar(0.1);
  Scalar lever = Scalar(0.5);  ///< m, > 0: a turn of 1 rad counts as a lag of this length
};

/// @returns kOk | kInvalidArgument: an option is not positive and finite, or max_regain <
/// min_regain
template <class Scalar>
Status validate(const GripSettings<Scalar>& settings);

/// t_b - t_a: the longer of impulse / strength, in which that force takes up the blow, and
/// sqrt(6 lag mass / strength), in which it fetches the blade back; within [min_regain,
/// max_regain], s. 0 for no impulse.
/// @param impulse       j, N s, >= 0
/// @param lag           distance from the blade to where the hand wants it, m, >= 0
/// @param inverse_mass  of the blade, 1/kg, >= 0
template <class Scalar>
Scalar regain_time(const GripSettings<Scalar>& settings, Scalar impulse, Scalar lag,
                   Scalar inverse_mass);

/// [Kavan eq. 32]: between the free flight P and the hand H. Parameter 0: P; 1: H, to the last bit.
/// The weight of H is s^2 (3 - 2 s), so that also the velocity is that of P at t_a and that of H at
/// t_b. The turn is taken back along the way on which the flight made it: it does not jump however
/// far a blade turns.
/// @param flight  from t_a on; @param elapsed  t - t_a, s, >= 0
/// @param parameter  s = (t - t_a) / (t_b - t_a), in [0, 1]
template <class Scalar>
Pose<Scalar> caught(const Motion<Scalar>& flight, Scalar elapsed, const Pose<Scalar>& hand,
                    Scalar parameter);

/// Who moves the blade.
enum class GripPhase : std::uint8_t {
  kHeld,       ///< the blade follows the hand
  kRegaining,  ///< between free flight and hand
};

/// The controller. Where the world kept the blade from going where the plan wants it (separation,
/// holds), it follows the plan from where it is, and the difference fades with recover_time: it
/// never snaps back. Allocates: never.
template <class Scalar>
class Grip {
 public:
  /// Sets what the hand can do; where it is, stays. @returns kOk | kInvalidArgument (nothing
  /// changed)
  Status configure(const GripSettings<Scalar>& settings);

  /// Puts the hand somewhere, still, and closes it.
  void place(const Pose<Scalar>& X_WB);

  /// Where the hand wants B at the end of the coming step. @pre pose finite; step > 0, s
  void command(const Pose<Scalar>& X_WB, Scalar step);

  /// Hand, or the way back to it [Kavan eq. 32], over [t, t + duration] of the step.
  /// @pre 0 <= t, 0 <= duration
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  /// A blow loosens the hold for regain_time().
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  /// The step of length dt is over; the body is where it is.
  void on_step_end(const Body<Scalar>& body, Scalar dt);

  /// Who moves the blade at present.
  GripPhase phase() const { return phase_; }
  /// t of [Kavan eq. 32] at the end of the last step: 0 free ... 1 held.
  Scalar control() const;
  /// The hand at the end of the last commanded step.
  const Pose<Scalar>& hand() const { return target_; }

  /// Its state, for record/archive.hpp.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [settings, hand, target, step, flight, flight_start, regain, phase] = *this;
    ar(settings, hand, target, step, flight, flight_start, regain, phase);
  }

 private:
  Pose<Scalar> hand_at(Scalar t) const;
  Pose<Scalar> planned_at(Scalar t) const;

  GripSettings<Scalar> settings_;
  Motion<Scalar> hand_;    ///< of the hand over the current step
  Pose<Scalar> target_;    ///< at its end
  Scalar step_ = 0;        ///< s; 0: nothing commanded
  Motion<Scalar> flight_;  ///< P, from t_a
  /// t_a on the clock of the current step, s: <= 0 after the step in which it happened
  Scalar flight_start_ = 0;
  Scalar regain_ = 0;  ///< t_b - t_a, s
  GripPhase phase_ = GripPhase::kHeld;
};

}  // namespace batuta::fencing
