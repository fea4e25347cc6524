// SPDX-License-Identifier: MIT
#pragma once
// TwoBlades with one feature changed at a time: what a feature costs is the difference of two of
// these (tools/scenes.py names which).

#include "batuta/world/scenes.hpp"

namespace batuta::price {

constexpr SceneOptions no_restitution_options() {
  SceneOptions scene = two_blades();
  scene.restitution = false;
  return scene;
}
using NoRestitution = Scene<no_restitution_options>;
constexpr SceneOptions resting_none_options() {
  SceneOptions scene = two_blades();
  scene.resting = RestingContact::kNone;
  return scene;
}
using RestingNone = Scene<resting_none_options>;
constexpr SceneOptions resting_settling_options() {
  SceneOptions scene = two_blades();
  scene.resting = RestingContact::kSettling;
  return scene;
}
using RestingSettling = Scene<resting_settling_options>;
constexpr SceneOptions no_response_options() {
  SceneOptions scene = resting_none_options();
  scene.response = false;
  scene.restitution = false;
  return scene;
}
using NoResponse = Scene<no_response_options>;
constexpr SceneOptions friction_options() {
  SceneOptions scene = resting_settling_options();
  scene.friction = true;
  return scene;
}
using Friction = Scene<friction_options>;
constexpr SceneOptions line_contact_options() {
  SceneOptions scene = two_blades();
  scene.line_contact = true;
  return scene;
}
using LineContact = Scene<line_contact_options>;
constexpr SceneOptions gravity_options() {
  SceneOptions scene = two_blades();
  scene.gravity = true;
  return scene;
}
using Gravity = Scene<gravity_options>;
constexpr SceneOptions sleep_options() {
  SceneOptions scene = resting_settling_options();
  scene.sleep = true;
  return scene;
}
using Sleep = Scene<sleep_options>;
constexpr SceneOptions no_events_options() {
  SceneOptions scene = two_blades();
  scene.max_events = 0;
  return scene;
}
using NoEvents = Scene<no_events_options>;
constexpr SceneOptions no_owners_options() {
  SceneOptions scene = two_blades();
  scene.owners = false;
  return scene;
}
using NoOwners = Scene<no_owners_options>;
constexpr SceneOptions filters_options() {
  SceneOptions scene = two_blades();
  scene.filters = true;
  return scene;
}
using Filters = Scene<filters_options>;
constexpr SceneOptions two_parts_options() {
  SceneOptions scene = two_blades();
  scene.capsules_per_body = 2;
  scene.max_pairs = 4;
  return scene;
}
using TwoParts = Scene<two_parts_options>;
using WithTranslation = Scene<two_blades, Translation<float>>;
using WithStepping = Scene<two_blades, Stepping<float>>;
using WithCoarseBox = Scene<two_blades, Advancement<float>, FreeFlight<float>, CoarseBox>;
/// Turns, but is searched as if it did not: what NoRotation is compared with.
using Unturned = Scene<resting_none_options, Translation<float>>;
constexpr SceneOptions no_rotation_options() {
  SceneOptions scene = resting_none_options();
  scene.rotation = false;
  return scene;
}
using NoRotation = Scene<no_rotation_options, Translation<float>>;
using Balls = Scene<no_rotation_options, Spheres<float>>;
/// What StraightSpheres is compared with.
constexpr SceneOptions spheres_with_events_options() {
  SceneOptions scene = straight_spheres();
  scene.engine = Engine::kGeneral;
  scene.max_pairs = 28;  // all of them
  scene.max_events = 16;
  return scene;
}
using SpheresWithEvents = Scene<spheres_with_events_options, Spheres<float>>;

}  // namespace batuta::price
