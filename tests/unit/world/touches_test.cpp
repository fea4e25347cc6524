// SPDX-License-Identifier: MIT
// What is told of contacts that last: one event of a pair in a step, its fastest approach and all
// of its impulse; begins and ends in turn.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "batuta/mechanics/solid.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

constexpr SceneOptions told_options() {
  SceneOptions scene = rack();
  scene.max_bodies = 12;
  scene.max_pairs = 66;
  scene.max_contacts = 128;
  scene.max_events = 132;
  return scene;
}
using Told = Scene<told_options, Advancement<double>>;

Actor<Told> ball(double radius, const Vec3<double>& place, double restitution) {
  Actor<Told> actor;
  actor.capsule_B = {{Vec3<double>::Zero(), Vec3<double>::Zero()}, radius};
  const auto mass = solid_capsule(actor.capsule_B, 1000.0).value;
  const Vec3<double> moments = mass.inertia_S.diagonal();
  actor.body = make_body<double>({place, Quat<double>::Identity()}, mass.mass, moments).value;
  actor.restitution = restitution;
  actor.friction = 0.5;
  return actor;
}
Actor<Told> floor_of(double radius) {
  auto floor = ball(radius, {0, 0, -radius}, 0.9);
  floor.body.inverse_mass = 0;
  floor.body.inverse_moments.setZero();
  return floor;
}

TEST(Touches, ManyBlowsInAStep_AreOneEventWithAllOfTheImpulse) {
  // A light ball between two heavy ones that close in on it, without gravity.
  auto world = std::make_unique<World<Told>>();
  auto settings = world->settings();
  settings.gravity_W.setZero();
  ASSERT_EQ(world->configure(settings), Status::kOk);
  std::array<World<Told>::BodyId, 3> ids;
  constexpr double kSpeed = 0.5;
  for (int i = 0; i < 3; ++i) {
    auto one = ball(i == 1 ? 0.01 : 0.1, {0.13 * (i - 1), 0, 0}, 0.9);
    if (i != 1) one.body.momentum.linear_W.x() = (1 - i) * kSpeed / one.body.inverse_mass;
    ids[static_cast<std::size_t>(i)] = world->add(one).value;
  }
  const auto momentum = [&] {
    return std::as_const(*world).get(ids[0])->body.momentum.linear_W.x();
  };
  std::uint32_t most = 0;
  for (int i = 0; i < 10; ++i) {
    const double before = momentum();
    ASSERT_EQ(world->step(1.0 / 60), Status::kOk);
    double told = 0;
    double fastest = 0;
    int blows = 0;
    for (const auto& event : world->events()) {
      if (event.kind == EventKind::kEnd || event.body_A != 0) continue;
      ++blows;
      told += event.impulse;
      fastest = event.v_rel;
    }
    ASSERT_LE(blows, 1) << "step " << i;
    if (world->report().collisions > 3 && i < 3) {
      // The rest is what lasts after the last blow: a load, not told.
      EXPECT_LE(told, (before - momentum()) * (1 + 1e-9)) << "step " << i;
      EXPECT_GE(told, 0.8 * (before - momentum())) << "step " << i;
      EXPECT_LE(fastest, -kSpeed) << "step " << i;
    }
    most = max_of(most, world->report().collisions);
  }
  EXPECT_GE(most, 4U) << "or there were too few blows in a step";
}

TEST(Touches, BeginsAndEnds_TakeTurns) {
  auto world = std::make_unique<World<Told>>();
  ASSERT_TRUE(world->add(floor_of(1)).ok());
  for (int i = 0; i < 10; ++i) {
    const Vec3<double> place(0.03 * i - 0.15, 0.01 * (i % 3), 0.06 + 0.11 * i);
    ASSERT_TRUE(world->add(ball(0.05, place, 0.5)).ok());
  }
  std::map<std::pair<int, int>, bool> touching;
  int ends = 0;
  for (int i = 0; i < 1500; ++i) {
    ASSERT_EQ(world->step(1e-3), Status::kOk);
    ASSERT_TRUE(world->report().complete());
    std::map<std::pair<int, int>, int> told;
    for (const auto& event : world->events()) {
      ASSERT_LT(event.body_A, event.body_B);
      bool& touches = touching[{event.body_A, event.body_B}];
      ASSERT_EQ(touches, event.kind != EventKind::kBegin) << "step " << i;
      touches = event.kind != EventKind::kEnd;
      ends += event.kind == EventKind::kEnd ? 1 : 0;
      if (event.kind == EventKind::kEnd) continue;
      ASSERT_EQ(++told[std::make_pair(int{event.body_A}, int{event.body_B})], 1) << "step " << i;
    }
  }
  EXPECT_GT(ends, 10);
}

}  // namespace
}  // namespace batuta
