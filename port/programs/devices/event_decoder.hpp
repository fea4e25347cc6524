// SPDX-License-Identifier: MIT
#pragma once
// Events of the Linux input stack, one after the other, into samples. Serves a replay; a live
// device speaks the same.

#include "batuta/core/assert.hpp"
#include "programs/devices/motion_axes.hpp"

namespace batuta::host {

class EventDecoder {
 public:
  explicit EventDecoder(const MotionAxes& axes);

  /// @param time  of the sample, if this event completes one
  /// @returns kOk: a sample | kUnavailable: not yet
  Result<InputSample> decode(const DeviceEvent& event, Microseconds time);

  std::uint32_t losses() const { return builder_.losses(); }

 private:
  Result<InputSample> decode_mark(std::uint16_t code, Microseconds time);
  void decode_finger(const DeviceEvent& event);
  void decode_motion(const DeviceEvent& event);

  MotionAxes axes_;
  SampleBuilder builder_;
  int finger_ = 0;                ///< the one that the events speak of
  int leading_finger_ = -1;       ///< the one that leads the sword: the first that moves; -1: none
  bool fingers_in_turn_ = false;  ///< the fingers follow each other, set apart by marks
};

}  // namespace batuta::host
