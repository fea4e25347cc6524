// SPDX-License-Identifier: MIT
#pragma once
// Capsules that lie on each other, for tests and the report: a scene, its bodies, and what an
// observer who owes nothing to the world sees of them. Frame W: z up, SI units.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "batuta/world/any_controller.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta::test {

/// Bodies that settle under gravity. Derive, and switch on what a test is about.
constexpr SceneOptions rest_scene_options() {
  SceneOptions scene;
  scene.max_bodies = 5;
  scene.max_pairs = 10;  // all of them
  scene.max_contacts = 64;
  scene.max_events = 64;
  scene.line_contact = true;
  scene.gravity = true;
  scene.owners = false;
  scene.resting = RestingContact::kSettling;
  return scene;
}
template <class S>
using FreeOrHand = AnyController<S, FreeFlight<S>, Hand<S>>;
template <class S>
using RestScene = Scene<rest_scene_options, Advancement<S>, FreeOrHand<S>>;
constexpr SceneOptions rubbing_scene_options() {
  SceneOptions scene = rest_scene_options();
  scene.friction = true;
  return scene;
}
template <class S>
using RubbingScene = Scene<rubbing_scene_options, Advancement<S>, FreeOrHand<S>>;
constexpr SceneOptions sleepy_scene_options() {
  SceneOptions scene = rubbing_scene_options();
  scene.sleep = true;
  return scene;
}
template <class S>
using SleepyScene = Scene<sleepy_scene_options, Advancement<S>, FreeOrHand<S>>;
constexpr SceneOptions smooth_sleepy_scene_options() {
  SceneOptions scene = rest_scene_options();
  scene.sleep = true;
  return scene;
}
template <class S>
using SmoothSleepyScene = Scene<smooth_sleepy_scene_options, Advancement<S>, FreeOrHand<S>>;

constexpr double kRodHalf = 0.5;     ///< between the middle of a rod and an end of its axis, m
constexpr double kRodRadius = 0.01;  ///< of rods and posts, m
constexpr double kRodLength = 2 * (kRodHalf + kRodRadius);
constexpr double kTick = 1e-3;  ///< a step of 1 kHz, s

/// What a search cannot tell from contact, twice, and rounding, of a pair whose distance, sizes and
/// ways add up to `size` (src/world/detail/margin.md): a pair that parts and turns back within a
/// step, or that is pressed together, may overlap by so much, m.
template <class S>
double margin(double size) {
  constexpr double kRound = static_cast<double>(kRoundOff<S>);
  return 2 * size * (std::max(1e-6, 96 * kRound) + 72 * kRound);
}

