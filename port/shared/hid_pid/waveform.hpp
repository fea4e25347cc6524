// SPDX-License-Identifier: MIT
#pragma once
// The shape of a periodic effect, and the envelope that lets it rise and fall. Numbers without a
// unit: 1 is the full force.

#include "shared/hid_pid/reports.hpp"

namespace batuta::pid {

/// A periodic effect's shape, -1 ... 1, at a place in its period. Sine: 0 and rising at 0. Square:
/// 1 in the first half. Triangle and sawtooth up: -1 at 0, rising. Sawtooth down: 1 at 0. Source:
/// the drawings of SDL_HapticPeriodic; PID 1.0 names the shapes only.
/// @param turn  place in the period, 0 ... 1
/// @returns 0 for a type that is not periodic
float waveform(EffectType type, float turn);

/// How loud an effect is at a time of its own: from the attack's level to `sustain` in the attack's
/// time, and from there to the fade's level in the fade's time, which ends with the effect. Where
/// the two overlap, the fade begins from what the attack has reached: there is no jump. Source:
/// PID 1.0, set envelope report; levels are without sign and relative to the offset.
struct Envelope {
  std::uint16_t attack_level = 0;  ///< of kFullLevel
  std::uint16_t fade_level = 0;
  std::uint16_t attack_ms = 0;  ///< 0: no attack
  std::uint16_t fade_ms = 0;    ///< 0: no fade

  /// @param sustain      >= 0
  /// @param elapsed_us   since the effect began to sound
  /// @param duration_ms  of the effect, elapsed_us <= 1000 duration_ms; 0: it has no end, and so no
  ///                     fade
  float level(float sustain, std::uint32_t elapsed_us, std::uint32_t duration_ms) const;
};

}  // namespace batuta::pid
