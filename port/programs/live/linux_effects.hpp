// SPDX-License-Identifier: MIT
#pragma once
// The effects as the Linux input stack takes them. A direction there says where a force pushes: 0
// down, 0x4000 left, 0x8000 up, 0xC000 right (linux/input.h, struct ff_effect); a level below zero
// turns it round. All end by themselves after kEffectLength_ms; `id` is left to the caller.

#include <linux/input.h>

#include "programs/live/effects.hpp"

namespace batuta::host {

inline constexpr std::uint16_t kPushLeft = 0x4000;
inline constexpr std::uint16_t kPushUp = 0x8000;
inline constexpr std::uint16_t kPushRight = 0xC000;

/// @param direction  kPushRight for the x axis, kPushUp for the y axis
ff_effect linux_constant(std::uint16_t direction, std::int16_t level);
/// @param type  FF_SPRING or FF_DAMPER
ff_effect linux_condition(std::uint16_t type, const ConditionPair& pair);
ff_effect linux_rumble(const Rumble& rumble);

}  // namespace batuta::host
