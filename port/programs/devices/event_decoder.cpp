// SPDX-License-Identifier: MIT

#include "programs/devices/event_decoder.hpp"

#include <linux/input.h>

#include <limits>

namespace batuta::host {
namespace {

/// Mice, sticks, pads and pens number their buttons in blocks of 16; fingers on a pad come as keys
/// among them.
int button_index(std::uint16_t code) {
  if (code < BTN_MISC || code > BTN_GEAR_UP) return -1;
  return code & 0x0F;
}

}  // namespace

EventDecoder::EventDecoder(const MotionAxes& axes) : axes_(axes) {
  if (builder_.configure(axes.x, axes.y) != Status::kOk) BATUTA_INVARIANT(false);
  if (!axes.feet) return;
  if (builder_.configure_feet(axes.feet->x, axes.feet->y) != Status::kOk) BATUTA_INVARIANT(false);
}

Result<InputSample> EventDecoder::decode(const DeviceEvent& event, Microseconds time) {
  if (event.type == EV_SYN) return decode_mark(event.code, time);
  if (event.type == EV_KEY) {
    // Not a button: nothing that a sword knows.
    static_cast<void>(builder_.button(button_index(event.code), event.value != 0));
  } else if (axes_.fingers) {
    decode_finger(event);
  } else {
    decode_motion(event);
  }
  return failure<InputSample>(Status::kUnavailable);
}

Result<InputSample> EventDecoder::decode_mark(std::uint16_t code, Microseconds time) {
  if (code == SYN_DROPPED) builder_.lost();
  if (code == SYN_MT_REPORT) {
    fingers_in_turn_ = true;
    if (finger_ < std::numeric_limits<int>::max()) ++finger_;  // a slot may have any number
  }
  if (code != SYN_REPORT) return failure<InputSample>(Status::kUnavailable);
  if (fingers_in_turn_) finger_ = 0;
  return builder_.sync(time);
}

void EventDecoder::decode_finger(const DeviceEvent& event) {
  if (event.type != EV_ABS) return;
  if (event.code == ABS_MT_SLOT) finger_ = event.value;
  const bool lifted = event.code == ABS_MT_TRACKING_ID && event.value < 0;
  if (lifted && finger_ == leading_finger_) leading_finger_ = -1;
  const bool motion = event.code == axes_.code_x || event.code == axes_.code_y;
  if (motion && leading_finger_ < 0) leading_finger_ = finger_;
  if (finger_ == leading_finger_) decode_motion(event);
}

void EventDecoder::decode_motion(const DeviceEvent& event) {
  if (event.type != axes_.type) return;
  if (event.code == axes_.code_x) builder_.axis(Axis::kX, event.value);
  if (event.code == axes_.code_y) builder_.axis(Axis::kY, event.value);
  if (!axes_.feet) return;
  if (event.code == axes_.feet->code_x) builder_.axis(Axis::kFeetX, event.value);
  if (event.code == axes_.feet->code_y) builder_.axis(Axis::kFeetY, event.value);
}

}  // namespace batuta::host
