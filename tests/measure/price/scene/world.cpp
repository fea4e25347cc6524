// SPDX-License-Identifier: MIT
// The scene that PRICE_SCENE names, with a World around it.

#include "actors.hpp"
#include "scene.hpp"
#include "variants.hpp"

namespace {

using Scene = PRICE_SCENE;
batuta::World<Scene> world;

}  // namespace

bool price_scene_place(float restitution) {
  bool good = true;
  for (int i = 0; i < Scene::kMaxBodies; ++i) {  // Bound: kMaxBodies
    auto actor = batuta::price::actor_of<Scene>(i);
    batuta::price::put_surface(actor, restitution);
    good = good && world.add(actor).ok();
  }
  return good;
}

batuta::Status price_scene_step(float dt) {
  return world.step(dt);
}

std::uint32_t price_scene_contacts() {
  return batuta::price::contacts_of(world);
}

std::uint32_t price_scene_state() {
  using namespace batuta::price;
  const batuta::World<Scene>& seen = world;
  std::uint32_t hash = kEmptyHash;
  for (int i = 0; i < Scene::kMaxBodies; ++i) {  // Bound: kMaxBodies
    hash = mixed(hash, seen.get(seen.id_at(static_cast<std::uint16_t>(i)))->body);
  }
  return hash;
}
