// SPDX-License-Identifier: MIT
#pragma once
// One scene as an image or the bench runs it: a file of its own makes each scene, so that what is
// measured for size and what is measured for time is the same object.

#include <cstdint>

#include "batuta/core/status.hpp"

extern "C" {
/// Puts the bodies where the run begins. @returns whether there was room
bool price_scene_place(float restitution);
batuta::Status price_scene_step(float dt);
/// Contacts answered or told in the last step.
std::uint32_t price_scene_contacts();
/// Every bit of where the bodies are and how they move, for the bench; an image does not link it.
std::uint32_t price_scene_state();
}

/// Length of a step of the run, s.
inline constexpr float kPriceStep = 1e-3F;
