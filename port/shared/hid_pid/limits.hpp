// SPDX-License-Identifier: MIT
#pragma once
// The ranges of what host and device tell each other. The report descriptor announces them and the
// parser holds every report to them, both from here.

#include <cstdint>

namespace batuta::pid {

/// Levels, magnitudes, coefficients, saturations and offsets: this is the whole, 1.
inline constexpr int kFullLevel = 10000;
/// Of the whole.
constexpr float share_of(int level) {
  return static_cast<float>(level) / static_cast<float>(kFullLevel);
}
/// Gains: this is 1.
inline constexpr int kFullGain = 255;
/// Directions and phases: this is a full turn, so that a step is 0.02 degrees. Divisible by four: a
/// host that scales a 16-bit angle down to this range and cuts off, as hid-pidff does, still hits
/// the four winds exactly. Below 2^15: its product with a 16-bit angle stays in 32 bits, which
/// hid-pidff does not look after.
inline constexpr int kFullTurn = 18000;
/// The longest time that has an end, ms.
inline constexpr int kLongestTime = 32767;
/// A duration that has no end; so has 0.
inline constexpr std::uint16_t kEndless = 0xFFFF;
/// Loops that have no end. 0 is taken for 1: an effect that is started is played.
inline constexpr std::uint8_t kEndlessLoops = 255;
inline constexpr int kEffectTypes = 11;
/// Stick positions of the joystick report, right and towards the user.
inline constexpr int kFullStick = 32767;
inline constexpr int kButtons = 16;

/// Fewest and most effect blocks of a device: hid-pidff asks again and again for a pool of less
/// than two, and has 64 places.
inline constexpr int kFewestBlocks = 2;
inline constexpr int kMostBlocks = 64;

}  // namespace batuta::pid
