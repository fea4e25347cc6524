// SPDX-License-Identifier: MIT
#pragma once
// A force-feedback stick as its USB host knows it: takes the host's reports, keeps its effects in a
// fixed pool, and says which force they ask for. What it says is a demand: it goes to the haptics
// output stage, which limits it, and not to a motor.

#include <array>

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"
#include "batuta/port/clock.hpp"
#include "batuta/port/input.hpp"
#include "shared/hid_pid/effect.hpp"
#include "shared/hid_pid/report_descriptor.hpp"

namespace batuta::pid {

/// The stick at one time: x right, y up, 1 is the stop.
struct Stick {
  Vec2<float> position{0.0F, 0.0F};      ///< -1 ... 1; what is beyond counts as at the stop
  Vec2<float> velocity{0.0F, 0.0F};      ///< 1/s
  Vec2<float> acceleration{0.0F, 0.0F};  ///< 1/s^2; only for inertia
};

/// What a device takes for the full scale of a condition. PID leaves it to the device.
struct Scales {
  float velocity = 10;          ///< 1/s: from stop to stop in 0.2 s
  float acceleration = 100;     ///< 1/s^2: to that velocity in 0.1 s
  float friction_knee = 0.05F;  ///< share of the velocity at which friction has its full size, > 0
};

/// By the numbers of HID 1.11, section 7.2.1.
enum class ReportType : std::uint8_t { kInput = 1, kOutput = 2, kFeature = 3 };

/// What became of a report.
enum class Verdict : std::uint8_t {
  kTaken,
  kUnknown,      ///< no report of this type and number goes to the device
  kLength,       ///< too short or too long
  kRange,        ///< a field is out of its range
  kNoBlock,      ///< there is no such block, or there is no effect in it
  kOtherEffect,  ///< the parameters of another type of effect
  kFull,         ///< no block is free
};
inline constexpr int kVerdicts = 7;

/// Sums since the start, modulo 2^32.
struct Counters {
  std::array<std::uint32_t, kVerdicts> reports{};  ///< by Verdict
  std::uint32_t bad_sticks = 0;                    ///< not finite: taken for one at rest
  std::uint32_t clipped = 0;                       ///< forces whose sum was beyond the range
  std::uint32_t padded = 0;                        ///< reports taken that were longer, by zeros

  std::uint32_t count(Verdict verdict) const { return reports[static_cast<std::size_t>(verdict)]; }
  std::uint32_t refused() const;
};

/// Everything but the blocks themselves. From one context at a time: where force() runs in an
/// interrupt handler, that interrupt is masked around receive(), answer() and next_state().
class DeviceBase {
 public:
  DeviceBase(const DeviceBase&) = delete;
  DeviceBase& operator=(const DeviceBase&) = delete;
  DeviceBase(DeviceBase&&) = delete;
  DeviceBase& operator=(DeviceBase&&) = delete;

  /// Takes an output report, or a feature report that the host sets. A refused one is counted and
  /// changes nothing; but after a refused CreateNewEffect the answer about it says so.
  /// @param bytes  what follows the id; `size` of them. Zeros behind the report are left out, and
  ///   counted: Windows sends each report as long as the longest.
  /// @returns kOk | kInvalidArgument: unknown, of a wrong length, out of range, or not for this
  /// type
  ///   of effect | kStaleHandle: there is no effect in this block | kPoolFull: no block is free
  /// Bound: the blocks. Allocates: never.
  Status receive(ReportType type, std::uint8_t id, const std::uint8_t* bytes, int size);
  /// Writes a feature report that the host gets, without its id: BlockLoad, Pool, or the last
  /// CreateNewEffect.
  /// @returns its length | 0: there is no such report, or not enough room
  /// Bound: the blocks. Allocates: never.
  int answer(std::uint8_t id, std::uint8_t* bytes, int room) const;
  /// The same of an input report: the joystick as it was told, or the device's flags with the first
  /// block. HID 1.11, 7.2.1: a device must answer. Bound: no loop. Allocates: never.
  int answer_input(std::uint8_t id, std::uint8_t* bytes, int room) const;
  /// The next input report about what has changed and has not been told: call it until it has none.
  /// @returns whether `report` is one. Bound: the blocks.
  bool next_state(PidState& report);

