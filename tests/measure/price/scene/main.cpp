// SPDX-License-Identifier: MIT
// An image of one scene: places it, makes a step and looks at what happened.

#include "runs.hpp"
#include "scene.hpp"

namespace {

float volatile restitution;
float volatile step_s;
std::uint32_t volatile contacts;

// Of an application, not of its scene.
batuta::price::Start start;

}  // namespace

const batuta::price::Start& batuta::price::blade_start(int /*i*/) {
  return start;
}
const batuta::price::Start& batuta::price::ball_start(int /*i*/) {
  return start;
}

int main() {
  if (!price_scene_place(restitution)) return 1;
  if (price_scene_step(step_s) != batuta::Status::kOk) return 2;
  contacts = price_scene_contacts();
  return 0;
}
