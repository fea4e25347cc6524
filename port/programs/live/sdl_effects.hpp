// SPDX-License-Identifier: MIT
#pragma once
// The effects as SDL takes them. A direction there says where a force comes from (SDL_haptic.h,
// SDL_HapticDirection): one that pushes to the right comes from the west, one that pushes up, away
// from the user, from the south. A level below zero turns it round. All end by themselves after
// kEffectLength_ms.

#include <SDL.h>

#include "programs/live/effects.hpp"

namespace batuta::host {

enum class Push : std::uint8_t { kRight, kUp };

SDL_HapticEffect sdl_constant(Push push, std::int16_t level);
/// For a device with room for one effect: cartesian, from where (x, y) comes.
SDL_HapticEffect sdl_constant(float x, float y);
/// @param type  SDL_HAPTIC_SPRING or SDL_HAPTIC_DAMPER
SDL_HapticEffect sdl_condition(std::uint16_t type, const ConditionPair& pair);

}  // namespace batuta::host
