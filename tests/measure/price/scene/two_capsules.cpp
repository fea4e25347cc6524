// SPDX-License-Identifier: MIT
// A world of two capsules in free flight, each on the axis of its body: detection, impulse,
// separation, events.

#include "batuta/world/world.hpp"

namespace {

constexpr batuta::SceneOptions two_capsules() {
  batuta::SceneOptions scene;
  scene.bent_turns = false;
  return scene;
}
using Scene = batuta::Scene<two_capsules>;

batuta::World<Scene> world;
float volatile step_s;
float volatile impulse;

batuta::Actor<Scene> capsule(float at) {
  batuta::Actor<Scene> actor;
  actor.capsule_B = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};
  actor.body.X_WB.p_W.x() = at;
  actor.body.inverse_mass = 2;
  actor.body.inverse_moments = {30, 30, 3000};
  actor.restitution = 0.6F;
  return actor;
}

}  // namespace

int main() {
  const bool added = world.add(capsule(0)).ok() && world.add(capsule(1)).ok();
  if (!added || world.step(step_s) != batuta::Status::kOk) return 1;
  for (const auto& event : world.events()) impulse = event.impulse;  // Bound: Scene::kMaxEvents
  return 0;
}
