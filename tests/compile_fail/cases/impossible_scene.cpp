// SPDX-License-Identifier: MIT
// A program with a scene made of the options BASE, which are possible, and CHANGE, a statement
// about `scene`; SEARCH, CONTROLLER and BOUND name the other arguments of the scene.
#include "batuta/world/world.hpp"

#ifndef BASE
#define BASE plain
#endif
#ifndef CHANGE
#define CHANGE static_cast<void>(scene)
#endif
#ifndef SEARCH
#define SEARCH Advancement<float>
#endif
#ifndef CONTROLLER
#define CONTROLLER FreeFlight<SEARCH::Scalar>
#endif
#ifndef BOUND
#define BOUND SweptBox
#endif

namespace {

using namespace batuta;

constexpr SceneOptions plain() {
  return {};
}
constexpr SceneOptions unrested() {
  SceneOptions scene;
  scene.resting = RestingContact::kNone;
  return scene;
}
constexpr SceneOptions straight() {
  SceneOptions scene = unrested();
  scene.rotation = false;
  return scene;
}
constexpr SceneOptions small() {
  SceneOptions scene = straight();
  scene.engine = Engine::kSmall;
  scene.max_events = 0;
  return scene;
}
constexpr SceneOptions silent() {
  SceneOptions scene = unrested();
  scene.response = false;
  scene.restitution = false;
  return scene;
}
constexpr SceneOptions settling() {
  SceneOptions scene;
  scene.resting = RestingContact::kSettling;
  return scene;
}
constexpr SceneOptions sleepy() {
  SceneOptions scene = settling();
  scene.sleep = true;
  return scene;
}
constexpr SceneOptions crowd() {
  SceneOptions scene;
  scene.max_bodies = 1024;
  scene.max_pairs = 512;
  return scene;
}
constexpr SceneOptions hurried() {
  SceneOptions scene;
  scene.turn_per_step = 0.785F;
  scene.contact_tolerance = 8e-4F;
  scene.budget = 16;
  return scene;
}

// Controllers that lack something. The last one lacks nothing.
struct WithoutPlan {
  void on_contact(const Body<float>& body, const Feedback<float>& feedback);
  void on_step_end(const Body<float>& body, float dt);
};
struct WithoutContact {
  PlannedMotion<float> plan(const Body<float>& body, float t, float duration) const;
  void on_step_end(const Body<float>& body, float dt);
};
struct WithoutStepEnd {
  PlannedMotion<float> plan(const Body<float>& body, float t, float duration) const;
  void on_contact(const Body<float>& body, const Feedback<float>& feedback);
};
struct Own : WithoutPlan {
  PlannedMotion<float> plan(const Body<float>& body, float t, float duration) const {
    return {still(body.X_WB, t + duration), false};
  }
  void on_contact(const Body<float>& /*body*/, const Feedback<float>& /*feedback*/) {}
  void on_step_end(const Body<float>& /*body*/, float /*dt*/) {}
};

constexpr SceneOptions mine() {
  SceneOptions scene = BASE();
  CHANGE;
  return scene;
}
using MyScene = Scene<mine, SEARCH, CONTROLLER, BOUND>;

}  // namespace

#include "use_scene.inc"
