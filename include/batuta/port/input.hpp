// SPDX-License-Identifier: MIT
#pragma once
// Motion of a stick as the library wants it: whole samples, time-stamped, the latest one
// wins. A device speaks in single axis events; a sync mark says that a consistent set is complete
// (the Linux input stack and Zephyr do the same). A port turns events into samples with
// SampleBuilder and hands them out by read().

#include "batuta/core/status.hpp"
#include "batuta/port/clock.hpp"

namespace batuta {

/// One consistent state of the device.
struct InputSample {
  Microseconds time = 0;  ///< when the device was in this state
  float x = 0;            ///< stick position, -1 left ... 1 right
  float y = 0;            ///< stick position, -1 down ... 1 up
  /// Second pair of axes, -1 left ... 1 right: kept for what footwork may want of it; nothing yet
  float feet_x = 0;
  /// The same, -1 down ... 1 up: the feet go back or forward. A device with one pair of axes leaves
  /// both zero.
  float feet_y = 0;
  std::uint32_t buttons = 0;  ///< bit i: button i is pressed
  /// Counts samples of this device; a gap tells how many were overwritten unread
  std::uint32_t sequence = 0;
};

/// A source of samples. Validation is done once, here; a port implements do_read() only.
class InputDevice {
 public:
  /// The latest sample that is not newer than `now`. Never blocks, never waits for the device.
  /// @returns kOk: `sample` is new | kUnavailable: nothing new since the last call, or the device
  ///   is gone; `sample` is unchanged | kInvalidArgument: the device delivered a position that is
  ///   not finite or outside [-1, 1]; `sample` is unchanged
  Status read(Microseconds now, InputSample& sample);

 protected:
  InputDevice() = default;
  ~InputDevice() = default;
  /// Copied only with what derives from it.
  InputDevice(const InputDevice&) = default;
  /// Copied only with what derives from it.
  InputDevice& operator=(const InputDevice&) = default;

 private:
  virtual Status do_read(Microseconds now, InputSample& sample) = 0;
};

/// True where the last sample is older than `limit_us`, or appears to lie in the future by more
/// than that. @pre limit_us >= 0; the sample is younger than 2^32 us - limit_us: its age is known
/// modulo 2^32 us, and after 71.6 minutes it would look new. Who may be without one for so long
/// asks every 35 minutes at least, and holds to a `true` until the next one.
constexpr bool is_stale(const InputSample& last, Microseconds now, std::int32_t limit_us) {
  const std::int32_t age_us = elapsed_us(last.time, now);
  return age_us > limit_us || age_us < -limit_us;
}

}  // namespace batuta
