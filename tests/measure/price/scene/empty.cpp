// SPDX-License-Identifier: MIT
// No scene at all: what an image takes before there is anything in it.

#include "scene.hpp"

bool price_scene_place(float /*restitution*/) {
  return true;
}
batuta::Status price_scene_step(float /*dt*/) {
  return batuta::Status::kOk;
}
std::uint32_t price_scene_contacts() {
  return 0;
}
std::uint32_t price_scene_state() {
  return 0;
}
