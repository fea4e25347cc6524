// SPDX-License-Identifier: MIT

#include "shared/hid_pid/waveform.hpp"

#include "batuta/mechanics/trigonometry.hpp"
#include "shared/hid_pid/direction.hpp"

namespace batuta::pid {
namespace {

/// From `from` to `to` in `span_us`. @pre at_us <= span_us, 0 < span_us
float between(float from, float to, std::uint32_t at_us, std::uint32_t span_us) {
  const float share = static_cast<float>(at_us) / static_cast<float>(span_us);
  return from + (to - from) * share;
}

}  // namespace

float waveform(EffectType type, float turn) {
  switch (type) {
    case EffectType::kSquare:
      return turn < 0.5F ? 1.0F : -1.0F;
    case EffectType::kSine:
      return batuta::detail::sin_cos(turn * kRadiansPerTurn).sin;
    case EffectType::kTriangle:
      return turn < 0.5F ? 4.0F * turn - 1.0F : 3.0F - 4.0F * turn;
    case EffectType::kSawtoothUp:
      return 2.0F * turn - 1.0F;
    case EffectType::kSawtoothDown:
      return 1.0F - 2.0F * turn;
    default:
      return 0.0F;
  }
}

float Envelope::level(float sustain, std::uint32_t elapsed_us, std::uint32_t duration_ms) const {
  constexpr auto kFull = static_cast<float>(kFullLevel);
  float level = sustain;
  const std::uint32_t attack_us = attack_ms * 1000U;
  if (elapsed_us < attack_us) {
    level = between(static_cast<float>(attack_level) / kFull, sustain, elapsed_us, attack_us);
  }
  const std::uint32_t fade_us = fade_ms * 1000U;
  const std::uint32_t left_us = duration_ms * 1000U - elapsed_us;
  if (duration_ms > 0 && left_us < fade_us) {
    level = between(static_cast<float>(fade_level) / kFull, level, left_us, fade_us);
  }
  return level;
}

}  // namespace batuta::pid
