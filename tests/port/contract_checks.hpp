// SPDX-License-Identifier: MIT
#pragma once
// What every device of every port must do, whoever counts the verdicts: GoogleTest on a host
// (contract_suite.hpp), a line for each on a board (contract_on_board.hpp). A port describes its
// devices by rigs, of which each check makes its own:
//   struct MyStick {                                     // for InputChecks
//     static constexpr bool kHasSamples = true;          // false: a device that never has any
//     batuta::InputDevice& device();
//     batuta::Microseconds next();                       // makes time pass, or waits for it, and
//     tells it; samples may have come
//   };
//   struct MyClock { batuta::Clock& clock(); };          // for ClockChecks
//   struct MyMotor { batuta::ForceDevice& device(); };   // for ForceChecks

#include <limits>

#include "batuta/port/clock.hpp"
#include "batuta/port/force.hpp"
#include "batuta/port/input.hpp"
#include "heap_trap.hpp"
#include "plain_force.hpp"

namespace batuta::test {

inline constexpr int kReads = 1000;
/// So many that a timer's period of a millisecond ends among them, on a fast part as well.
inline constexpr int kTimes = 100'000;

inline bool same(const InputSample& a, const InputSample& b) {
  return a.time == b.time && a.x == b.x && a.y == b.y && a.buttons == b.buttons &&
         a.sequence == b.sequence;
}

/// Where verdicts go.
class Verdicts {
 public:
  virtual void that(bool holds, const char* what) = 0;

 protected:
  ~Verdicts() = default;
};

template <class Rig>
class InputChecks {
 public:
  explicit InputChecks(Verdicts& check) : check_(check) {}

  void samples_are_in_range_and_not_from_the_future() {
    for_each_sample([this](Microseconds now, const InputSample& sample) {
      check_.that(!is_later(sample.time, now), "a sample is not from the future");
    });
  }

  void samples_are_counted_and_in_order() {
    InputSample last;
    bool first = true;
    for_each_sample([&](Microseconds, const InputSample& sample) {
      if (!first) {
        const auto more = static_cast<std::int32_t>(sample.sequence - last.sequence);
        check_.that(elapsed_us(last.time, sample.time) >= 0, "a sample is not older than the last");
        check_.that(more > 0, "a sample's number is higher than the last one's");
      }
      first = false;
      last = sample;
    });
  }

  void same_time_is_new_once() {
    for_each_sample([this](Microseconds now, const InputSample&) {
      InputSample again;
      check_.that(rig_.device().read(now, again) == Status::kUnavailable,
                  "at the time of the last read nothing is new");
    });
  }

  void nothing_new_leaves_the_sample() {
    InputSample marked;
    marked.time = 77;
    marked.x = 0.25F;
    marked.y = -0.75F;
    marked.buttons = 5;
    marked.sequence = 99;
    int unavailable = 0;
    for (int i = 0; i < kReads; ++i) {
      const Microseconds now = rig_.next();
      InputSample drained;
      (void)rig_.device().read(now, drained);
      InputSample sample = marked;
      if (rig_.device().read(now, sample) == Status::kOk) continue;
      ++unavailable;
      check_.that(same(sample, marked), "where nothing is new the caller's sample is unchanged");
    }
    check_.that(unavailable > 0, "now and then nothing is new");
  }

  void reading_allocates_nothing() {
    InputSample sample;
    (void)rig_.device().read(rig_.next(), sample);
    int allocations = 0;
    for (int i = 0; i < kReads; ++i) {
      const Microseconds now = rig_.next();
      const HeapTrap trap;
      (void)rig_.device().read(now, sample);
      allocations += trap.allocations();
    }
    check_.that(allocations == 0, "a read allocates nothing");
  }

 private:
  /// Calls look(now, sample) with each sample of many reads; fails where it had none but should.
  template <class Look>
  void for_each_sample(const Look& look) {
    int samples = 0;
    for (int i = 0; i < kReads; ++i) {
      const Microseconds now = rig_.next();
      InputSample sample;
      const Status status = rig_.device().read(now, sample);
      check_.that(status != Status::kInvalidArgument, "axes are numbers within 1");
      if (status != Status::kOk) continue;
      ++samples;
      look(now, sample);
    }
    check_.that((samples > 0) == Rig::kHasSamples, "samples come as kHasSamples says");
  }

  Verdicts& check_;
  Rig rig_;
};

template <class Rig>
class ClockChecks {
 public:
  explicit ClockChecks(Verdicts& check) : check_(check) {}

  void now_never_goes_back_and_allocates_nothing() {
    const HeapTrap trap;
    Microseconds last = rig_.clock().now();
    int backwards = 0;
    for (int i = 0; i < kTimes; ++i) {
      const Microseconds now = rig_.clock().now();
      if (is_later(last, now)) ++backwards;
      last = now;
    }
    const int allocations = trap.allocations();
    check_.that(backwards == 0, "the time does not go back");
    check_.that(allocations == 0, "the clock allocates nothing");
  }

 private:
  Verdicts& check_;
  Rig rig_;
};

template <class Rig>
class ForceChecks {
 public:
  explicit ForceChecks(Verdicts& check) : check_(check) {}

  void valid_command_is_taken_or_the_device_is_gone() {
    for (const float x : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) {
      const Status status = write(x, -x);
      check_.that(status == Status::kOk || status == Status::kUnavailable,
                  "a command within the range is taken, or the device is gone");
    }
  }

  void invalid_command_is_refused_and_the_next_is_taken() {
    const Status valid = write(0, 0);
    const Status refused = valid == Status::kOk ? Status::kInvalidArgument : Status::kUnavailable;
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
      check_.that(write(bad, 0) == refused, "a command whose x is no number is refused");
      check_.that(write(0, bad) == refused, "a command whose y is no number is refused");
      check_.that(write(0, 0) == valid, "the command after it is answered as before");
    }
  }

  void off_is_taken_or_the_device_is_gone_and_the_next_command_is_taken() {
    const Status valid = write(1, -1);
    check_.that(rig_.device().off(0) == valid, "off is taken as a command is");
    check_.that(write(1, -1) == valid, "the command after it is answered as before");
  }

  void writing_allocates_nothing() {
    (void)write(0, 0);
    const HeapTrap trap;
    for (int i = 0; i < kReads; ++i) (void)write(0.25F, -0.25F);
    check_.that(trap.allocations() == 0, "a command allocates nothing");
  }

 private:
  Status write(float x, float y) { return force_.write({0, x, y}); }

  Verdicts& check_;
  Rig rig_;
  PlainForce force_{rig_.device()};
};

}  // namespace batuta::test
