// SPDX-License-Identifier: MIT
#include "batuta_engine.hpp"

namespace batuta::worlds {
namespace {

/// One scene for all plans: whatever a plan may ask for is on, as with the other engine.
constexpr SceneOptions everything_options() {
  SceneOptions scene;
  scene.max_bodies = kMostBodies;
  scene.max_pairs = 1024;
  scene.max_contacts = 512;
  scene.max_events = 1024;
  scene.friction = true;
  scene.line_contact = true;
  scene.gravity = true;
  scene.sleep = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Everything = Scene<everything_options>;

}  // namespace

std::vector<EnginePtr> batuta_engines() {
  std::vector<EnginePtr> engines;
  engines.push_back(std::make_unique<BatutaEngine<Everything>>(1000));
  engines.push_back(std::make_unique<BatutaEngine<Everything>>(60));
  return engines;
}

}  // namespace batuta::worlds