  /// The sum of the effects: shares of the full force, x right and y up, each -1 ... 1. Zero while
  /// paused or with the actuators disabled. Time that goes backwards stands still.
  /// @param now  at most 35 minutes after the last call; any time before the first
  /// Bound: the blocks, at most one sine each.
  Vec2<float> force(const Stick& stick, Microseconds now);

  /// What the host's DeviceControl reset does: frees all blocks, ends a pause, enables the
  /// actuators. The gain stays: hid-pidff resets before the first effect of a game, after the gain
  /// was set. Bound: the blocks.
  void reset();
  /// For a host that has gone, unmounted: a reset, and the gain is full again. Bound: the blocks.
  void forget_host();
  /// Stops what plays, and keeps the blocks: for a host that sleeps. It knows its effects by their
  /// blocks when it wakes, and is not told of a reset. Bound: the blocks.
  void silence() { stop_all(); }
  /// For PidState only; it is the output stage that switches a motor off.
  void tell_actuator(bool powered);
  /// Where the stick is: what a host gets that asks for the input report.
  void tell_stick(const Joystick& report) { stick_ = report; }

  int blocks() const { return blocks_; }
  int playing() const;
  const Counters& counters() const { return counters_; }

 protected:
  DeviceBase(Effect* effects, int blocks, const Scales& scales);
  ~DeviceBase() = default;

 private:
  template <class Report>
  Verdict take(const std::uint8_t* bytes, int size);
  Verdict judge_output(ReportId id, const std::uint8_t* bytes, int size);
  Verdict judge_feature(ReportId id, const std::uint8_t* bytes, int size);
  template <class Report>
  Verdict apply(const Report& report);
  Verdict apply(const EffectOperation& report);
  Verdict apply(const BlockFree& report);
  Verdict apply(const DeviceControl& report);
  Verdict apply(const DeviceGain& report);
  Verdict apply(const CreateNewEffect& report);

  Effect* find(std::uint8_t block);
  PidState state_of(int index) const;
  int free_blocks() const;
  void stop_all();
  std::uint32_t step_to(Microseconds now);
  Metrics metrics_of(const Stick& stick);
  Vec2<float> sum_of(const Metrics& metrics, std::uint32_t step_us);

  Effect* effects_;
  int blocks_;
  Scales scales_;
  Counters counters_;
  std::uint64_t told_playing_ = 0;  ///< bit i: the host was told that block i + 1 plays
  Microseconds last_ = 0;
  bool paused_ = false;
  bool enabled_ = true;
  bool told_flags_ = true;
  bool powered_ = false;
  std::uint8_t gain_ = kFullGain;
  std::uint8_t loaded_block_ = 0;
  LoadStatus load_status_ = LoadStatus::kError;
  CreateNewEffect created_;  ///< the last one that was taken
  Joystick stick_;
};

/// @tparam kBlocks  effects at the same time, kFewestBlocks ... kMostBlocks
template <int kBlocks = 16>
class Device final : public DeviceBase {
 public:
  static_assert(kBlocks >= kFewestBlocks && kBlocks <= kMostBlocks, "see limits.hpp");
  explicit Device(const Scales& scales = {}) : DeviceBase(effects_, kBlocks, scales) {}

  /// What the host reads of this very device.
  static constexpr const auto& report_descriptor() { return kReportDescriptor<kBlocks>; }

 private:
  Effect effects_[kBlocks];
};

/// The input report of a sample; the buttons beyond the sixteenth have no room.
/// @pre x and y in [-1, 1], as InputDevice::read() has it
Joystick joystick_of(const InputSample& sample);

}  // namespace batuta::pid
