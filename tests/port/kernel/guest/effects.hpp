// SPDX-License-Identifier: MIT
#pragma once
// Effects as a game fills them in, new and without end but for what is said.

#include <linux/input.h>

namespace guest {

constexpr unsigned kDown = 0;
constexpr unsigned kLeft = 0x4000;
constexpr unsigned kUp = 0x8000;
constexpr unsigned kRight = 0xC000;

inline ff_effect effect(int type, unsigned direction, unsigned milliseconds = 0) {
  ff_effect e{};
  e.type = static_cast<unsigned short>(type);
  e.id = -1;
  e.direction = static_cast<unsigned short>(direction);
  e.replay.length = static_cast<unsigned short>(milliseconds);
  return e;
}

inline ff_effect constant(int size, unsigned direction, unsigned milliseconds = 0) {
  ff_effect e = effect(FF_CONSTANT, direction, milliseconds);
  e.u.constant.level = static_cast<short>(size);
  return e;
}

inline ff_effect periodic(int waveform, int magnitude, unsigned direction, unsigned period) {
  ff_effect e = effect(FF_PERIODIC, direction);
  e.u.periodic.waveform = static_cast<unsigned short>(waveform);
  e.u.periodic.magnitude = static_cast<short>(magnitude);
  e.u.periodic.period = static_cast<unsigned short>(period);
  return e;
}

/// The same on both axes.
inline ff_effect conditional(int type, const ff_condition_effect& condition) {
  ff_effect e = effect(type, kDown);
  e.u.condition[0] = condition;
  e.u.condition[1] = condition;
  return e;
}

}  // namespace guest
