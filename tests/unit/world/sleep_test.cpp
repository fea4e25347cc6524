// SPDX-License-Identifier: MIT
// Who sleeps, when, and who wakes (src/world/world.md, "Sleep").
#include <gtest/gtest.h>

#include <memory>

#include "batuta/mechanics/solid.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

constexpr SceneOptions sleepy_options() {
  SceneOptions scene = rack();
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.max_contacts = 12;
  scene.max_events = 12;
  return scene;
}
using Sleepy = Scene<sleepy_options, Advancement<double>>;
using SleepyWorld = World<Sleepy>;

Actor<Sleepy> ball(double radius, const Vec3<double>& place) {
  Actor<Sleepy> actor;
  actor.capsule_B = {{Vec3<double>::Zero(), Vec3<double>::Zero()}, radius};
  const auto mass = solid_capsule(actor.capsule_B, 1000.0).value;
  const Vec3<double> moments = mass.inertia_S.diagonal();
  actor.body = make_body<double>({place, Quat<double>::Identity()}, mass.mass, moments).value;
  return actor;
}

/// A ball that lies on a fixed one.
struct Lying {
  Lying() {
    auto floor = ball(1, {0, 0, -1});
    floor.body.inverse_mass = 0;
    floor.body.inverse_moments.setZero();
    ground = world->add(floor).value;
    lying = world->add(ball(0.05, {0, 0, 0.05})).value;
  }
  /// Steps until it sleeps. @returns how many; 0: it does not
  int sleep_after() {
    for (int i = 1; i <= 1000; ++i) {
      if (world->step(kStep) != Status::kOk) return 0;
      if (world->is_asleep(lying)) return i;
    }
    return 0;
  }

  static constexpr double kStep = 1.0 / 512;  // a quarter of a second is 128 of them, exactly
  std::unique_ptr<SleepyWorld> world = std::make_unique<SleepyWorld>();
  SleepyWorld::BodyId ground;
  SleepyWorld::BodyId lying;
};

TEST(Sleep, WhatLies_SleepsAfterSleepTime_AndIsCounted) {
  Lying scene;
  EXPECT_EQ(scene.sleep_after(), 128);
  EXPECT_EQ(scene.world->report().asleep, 1U);
  EXPECT_FALSE(scene.world->is_asleep(scene.ground));
}

TEST(Sleep, WhatSlidesOnAFixedRod_NeverSleeps) {
  auto world = std::make_unique<SleepyWorld>();
  auto rod = ball(1, {0, 0, -1});
  rod.capsule_B.axis = {{-3, 0, 0}, {3, 0, 0}};
  rod.body.inverse_mass = 0;
  rod.body.inverse_moments.setZero();
  ASSERT_TRUE(world->add(rod).ok());
  auto sliding = ball(0.05, {-2, 0, 0.05});
  sliding.body.momentum.linear_W = Vec3<double>(1, 0, 0) / sliding.body.inverse_mass;  // 1 m/s
  const auto id = world->add(sliding).value;
  for (int i = 0; i < 400; ++i) {
    ASSERT_EQ(world->step(Lying::kStep), Status::kOk);
    ASSERT_FALSE(world->is_asleep(id)) << i;
  }
}

TEST(Sleep, WhatNothingHolds_NeverSleeps) {
  auto world = std::make_unique<SleepyWorld>();
  auto settings = world->settings();
  settings.gravity_W.setZero();
  ASSERT_EQ(world->configure(settings), Status::kOk);
  const auto id = world->add(ball(0.05, {0, 0, 0})).value;  // at rest, for ever
  for (int i = 0; i < 400; ++i) ASSERT_EQ(world->step(Lying::kStep), Status::kOk);
  EXPECT_FALSE(world->is_asleep(id));
}

TEST(Sleep, WhatFalls_NeverSleeps) {
  auto world = std::make_unique<SleepyWorld>();
  const auto id = world->add(ball(0.05, {0, 0, 100})).value;
  for (int i = 0; i < 400; ++i) ASSERT_EQ(world->step(Lying::kStep), Status::kOk);
  EXPECT_FALSE(world->is_asleep(id));
}

// Its axis is a point, which does not move.
TEST(Sleep, BallThatSpinsOnTheSpot_NeverSleeps) {
  for (const Vec3<double>& w_W : {Vec3<double>(0, 0, 20), Vec3<double>(0, 0, -0.4)}) {
    Lying scene;
    auto& body = scene.world->get(scene.lying)->body;
    body.momentum.angular_W = w_W.cwiseQuotient(body.inverse_moments);
    const double before = body.momentum.angular_W.z();
    EXPECT_EQ(scene.sleep_after(), 0);
    const auto& after = std::as_const(*scene.world).get(scene.lying)->body.momentum.angular_W;
    EXPECT_NEAR(after.z(), before, 1e-9 * std::abs(before));
  }
}

TEST(Sleep, AnotherGravity_WakesAll) {
  Lying scene;
  ASSERT_GT(scene.sleep_after(), 0);
  auto settings = scene.world->settings();
  settings.gravity_W *= 2;
  ASSERT_EQ(scene.world->configure(settings), Status::kOk);
  EXPECT_FALSE(scene.world->is_asleep(scene.lying));
}

