// SPDX-License-Identifier: MIT

#include "programs/live/linux_effects.hpp"

namespace batuta::host {
namespace {

ff_effect new_effect(std::uint16_t type) {
  ff_effect effect{};
  effect.type = type;
  effect.id = -1;
  effect.replay.length = kEffectLength_ms;
  return effect;
}

ff_condition_effect condition(const ConditionNumbers& numbers) {
  ff_condition_effect effect{};
  effect.right_saturation = numbers.saturation;
  effect.left_saturation = numbers.saturation;
  effect.right_coeff = numbers.coefficient;
  effect.left_coeff = numbers.coefficient;
  effect.center = numbers.centre;
  return effect;
}

}  // namespace

ff_effect linux_constant(std::uint16_t direction, std::int16_t level) {
  ff_effect effect = new_effect(FF_CONSTANT);
  effect.direction = direction;
  effect.u.constant.level = level;
  return effect;
}

ff_effect linux_condition(std::uint16_t type, const ConditionPair& pair) {
  ff_effect effect = new_effect(type);
  effect.u.condition[0] = condition(pair.x);
  effect.u.condition[1] = condition(pair.y);
  return effect;
}

ff_effect linux_rumble(const Rumble& rumble) {
  ff_effect effect = new_effect(FF_RUMBLE);
  effect.u.rumble.strong_magnitude = rumble.strong;
  effect.u.rumble.weak_magnitude = rumble.weak;
  return effect;
}

}  // namespace batuta::host
