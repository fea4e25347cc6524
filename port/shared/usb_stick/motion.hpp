// SPDX-License-Identifier: MIT
#pragma once
// How fast the stick moves, from samples of where it is: dampers and friction need it. See
// usb_stick.md for the time constant.

#include "batuta/port/input.hpp"
#include "shared/hid_pid/device.hpp"

namespace batuta::usb {

/// Of the low pass over differences, s.
inline constexpr float kMotionTimeConstant = 0.004F;
/// Samples further apart than this tell nothing of a velocity, us.
inline constexpr std::int32_t kLongestGapUs = 20000;

class Motion {
 public:
  /// A new sample. One that is not later than the last, or more than kLongestGapUs, is a new
  /// beginning at rest. Bound: no loop.
  void take(const InputSample& sample);

  const pid::Stick& stick() const { return stick_; }

 private:
  pid::Stick stick_;
  Microseconds last_ = 0;
  bool begun_ = false;
};

}  // namespace batuta::usb
