// SPDX-License-Identifier: MIT
#pragma once
// The scene of the world of batuta/c.h: what a C program has no words to choose, chosen for it.

#include "batuta/c.h"
#include "batuta/world/scenes.hpp"

namespace batuta::detail {

inline constexpr int kMostBodies = BATUTA_WORLD_BODIES;
inline constexpr int kMostEvents = BATUTA_WORLD_EVENTS;

/// A rack with fewer bodies.
constexpr SceneOptions bodies_for_c() {
  SceneOptions scene = rack();
  scene.max_bodies = kMostBodies;
  scene.max_pairs = 64;
  scene.max_contacts = 128;
  scene.max_events = kMostEvents;
  return scene;
}
using SceneForC = Scene<bodies_for_c>;

}  // namespace batuta::detail
