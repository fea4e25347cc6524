// SPDX-License-Identifier: MIT
// An image of one scene: places it, makes a step and looks at what happened.

#include "scene.hpp"

namespace {

float volatile restitution;
float volatile step_s;
std::uint32_t volatile contacts;

}  // namespace

int main() {
  if (!price_scene_place(restitution)) return 1;
  if (price_scene_step(step_s) != batuta::Status::kOk) return 2;
  contacts = price_scene_contacts();
  return 0;
}
