// SPDX-License-Identifier: MIT

#include "programs/live/effects.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batuta::host {
namespace {

constexpr float kMaxLevel = std::numeric_limits<std::int16_t>::max();
constexpr float kMaxMagnitude = std::numeric_limits<std::uint16_t>::max();

float clamped(float share, float low) {
  return std::isnan(share) ? 0.0F : std::clamp(share, low, 1.0F);
}

ConditionNumbers numbers(float coefficient, float centre) {
  const std::int16_t level = level_of(std::max(coefficient, 0.0F));
  if (level == 0) return {};
  return {std::numeric_limits<std::uint16_t>::max(), level, level_of(centre)};
}

}  // namespace

std::int16_t level_of(float share) {
  return static_cast<std::int16_t>(std::lround(clamped(share, -1.0F) * kMaxLevel));
}

std::uint16_t magnitude_of(float share) {
  return static_cast<std::uint16_t>(std::lround(clamped(share, 0.0F) * kMaxMagnitude));
}

float size_of(float x, float y) {
  return std::max(std::abs(x), std::abs(y));
}

PolarForce polar_force(float x, float y) {
  const std::int16_t level = level_of(size_of(x, y));
  if (level == 0) return {};
  // From down, by way of left: (0, -1) is 0, (-1, 0) a quarter, (0, 1) half a turn.
  constexpr double kTurn = 65536;
  const double pi = std::acos(-1.0);
  const double angle = std::atan2(-static_cast<double>(x), -static_cast<double>(y));
  const long direction = std::lround(angle / (2 * pi) * kTurn);
  return {level, static_cast<std::uint16_t>(direction)};  // modulo a turn
}

ConditionPair condition_numbers(const Condition& condition) {
  return {numbers(condition.coefficient, condition.centre_x),
          numbers(condition.coefficient, -condition.centre_y)};
}

Rumble rumble_of(const Feel& feel) {
  const float now = size_of(feel.x, feel.y);
  const float hardest = std::max(feel.blow, now);
  return {magnitude_of(hardest), magnitude_of(hardest - now)};
}

}  // namespace batuta::host
