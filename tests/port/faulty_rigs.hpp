// SPDX-License-Identifier: MIT
#pragma once
// Devices that break one rule of the contract each, as rigs: what the checks are there to find.

#include <cstdlib>

#include "batuta/port/clock.hpp"
#include "batuta/port/force.hpp"
#include "batuta/port/input.hpp"

namespace batuta::test {

enum class Fault : std::uint8_t {
  kNone,
  kSilent,        ///< has no samples
  kOutOfRange,    ///< x beyond 1
  kTooHigh,       ///< y beyond 1
  kFuture,        ///< a sample's time is later than the read
  kOlder,         ///< times go back
  kUncounted,     ///< samples have all the same number
  kNewTwice,      ///< the same sample is handed out again
  kAllocates,     ///< asks for memory
  kGoesBack,      ///< a clock that does
  kRefuses,       ///< a motor that takes no negative force
  kGoneAfterOff,  ///< a motor that takes nothing after off()
  kFlaky          ///< a motor that takes every second command
};

inline void allocate() {
  void* volatile block = std::malloc(16);
  std::free(block);
}

/// Has a new sample every third millisecond.
template <Fault kFault>
class TickingStick {
 public:
  static constexpr bool kHasSamples = true;
  InputDevice& device() { return device_; }
  Microseconds next() { return now_ += 1000; }

 private:
  class Device final : public InputDevice {
    Status do_read(Microseconds now, InputSample& sample) override {
      const std::uint32_t sequence = now / 3000;
      if (kFault == Fault::kAllocates) allocate();
      const bool is_new = sequence != last_ || kFault == Fault::kNewTwice;
      if (!is_new || kFault == Fault::kSilent) return Status::kUnavailable;
      last_ = sequence;
      sample.time = sequence * 3000;
      sample.x = static_cast<float>(sequence % 3) - 1;
      sample.y = -sample.x;
      sample.sequence = sequence;
      spoil(sample, now);
      return Status::kOk;
    }

    static void spoil(InputSample& sample, Microseconds now) {
      if (kFault == Fault::kOutOfRange) sample.x *= 1.01F;
      if (kFault == Fault::kTooHigh) sample.y *= 1.01F;
      if (kFault == Fault::kFuture) sample.time = now + 1;
      if (kFault == Fault::kOlder && sample.sequence % 2 == 0) sample.time -= 6000;
      if (kFault == Fault::kUncounted) sample.sequence = 1;
    }

    std::uint32_t last_ = 0;
  };

  Device device_;
  Microseconds now_ = 6000;
};

template <Fault kFault>
class CountingClock {
 public:
  Clock& clock() { return clock_; }

 private:
  class Device final : public Clock {
    Microseconds do_now() override {
      if (kFault == Fault::kAllocates) allocate();
      ++now_;
      return kFault == Fault::kGoesBack && now_ % 100 == 0 ? now_ - 5 : now_;
    }
    Microseconds now_ = 0xFFFFFF00U;  // wraps soon
  };

  Device clock_;
};

template <Fault kFault>
class Lamp {
 public:
  ForceDevice& device() { return device_; }

 private:
  class Device final : public ForceDevice {
    Status do_write(const ForceCommand& command) override {
      if (kFault == Fault::kAllocates) allocate();
      const bool is_refused = kFault == Fault::kRefuses && command.x < 0;
      const bool is_off = command.x == 0 && command.y == 0;
      is_gone_ = is_gone_ || (kFault == Fault::kGoneAfterOff && shone_ && is_off);
      if (kFault == Fault::kFlaky) is_gone_ = !is_gone_;
      shone_ = shone_ || !is_off;
      if (is_refused) return Status::kInvalidArgument;
      return is_gone_ ? Status::kUnavailable : Status::kOk;
    }
    bool shone_ = false;
    bool is_gone_ = false;
  };

  Device device_;
};

}  // namespace batuta::test
