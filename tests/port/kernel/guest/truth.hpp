// SPDX-License-Identifier: MIT
#pragma once
// What a force has to be, from the kernel's Documentation/input/ff.rst and
// include/uapi/linux/input.h: levels are shares of 0x7FFF, saturations and dead bands of 0xFFFF; a
// full turn is 0x10000, and a direction is where the force points to: 0 down, 0x4000 left, 0x8000
// up, 0xC000 right. How waves begin stands in neither: SDL_haptic.h draws them. Nothing of batuta
// is used here.

#include <linux/input.h>

#include <algorithm>
#include <cmath>

#include "link.hpp"

namespace guest {

constexpr double kTurn = 2 * 3.14159265358979323846;

inline double level(int value) {
  return value / 32767.0;
}

/// Of a size, in a direction.
inline Force pointing(double size, unsigned direction) {
  const double angle = kTurn * direction / 65536.0;
  return {-size * std::sin(angle), -size * std::cos(angle)};
}

/// A wave, `turn` periods from its start.
inline double wave(int waveform, double turn) {
  turn -= std::floor(turn);
  switch (waveform) {
    case FF_SINE:
      return std::sin(kTurn * turn);
    case FF_SQUARE:
      return turn < 0.5 ? 1 : -1;
    case FF_TRIANGLE:
      return 1 - 4 * std::fabs(turn - 0.5);
    case FF_SAW_UP:
      return 2 * turn - 1;
    default:  // FF_SAW_DOWN
      return 1 - 2 * turn;
  }
}

/// What a condition does along an axis of the kernel's: `at` is the position, or how fast it goes,
/// as a share. It pushes back.
inline double condition(const ff_condition_effect& c, double at) {
  const double beyond = at - level(c.center);
  const double dead = c.deadband / 65535.0;
  if (std::fabs(beyond) <= dead) return 0;
  const bool right = beyond > 0;
  const double most = (right ? c.right_saturation : c.left_saturation) / 65535.0;
  const double size =
      level(right ? c.right_coeff : c.left_coeff) * (beyond - (right ? dead : -dead));
  return -std::clamp(size, -most, most);
}

/// On both axes; the kernel's Y grows towards the user.
inline Force conditions(const ff_effect& effect, const Force& at) {
  return {condition(effect.u.condition[0], at.x), -condition(effect.u.condition[1], -at.y)};
}

}  // namespace guest
