// SPDX-License-Identifier: MIT
#pragma once
// What the stick of a fencer feels: the coupling of the hand to the blade that collisions hold
// back, and the blows that the blade takes, on the stick's two coordinates. Positive along +x, +y
// of the stick. Where it ends: haptics/output_stage.hpp, the only way to an actuator.
// Frames: W world, H the hand. SI units; N m for each unit of the stick.

#include "batuta/control/keyframes.hpp"
#include "batuta/haptics/coupling.hpp"
#include "batuta/haptics/transient.hpp"

namespace batuta::haptics {

/// What a hand feels with.
template <class Scalar>
struct HandForceSettings {
  CouplingSettings<Scalar> coupling;    ///< to what it holds
  TransientSettings<Scalar> transient;  ///< of blows
};

/// @returns kOk | kInvalidArgument: out of range
template <class Scalar>
Status validate(const HandForceSettings<Scalar>& settings);

/// A hand after a step.
template <class Scalar>
struct HandState {
  KeyedPose<Scalar> commanded;  ///< where the stick wants the hand
  Pose<Scalar> held_W;          ///< where a hand is that holds the blade as it is
  /// How far the hand has hold of it, 0: a blow has just torn it loose ... 1 (Grip::control()). The
  /// coupling is as much weaker: a blade that flies pulls at no hand.
  Scalar hold = 1;
  /// Of the step's blows on the blade, and its moment about the commanded hand's origin.
  Momentum<Scalar> blow;
};

/// Of one hand. Velocities are those of the two poses over the step. Allocates: never.
template <class Scalar>
class HandForce {
 public:
  /// Starts anew: no blow, nothing known of an earlier step.
  /// @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const HandForceSettings<Scalar>& settings);

  /// After a step of length dt: the force of the step to come. Of the blow what fits the
  /// actuator's limit (TransientSettings::max_force), and of the coupling what room the blow
  /// leaves.
  /// @returns within that limit along both coordinates; zero, and nothing is kept of the step,
  ///   where a number is not finite or hold is outside [0, 1], also the coupling's force or energy,
  ///   or the sum of blows
  /// @pre dt > 0, s. Bound: no loop.
  Vec2<Scalar> advance(const HandState<Scalar>& state, Scalar dt);

  /// The hand is put somewhere else before the next step, which therefore has no velocities.
  void leap() { started_ = false; }

  /// Whether blow or coupling of the last step did not fit max_force: for StageInput::clipped,
  /// since an output stage sees what is left of the demand, which fits.
  bool is_clipped() const { return excess_ > Scalar(0); }
  /// How far the demand of that step was beyond max_force, in max_force: for StageInput::excess.
  /// 0: it fits. Finite.
  Scalar excess() const { return excess_; }
  /// Whether the coupling of that step was at its own limits: is_at_limit().
  bool is_limited() const { return limited_; }
  /// Whether that step could not be computed with, and was not felt.
  bool is_invalid() const { return invalid_; }

  /// The pulses of blows, to read what is left of them.
  const ImpactTransient<Scalar>& transient() const { return transient_; }
  /// What the coupling's springs held at the end of the last step, J: for PassivityObserver.
  Scalar stored() const { return stored_; }

 private:
  Wrench<Scalar> pull(const HandState<Scalar>& state, Scalar dt);
  Vec2<Scalar> invalid();
  void compare(const Vec2<Scalar>& blow, const Vec2<Scalar>& coupling);

  CouplingSettings<Scalar> coupling_;
  ImpactTransient<Scalar> transient_;
  Pose<Scalar> commanded_W_;  ///< at the end of the last step
  Pose<Scalar> held_W_;
  Scalar stored_ = 0;  ///< J
  Scalar excess_ = 0;
  bool limited_ = false;
  bool invalid_ = false;
  bool started_ = false;  ///< there was a last step
};

/// What became of the demands on a hand, for whom the stage's report is not enough: it has them
/// from is_clipped(), with all else that is cut. Counts wrap, as StageReport's do.
template <class Scalar>
struct HandForceReport {
  std::uint32_t steps = 0;    ///< made
  std::uint32_t clipped = 0;  ///< whose blow or coupling did not fit TransientSettings::max_force
  std::uint32_t limited = 0;  ///< whose coupling was at its own limits
  std::uint32_t invalid = 0;  ///< that could not be computed with, and were not felt
  Scalar worst_excess = 0;    ///< the largest demand beyond max_force, in max_force

  /// After each HandForce::advance().
  void take(const HandForce<Scalar>& hand) {
    ++steps;
    if (hand.is_clipped()) ++clipped;
    if (hand.is_limited()) ++limited;
    if (hand.is_invalid()) ++invalid;
    worst_excess = max_of(worst_excess, hand.excess());
  }
};

}  // namespace batuta::haptics