template <class S>
Vec3<S> vector(double x, double y, double z) {
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

/// The capsule of a rod about its own middle. @param axis  one of the axes of W
template <class S>
Capsule<S> rod_shape(const Vec3<double>& axis) {
  const Vec3<S> end = (kRodHalf * axis).template cast<S>();
  return {{Vec3<S>(-end), end}, static_cast<S>(kRodRadius)};
}

/// A rod of 1 kg, solid, along `axis`.
template <class SceneT>
Actor<SceneT> rod_at(const Vec3<double>& place, const Vec3<double>& axis) {
  using S = typename SceneT::Scalar;
  Actor<SceneT> actor;
  actor.capsule_B = rod_shape<S>(axis);
  const auto mass = solid_capsule(actor.capsule_B, S(1)).value;
  const Vec3<S> moments = mass.inertia_S.diagonal() / mass.mass;
  actor.body = make_body<S>({place.template cast<S>(), Quat<S>::Identity()}, S(1), moments).value;
  if constexpr (SceneT::kFriction) actor.friction = S(0.5);
  return actor;
}

/// The same, fixed.
template <class SceneT>
Actor<SceneT> post_at(const Vec3<double>& place, const Vec3<double>& axis) {
  Actor<SceneT> actor = rod_at<SceneT>(place, axis);
  actor.body.inverse_mass = 0;
  actor.body.inverse_moments.setZero();
  return actor;
}

/// A solid ball of 1 kg.
template <class SceneT>
Actor<SceneT> ball_at(const Vec3<double>& place, double radius) {
  using S = typename SceneT::Scalar;
  Actor<SceneT> actor;
  const auto moment = static_cast<S>(0.4 * radius * radius);
  actor.body = make_body<S>({place.template cast<S>(), Quat<S>::Identity()}, S(1),
                            Vec3<S>(moment, moment, moment))
                   .value;
  actor.capsule_B = Capsule<S>::sphere(Vec3<S>::Zero(), static_cast<S>(radius));
  return actor;
}

/// The capsule of a body as it is stored, in double.
template <class SceneT>
Capsule<double> seen(const Actor<SceneT>& actor) {
  const Pose<double> pose{actor.body.X_WB.p_W.template cast<double>(),
                          actor.body.X_WB.q_WB.template cast<double>()};
  const auto& axis = actor.capsule_B.axis;
  return to_world(pose,
                  Capsule<double>{{axis.a.template cast<double>(), axis.b.template cast<double>()},
                                  static_cast<double>(actor.capsule_B.radius)});
}

template <class SceneT>
const Actor<SceneT>& body_in(const World<SceneT>& world, int slot) {
  return *world.get(world.id_at(static_cast<std::uint16_t>(slot)));
}

/// The least gap of any two bodies that can move, or of one that can and one that cannot, m.
/// Slots are those of bodies added one after the other.
template <class SceneT>
double least_gap(const World<SceneT>& world) {
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a < world.size(); ++a) {
    for (int b = a + 1; b < world.size(); ++b) {
      const Actor<SceneT>& A = body_in(world, a);
      const Actor<SceneT>& B = body_in(world, b);
      if (is_fixed(A.body) && is_fixed(B.body)) continue;
      least = std::min(least, static_cast<double>(capsule_gap(seen(A), seen(B)).gap));
    }
  }
  return least;
}

/// The furthest that an end of the body's axis is from where that of `before` was, m.
template <class SceneT>
double moved_since(const Actor<SceneT>& actor, const Capsule<double>& before) {
  const Capsule<double> now = seen(actor);
  return std::max((now.axis.a - before.axis.a).norm(), (now.axis.b - before.axis.b).norm());
}

/// The most separations of one pair in the last step, from its events.
template <class SceneT>
int most_separations(const World<SceneT>& world) {
  std::array<std::array<int, SceneT::kMaxBodies>, SceneT::kMaxBodies> counts{};
  int most = 0;
  for (const auto& event : world.events()) {
    if (event.kind == EventKind::kEnd || event.contact_kind != ContactKind::kResting) continue;
    most = std::max(most, ++counts[event.body_A][event.body_B]);
  }
  return most;
}

/// Rods in the positions that the tests speak of. Each is dropped from a gap of D.
enum class Pile {
  kAcross,  ///< a rod across two parallel posts
  kGroove,  ///< a rod in the groove between two parallel posts
};

/// Adds the rod first, then the posts.
template <class SceneT>
void pile_up(World<SceneT>& world, Pile pile, double D) {
  const Vec3<double> X = Vec3<double>::UnitX();
  const Vec3<double> Y = Vec3<double>::UnitY();
  const bool across = pile == Pile::kAcross;
  const double aside = across ? 0.35 : 0.012;
  const double reach = 2 * kRodRadius + D;
  const double height = across ? reach : std::sqrt(reach * reach - aside * aside);
  (void)world.add(rod_at<SceneT>({0, 0, height}, across ? X : Y));
  (void)world.add(post_at<SceneT>({-aside, 0, 0}, Y));
  (void)world.add(post_at<SceneT>({aside, 0, 0}, Y));
}

}  // namespace batuta::test
