// SPDX-License-Identifier: MIT

#include "programs/live/sdl_effects.hpp"

namespace batuta::host {
namespace {

SDL_HapticEffect constant(Sint32 from_x, Sint32 from_y, std::int16_t level) {
  SDL_HapticEffect effect{};
  effect.constant.type = SDL_HAPTIC_CONSTANT;
  effect.constant.length = kEffectLength_ms;
  effect.constant.direction.type = SDL_HAPTIC_CARTESIAN;
  effect.constant.direction.dir[0] = from_x;
  effect.constant.direction.dir[1] = from_y;
  effect.constant.level = level;
  return effect;
}

void set(SDL_HapticCondition& effect, int axis, const ConditionNumbers& numbers) {
  effect.right_sat[axis] = numbers.saturation;
  effect.left_sat[axis] = numbers.saturation;
  effect.right_coeff[axis] = numbers.coefficient;
  effect.left_coeff[axis] = numbers.coefficient;
  effect.center[axis] = numbers.centre;
}

}  // namespace

SDL_HapticEffect sdl_constant(Push push, std::int16_t level) {
  // West is (-1, 0), south (0, 1).
  return push == Push::kRight ? constant(-1, 0, level) : constant(0, 1, level);
}

SDL_HapticEffect sdl_constant(float x, float y) {
  const std::int16_t level = level_of(size_of(x, y));
  if (level == 0) return constant(-1, 0, 0);
  return constant(-level_of(x), level_of(y), level);
}

SDL_HapticEffect sdl_condition(std::uint16_t type, const ConditionPair& pair) {
  SDL_HapticEffect effect{};
  effect.condition.type = type;
  effect.condition.length = kEffectLength_ms;
  effect.condition.direction.type = SDL_HAPTIC_CARTESIAN;
  set(effect.condition, 0, pair.x);
  set(effect.condition, 1, pair.y);
  return effect;
}

}  // namespace batuta::host
