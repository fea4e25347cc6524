// SPDX-License-Identifier: MIT
// What a user's file has: a scene, its world, a body and a step.
#include "batuta/world/world.hpp"

constexpr batuta::SceneOptions blades() {
  return {};
}
using Blades = batuta::Scene<blades>;

batuta::Status run();
batuta::Status run() {
  batuta::World<Blades> world;
  batuta::Actor<Blades> actor;
  actor.capsule_B = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};
  const auto added = world.add(actor);
  return added.ok() ? world.step(1e-3F) : added.status;
}
