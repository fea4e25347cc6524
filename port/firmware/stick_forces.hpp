// SPDX-License-Identifier: MIT
#pragma once
// The forces on both sticks after each step of a duel. Whoever makes the same steps with the same
// samples, device or host, gets the same bits.

#include <array>

#include "firmware/blow_force.hpp"
#include "firmware/force_ramp.hpp"

namespace batuta::firmware {

struct ForceSettings {
  /// The force on a stick's coordinate that takes all that the actuator has, N m for each unit of
  /// the stick, > 0 and finite. The hardest blows of the recordings come to 40 ... 80.
  float full_scale = 100;
  RampSettings ramp;  ///< what silence of a fencer's samples does
};

/// @returns kOk | kInvalidArgument: out of range
Status validate(const ForceSettings& settings);

struct StickForce {
  Vec2<float> share = Vec2<float>::Zero();  ///< of the actuator's range, each in [-1, 1]
  bool limited = false;                     ///< the blow was harder than the range
  bool silent = true;                       ///< no sample for too long, see RampSettings
  bool ramped = false;                      ///< the share is less than the blow's
};

class StickForces {
 public:
  /// Starts anew: no force, both sides silent. @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const ForceSettings& settings);

  /// @param duel   has just made a step
  /// @param fresh  whether that step had a new sample of the side
  /// Bound: the contact events of the step, twice.
  void advance(const DuelType& duel, const std::array<bool, 2>& fresh);

  const StickForce& of(Side side) const { return forces_[index_of(side)]; }
  /// Silences that began on either side since the start.
  std::uint32_t silences() const { return ramps_[0].silences() + ramps_[1].silences(); }
  /// Steps since the start with a side that was silent.
  std::uint32_t stale_steps() const { return stale_steps_; }

 private:
  ForceSettings settings_;
  std::array<ForceRamp, 2> ramps_;
  std::array<StickForce, 2> forces_;
  std::uint32_t stale_steps_ = 0;
};

}  // namespace batuta::firmware
