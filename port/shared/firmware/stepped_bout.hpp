// SPDX-License-Identifier: MIT
#pragma once
// A bout of the library's two fencers with the forces on their sticks, one step at a time: what the
// device computes, and what a host computes to hold against it. The same samples give the same
// bits.

#include "shared/firmware/stick_forces.hpp"

namespace batuta::firmware {

struct BoutSettings {
  std::int32_t step_us = 1000;  ///< length of a step, us, as DuelSettings::step_us
  ForceSettings force;
};

class SteppedBout {
 public:
  /// Puts the fencers on guard, in a bout that remembers nothing of another one.
  /// @returns kOk | kInvalidArgument (out of range; the last bout, if any, goes on)
  Status start(const BoutSettings& settings);

  /// One step. @param left, right  new samples, or null
  /// @returns kOk | kUnavailable (the bout is over; nothing changed) | kInvalidArgument (not
  ///   started)
  /// Bound: one Duel::step() and the forces of its events.
  Status step(const InputSample* left, const InputSample* right);

  const DuelType& duel() const { return duel_; }
  const StickForces& forces() const { return forces_; }
  std::uint32_t steps() const { return duel_.steps(); }
  bool is_over() const { return duel_.bout().is_over(); }
  /// The sample that the last step was made with, or null.
  const InputSample* used(fencing::Side side) const {
    return fresh_[index_of(side)] ? &samples_[index_of(side)] : nullptr;
  }
  /// The last step had a sample that the stick took for a sign of life: SampleUse::kUsed or
  /// kRestart. One with an old time stamp is none, however often it comes.
  bool is_alive(fencing::Side side) const { return alive_[index_of(side)]; }

 private:
  void take(fencing::Side side, const InputSample* sample);

  DuelType duel_;
  StickForces forces_;
  std::array<InputSample, 2> samples_{};
  std::array<bool, 2> fresh_{};
  std::array<std::uint32_t, 2> believed_{};  ///< StickReport::used after the last step
  std::array<bool, 2> alive_{};
};

}  // namespace batuta::firmware
