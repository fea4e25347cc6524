// SPDX-License-Identifier: MIT
#pragma once
// The forces on both sticks after each step of a duel, as far as the duel and its samples decide
// them. Whoever makes the same steps with the same samples, device or host, gets the same bits.
// What a motor is told comes from its output stage, which knows the ticks and the motor, too.

#include <array>

#include "batuta/haptics/duel_hand.hpp"
#include "batuta/haptics/force_ramp.hpp"
#include "batuta/haptics/speed_limiter.hpp"

namespace batuta::haptics {

/// A demand that takes less of the range than this is none: a motor driver of 12 bits would not
/// show it, and the rounding of poses in hand and blade comes to a tenth of it.
inline constexpr float kLeastFeltShare = 1.0F / 4096;

/// What a hand with the grip of the library's fencers (GripSettings::strength, 4 N) can feel of its
/// blade: a coupling that pulls no harder than twice that.
inline haptics::HandForceSettings<float> soft_feel() {
  haptics::HandForceSettings<float> feel;
  feel.coupling.max_force = 8;
  feel.coupling.max_moment = 0.8F;
  return feel;
}

/// What becomes of what a duel demands of a stick.
struct ForceSettings {
  /// The force on a stick's coordinate that takes all that the actuator has, N m for each unit of
  /// the stick, > 0 and finite. The hardest blows of the recordings come to half of it.
  float full_scale = 40;
  /// What silence of a fencer's samples, or of the host, does.
  haptics::RampSettings ramp{};
  /// Of the motor alone: the forces told to a host are without it.
  haptics::SpeedLimitSettings speed_limit{};
  /// Coupling and pulses; the pulses' limit is full_scale, whatever it says. What is stable is the
  /// device's: check() of haptics/gain_advisor.hpp.
  haptics::HandForceSettings<float> feel = soft_feel();

  /// Share of the range for each N m for each unit of the stick, by axis.
  Vec2<float> gain() const { return Vec2<float>::Constant(1.0F / full_scale); }
};

/// @returns kOk | kInvalidArgument: out of range
Status validate(const ForceSettings& settings);

/// The force on one stick.
struct StickForce {
  /// What the duel demands, N m for each unit of the stick, before the stage's limits.
  Vec2<float> demanded = Vec2<float>::Zero();
  float allowed = 0;  ///< share that the silence of the samples leaves, 0 ... 1
  Vec2<float> share = Vec2<float>::Zero();  ///< of the actuator's range, each in [-1, 1]
  float excess = 0;      ///< of the demand beyond the range, in ranges: for the stage's report
  bool limited = false;  ///< the demand was larger than the range, or no number
  bool silent = true;    ///< no sample for too long, see RampSettings
  bool ramped = false;   ///< the share is less than what was demanded
};

/// The forces on both sticks of a duel.
/// Allocates: never.
class StickForces {
 public:
  /// Starts anew: no force, both sides silent. @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const ForceSettings& settings);

  /// @param duel   has just made a step
  /// @param fresh  whether that step had a sign of life of the side's stick
  /// Bound: the contact events of the step, twice. Kept apart: its stack is not there while the
  /// duel steps.
  template <class DuelT>
  [[gnu::noinline]] void advance(const DuelT& duel, const std::array<bool, 2>& fresh) {
    if (duel.bout().exchange != exchange_) leap(duel.bout().exchange);
    for (const fencing::Side side : {fencing::Side::kLeft, fencing::Side::kRight}) {  // Bound: 2
      haptics::HandForce<float>& hand = hands_[index_of(side)];
      const Vec2<float> felt = hand.advance(haptics::hand_state(duel, side), duel.dt());
      take(side, felt, fresh[index_of(side)]);
    }
    if (forces_[0].silent || forces_[1].silent) ++stale_steps_;
  }

  /// On the stick of a side, of the last step.
  const StickForce& of(fencing::Side side) const { return forces_[index_of(side)]; }
  /// Silences that began on either side since the start.
  std::uint32_t silences() const { return ramps_[0].silences() + ramps_[1].silences(); }
  /// Steps since the start with a side that was silent.
  std::uint32_t stale_steps() const { return stale_steps_; }

 private:
  void leap(std::uint32_t exchange);
  void take(fencing::Side side, const Vec2<float>& demanded, bool fresh);
  StickForce force_of(const Vec2<float>& demanded, const haptics::ForceRamp& ramp) const;

  float full_scale_ = ForceSettings().full_scale;
  std::array<haptics::HandForce<float>, 2> hands_;
  std::array<haptics::ForceRamp, 2> ramps_;
  std::array<StickForce, 2> forces_;
  std::uint32_t stale_steps_ = 0;
  std::uint32_t exchange_ = 1;  ///< of the bout, that was seen last
};

}  // namespace batuta::haptics
