// SPDX-License-Identifier: MIT
#pragma once
// Ready-made scenes: a function that starts from the options of one makes another, or read them as
// examples. The duel is DuelScene (fencing/duel.hpp). What each costs on a part stands in
// docs/cost.md.

#include "batuta/world/scene.hpp"

namespace batuta {

/// Up to eight balls that fly straight and bounce off each other; no events, report() counts.
constexpr SceneOptions straight_spheres() {
  SceneOptions scene;
  scene.engine = Engine::kSmall;
  scene.max_bodies = 8;
  scene.max_events = 0;
  scene.rotation = false;
  scene.owners = false;
  scene.resting = RestingContact::kNone;
  return scene;
}
/// The scene of straight_spheres().
using StraightSpheres = Scene<straight_spheres, Spheres<float>>;

/// Two capsules that go where their controllers say: events say when and where they meet, and
/// nothing changes.
constexpr SceneOptions detection_only() {
  SceneOptions scene;
  scene.bent_turns = false;
  scene.response = false;
  scene.restitution = false;
  scene.owners = false;
  scene.resting = RestingContact::kNone;
  return scene;
}
/// The scene of detection_only().
using DetectionOnly = Scene<detection_only>;

/// Two capsules with impulses and the paper's separation, each on the axis of its body.
constexpr SceneOptions two_blades() {
  SceneOptions scene;
  scene.bent_turns = false;
  return scene;
}
/// The scene of two_blades().
using TwoBlades = Scene<two_blades>;

/// 64 capsules that fall, rub, pile up and come to rest, each on the axis of its body.
constexpr SceneOptions rack() {
  SceneOptions scene;
  scene.max_bodies = 64;
  scene.max_pairs = 640;
  scene.max_contacts = 512;
  scene.max_events = 512;
  scene.bent_turns = false;
  scene.friction = true;
  scene.line_contact = true;
  scene.gravity = true;
  scene.sleep = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
/// The scene of rack().
using Rack = Scene<rack>;

}  // namespace batuta