TEST(Sleep, AMomentumFromTheCaller_WakesIt) {
  Lying scene;
  ASSERT_GT(scene.sleep_after(), 0);
  scene.world->get(scene.lying)->body.momentum.linear_W = Vec3<double>(0, 0, 1);
  ASSERT_EQ(scene.world->step(Lying::kStep), Status::kOk);
  EXPECT_FALSE(scene.world->is_asleep(scene.lying));
}

TEST(Sleep, WhatItLayOn_IsRemoved_AndItWakes) {
  Lying scene;
  ASSERT_GT(scene.sleep_after(), 0);
  ASSERT_EQ(scene.world->remove(scene.ground), Status::kOk);
  ASSERT_EQ(scene.world->step(Lying::kStep), Status::kOk);
  EXPECT_FALSE(scene.world->is_asleep(scene.lying));
}

// Once: who was led in some earlier step is like everybody else.
TEST(Sleep, CarrierThatIsLetGo_WakesWhatLiesOnIt_AndBothSleepAgain) {
  Lying scene;
  auto& world = *scene.world;
  ASSERT_EQ(world.remove(scene.lying), Status::kOk);
  const auto free = ball(0.2, {0, 0, 0.2});
  auto held = free;
  held.body.inverse_mass = 0;
  held.body.inverse_moments.setZero();
  const auto carrier = world.add(held).value;
  scene.lying = world.add(ball(0.05, {0, 0, 0.45})).value;
  ASSERT_GT(scene.sleep_after(), 0);
  world.get(carrier)->body.inverse_mass = free.body.inverse_mass;
  world.get(carrier)->body.inverse_moments = free.body.inverse_moments;
  ASSERT_EQ(world.step(Lying::kStep), Status::kOk);
  EXPECT_FALSE(world.is_asleep(scene.lying));
  EXPECT_GT(scene.sleep_after(), 0);
  EXPECT_TRUE(world.is_asleep(carrier));
}

// Let go far away, and some steps ago: it wakes nobody whom it does not press on.
TEST(Sleep, WhoWasLedOnce_LiesDownBesideASleeper_AndLetsItSleep) {
  auto world = std::make_unique<SleepyWorld>();
  auto rod = ball(1, {0, 0, -1});
  rod.capsule_B.axis = {{-3, 0, 0}, {3, 0, 0}};
  rod.body.inverse_mass = 0;
  rod.body.inverse_moments.setZero();
  ASSERT_TRUE(world->add(rod).ok());
  const auto sleeper = world->add(ball(0.05, {0, 0, 0.05})).value;
  const auto other = ball(0.05, {2, 0, 0.05});
  auto held = other;
  held.body.inverse_mass = 0;
  held.body.inverse_moments.setZero();
  const auto comes = world->add(held).value;
  const auto step = [&world] { ASSERT_EQ(world->step(Lying::kStep), Status::kOk); };
  for (int i = 0; i < 200; ++i) step();
  ASSERT_TRUE(world->is_asleep(sleeper));
  world->get(comes)->body.inverse_mass = other.body.inverse_mass;
  world->get(comes)->body.inverse_moments = other.body.inverse_moments;
  for (int i = 0; i < 4; ++i) step();
  // Within D, 1e-4 m, of the sleeper, and too far to press on it.
  world->get(comes)->body.X_WB.p_W.x() = 0.1 + 0.9e-4;
  for (int i = 0; i < 8; ++i) {
    step();
    EXPECT_TRUE(world->is_asleep(sleeper)) << i;
    EXPECT_FALSE(world->is_asleep(comes)) << i;
  }
}

/// A ball that sleeps on what stands: restored, it does not take that for new.
TEST(Sleep, RestoredSleeper_SleepsOn) {
  Lying scene;
  ASSERT_GT(scene.sleep_after(), 0);
  Lying another;
  another.world->restore(*scene.world);
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(another.world->step(Lying::kStep), Status::kOk);
    EXPECT_TRUE(another.world->is_asleep(another.lying)) << i;
  }
}

// The chord of a turn by 0.02 rad: 2 r sin(0.01). A rod's counts about its own axis alone; where
// the orientation does not show its spin, it is that over the moments, I across over I along.
TEST(Sleep, WayOfTheSkin_IsRadiusTimesTurn) {
  constexpr double kTurn = 0.02, kRadius = 0.05;
  const double chord = 2 * kRadius * std::sin(kTurn / 2);
  const auto way = [kTurn](const Actor<Sleepy>& actor, const Vec3<double>& axis) {
    auto body = actor.body;
    body.X_WB.q_WB = Quat<double>(Eigen::AngleAxis<double>(kTurn, axis));
    return detail::way_of_skin(actor.capsule_B, body, Quat<double>::Identity());
  };
  const auto round = ball(kRadius, Vec3<double>::Zero());
  EXPECT_NEAR(way(round, Vec3<double>(1, 2, 2) / 3), chord, 1e-12);
  auto rod = round;
  rod.capsule_B.axis = {Vec3<double>(0, 0, -0.3), Vec3<double>(0, 0, 0.3)};
  rod.body.inverse_moments = {1, 1, 8};
  EXPECT_FALSE(rod.body.spin_shows);
  EXPECT_NEAR(way(rod, Vec3<double>::UnitZ()), 8 * chord, 1e-12);
  EXPECT_NEAR(way(rod, Vec3<double>::UnitX()), 0, 1e-12);
  rod.body.spin_shows = true;
  EXPECT_NEAR(way(rod, Vec3<double>::UnitZ()), chord, 1e-12);
}

}  // namespace
}  // namespace batuta
