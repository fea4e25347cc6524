// SPDX-License-Identifier: MIT
#pragma once
// From shares of an actuator's range to the numbers of the effects that devices know: constant
// force, spring, damper, rumble. Pure functions; the integers are those of linux/input.h, which
// SDL's are too. Axes here: x to the right, y up (away from the user). Signs of the APIs: see
// linux_effects.hpp and sdl_effects.hpp.

#include <cstdint>

namespace batuta::host {

/// A force that depends on where the stick is (spring) or how fast it moves (damper), per axis.
struct Condition {
  float coefficient = 0;  ///< 0 ... 1 of what the device has; 0: there is none
  float centre_x = 0;     ///< of a spring: where it pulls to, -1 ... 1
  float centre_y = 0;
};

/// An effect ends by itself after so long: of a program that is stopped (Ctrl-Z, a debugger) the
/// kernel and the device keep what was told last. It is played again well before (ForcePump), so
/// that a thread that is late does not interrupt it; longer than the silence that is taken for one.
inline constexpr std::uint16_t kEffectLength_ms = 150;

/// What a hand is to feel.
struct Feel {
  float x = 0;     ///< share of the range, -1 ... 1, positive: pushes right
  float y = 0;     ///< positive: pushes up
  float blow = 0;  ///< the strongest force since the last effect was sent, 0 ... 1
  Condition spring;
  Condition damper;
};

/// Share to signed 16 bits, to the nearest; beyond +-1 is +-1; not a number is 0.
std::int16_t level_of(float share);
/// Share 0 ... 1 to 16 bits without a sign; below 0, and not a number, is 0.
std::uint16_t magnitude_of(float share);

/// Of one effect with a direction, for devices with room for one only.
struct PolarForce {
  std::int16_t level = 0;       ///< >= 0
  std::uint16_t direction = 0;  ///< where it pushes: 0 down, 0x4000 left, 0x8000 up, 0xC000 right
};
/// The level is the longer of the two coordinates: the range of an actuator is a square, not a
/// disc.
PolarForce polar_force(float x, float y);

/// The same law on both sides of the centre, without a dead band, up to the device's whole force.
struct ConditionNumbers {
  std::uint16_t saturation = 0;
  std::int16_t coefficient = 0;
  std::int16_t centre = 0;  ///< in the counts of an axis: to the right, and downwards
};
struct ConditionPair {
  ConditionNumbers x;
  ConditionNumbers y;
};
ConditionPair condition_numbers(const Condition& condition);

/// Two motors: the heavy one follows the hardest force since the last time; the light one what of
/// it is over already, so that a blow is felt as sharp and a push is not.
struct Rumble {
  std::uint16_t strong = 0;
  std::uint16_t weak = 0;
};
Rumble rumble_of(const Feel& feel);

/// The size of a force as a share of the range: its longer coordinate.
float size_of(float x, float y);

}  // namespace batuta::host
