// SPDX-License-Identifier: MIT
#pragma once
// A bout of the library's two fencers with the forces on their sticks, one step at a time: what the
// device computes, and what a host computes to hold against it. The same samples give the same
// bits.

#include "batuta/haptics/stick_forces.hpp"

namespace batuta::haptics {

/// Of a bout and of the forces on its sticks.
struct BoutSettings {
  std::int32_t step_us = 1000;  ///< length of a step, us, as DuelSettings::step_us
  std::int32_t touches = 1;     ///< to which the bout goes, as DuelSettings::touches
  float distance = fencing::Salle<float>().distance;  ///< on guard, m, as Salle::distance
  ForceSettings force;                                ///< on both sticks
};

/// @tparam DuelT  the duel of either search; a firmware has the certified one
template <class DuelT>
class SteppedBoutOf {
 public:
  /// Puts the fencers on guard, in a bout that remembers nothing of another one.
  /// @returns kOk | kInvalidArgument (out of range; the last bout, if any, goes on)
  Status start(const BoutSettings& settings);

  /// One step. @param left, right  new samples, or null
  /// @returns kOk | kUnavailable (the bout is over; nothing changed) | kInvalidArgument (not
  ///   started)
  /// Bound: one Duel::step() and the forces of its events.
  Status step(const InputSample* left, const InputSample* right);

  /// Puts a state that was kept into the duel. The forces begin anew: they follow from the duel and
  /// its samples, and are not kept, nor are their settings.
  /// @param force  on both sticks, as in start()
  /// @param put  called once with the duel, to be changed; returns whether it was
  /// @returns kOk | kInvalidArgument (`force` is out of range; put is not called)
  template <class Put>
  Status restore(const ForceSettings& force, const Put& put) {
    if (validate(force) != Status::kOk) return Status::kInvalidArgument;
    if (put(duel_)) begin_forces(force);
    return Status::kOk;
  }

  /// As it is after the last step.
  const DuelT& duel() const { return duel_; }
  /// Of the last step.
  const StickForces& forces() const { return forces_; }
  /// Made since start().
  std::uint32_t steps() const { return duel_.steps(); }
  /// No step will be made any more.
  bool is_over() const { return duel_.bout().is_over(); }
  /// The sample that the last step was made with, or null.
  const InputSample* used(fencing::Side side) const {
    return fresh_[index_of(side)] ? &samples_[index_of(side)] : nullptr;
  }
  /// The last step had a sample that the stick took for a sign of life: SampleUse::kUsed or
  /// kRestart. One with an old time stamp is none, however often it comes.
  bool is_alive(fencing::Side side) const { return alive_[index_of(side)]; }

 private:
  void begin_forces(const ForceSettings& settings);
  void take(fencing::Side side, const InputSample* sample);

  DuelT duel_;
  StickForces forces_;
  std::array<InputSample, 2> samples_{};
  std::array<bool, 2> fresh_{};
  std::array<bool, 2> alive_{};
  std::array<std::uint32_t, 2> believed_{};  ///< StickReport::used after the last step
};

template <class DuelT>
Status SteppedBoutOf<DuelT>::start(const BoutSettings& settings) {
  auto duel = fencing::duel_settings<typename DuelT::StatedScene>();
  duel.step_us = settings.step_us;
  duel.touches = settings.touches;
  duel.salle.distance = settings.distance;
  if (validate(settings.force) != Status::kOk) return Status::kInvalidArgument;
  const Status status =
      duel_.configure(duel, fencing::first_fencer<float>, fencing::second_fencer<float>);
  if (status == Status::kOk) begin_forces(settings.force);
  return status;
}

/// @pre settings are valid
template <class DuelT>
void SteppedBoutOf<DuelT>::begin_forces(const ForceSettings& settings) {
  (void)forces_.configure(settings);
  fresh_ = {};
  alive_ = {};
  for (const fencing::Side side : {fencing::Side::kLeft, fencing::Side::kRight}) {  // Bound: 2
    believed_[index_of(side)] = duel_.stick(side).report().used;
  }
}

template <class DuelT>
Status SteppedBoutOf<DuelT>::step(const InputSample* left, const InputSample* right) {
  const Status status = duel_.step(left, right);
  if (status != Status::kOk) return status;
  take(fencing::Side::kLeft, left);
  take(fencing::Side::kRight, right);
  forces_.advance(duel_, alive_);
  return Status::kOk;
}

template <class DuelT>
void SteppedBoutOf<DuelT>::take(fencing::Side side, const InputSample* sample) {
  fresh_[index_of(side)] = sample != nullptr;
  if (sample != nullptr) samples_[index_of(side)] = *sample;
  const std::uint32_t believed = duel_.stick(side).report().used;
  alive_[index_of(side)] = believed != believed_[index_of(side)];
  believed_[index_of(side)] = believed;
}

/// Of the library's two fencers, by the search that misses nothing.
using SteppedBout = SteppedBoutOf<fencing::Duel<>>;

}  // namespace batuta::haptics
