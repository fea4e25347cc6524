// SPDX-License-Identifier: MIT
// What each feature of a scene does, against exact truth. Resting contacts have their own tests.

#include <gtest/gtest.h>

#include <cmath>

#include "batuta/mechanics/compound.hpp"
#include "batuta/world/scene_cost.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

template <class S>
Vec3<S> vec(double x, double y, double z) {
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

// --- nothing turns

constexpr SceneOptions balls_options() {
  SceneOptions scene = straight_spheres();
  scene.engine = Engine::kGeneral;
  scene.max_pairs = 28;  // all of them
  scene.max_events = 8;
  return scene;
}
using Balls = Scene<balls_options, Spheres<float>>;
constexpr SceneOptions many_balls_options() {
  SceneOptions scene = balls_options();
  scene.max_bodies = 12;
  scene.max_pairs = 66;
  return scene;
}
using ManyBalls = Scene<many_balls_options, Spheres<float>>;
using Rods = Scene<balls_options, Translation<float>>;

/// A gap of up to 144 u S counts as contact (sphere_flight.md; advancement.md has 168 u S), S < 3.5
/// m here: so much earlier a blow may be, and a velocity changes by up to one and a half times the
/// closing speed in it.
constexpr double kEarly = 1.5 * 168 * 6e-8 * 3.5;

template <class SceneT>
class Straight : public ::testing::Test {
 protected:
  using BodyId = typename World<SceneT>::BodyId;

  BodyId add(double x, double vx, double mass = 1) {
    Actor<SceneT> actor;
    actor.body = make_straight_body<float>(vec<float>(x, 0, 0), static_cast<float>(mass)).value;
    if (std::isfinite(mass)) actor.body.momentum_W = vec<float>(mass * vx, 0, 0);
    actor.restitution = 1;
    if constexpr (SceneT::Search::kForSpheres) {
      actor.radius = 0.1F;
    } else {
      actor.capsule_B = {{{0, 0, -1}, {0, 0, 1}}, 0.1F};
    }
    return world.add(actor).value;
  }

  World<SceneT> world;
};
using StraightScenes = ::testing::Types<Balls, ManyBalls, Rods>;
TYPED_TEST_SUITE(Straight, StraightScenes);

// Elastic, 1 kg against 3 kg: v1' = (m1 - m3) / (m1 + m3) v = -v / 2, v3' = v / 2.
TYPED_TEST(Straight, ElasticBlow_FollowsTheTextbook) {
  const auto light = this->add(0, 2);
  const auto heavy = this->add(1, 0, 3);
  ASSERT_EQ(this->world.step(1.0F), Status::kOk);
  EXPECT_TRUE(this->world.report().complete());
  EXPECT_EQ(this->world.report().collisions, 1U);
  EXPECT_NEAR(this->world.get(light)->body.momentum_W.x(), -1, 1e-6);
  EXPECT_NEAR(this->world.get(heavy)->body.momentum_W.x(), 3, 1e-6);
  EXPECT_NEAR(this->world.get(light)->body.p_W.x(), 0.8 - 0.6, kEarly) << "touch at 0.4 s";
  EXPECT_NEAR(this->world.get(heavy)->body.p_W.x(), 1 + 0.6, kEarly);
  ASSERT_GE(this->world.events().size(), 1);
  EXPECT_NEAR(this->world.events()[0].time, 0.4, kEarly);
  EXPECT_NEAR(this->world.events()[0].contact.point_W.x(), 0.9, kEarly);
}

TYPED_TEST(Straight, ChainOfBlowsInOneStep_PassesTheMomentumOn) {
  std::array<typename TestFixture::BodyId, 4> ids;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ids[i] = this->add(0.25 * static_cast<double>(i), i == 0 ? 1 : 0);
  }
  ASSERT_EQ(this->world.step(0.5F), Status::kOk);
  EXPECT_TRUE(this->world.report().complete());
  EXPECT_EQ(this->world.report().collisions, 3U);
  EXPECT_NEAR(this->world.get(ids[3])->body.momentum_W.x(), 1, 1e-6);
  EXPECT_NEAR(this->world.get(ids[3])->body.p_W.x(), 0.75 + 0.5 - 0.15, 3 * kEarly);
}

TYPED_TEST(Straight, BounceBetweenWalls_KeepsSpeedAndNeverOverlaps) {
  (void)this->add(-1, 0, INFINITY);
  const auto ball = this->add(0, 30);
  (void)this->add(1, 0, INFINITY);
  std::uint32_t collisions = 0;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(this->world.step(0.01F), Status::kOk);
    ASSERT_TRUE(this->world.report().complete());
    collisions += this->world.report().collisions;
    ASSERT_LE(std::abs(this->world.get(ball)->body.p_W.x()), 0.8F + 1e-6F) << "step " << i;
  }
  EXPECT_NEAR(collisions, 300 / 1.6, 1.0);
  EXPECT_NEAR(std::abs(this->world.get(ball)->body.momentum_W.x()), 30, 1e-4);
}

TYPED_TEST(Straight, TouchingAndParting_IsLeftAlone) {
  (void)this->add(0, -1);
  (void)this->add(0.2, 1);
  ASSERT_EQ(this->world.step(0.1F), Status::kOk);
  EXPECT_EQ(this->world.report().collisions, 0U);
  EXPECT_TRUE(this->world.report().complete());
}

TYPED_TEST(Straight, BadInput_IsRefused) {
  Actor<TypeParam> actor;
  actor.body.p_W.x() = NAN;
  EXPECT_EQ(this->world.add(actor).status, Status::kInvalidArgument);
  EXPECT_EQ(this->world.step(0), Status::kInvalidArgument);
  EXPECT_EQ(this->world.step(-1), Status::kInvalidArgument);
}

// --- detection only

TEST(DetectionOnlyScene, PassingThrough_IsToldOnceAndEnds) {
  World<DetectionOnly> world;
  Actor<DetectionOnly> actor;
  actor.capsule_B = Capsule<float>::sphere(Vec3<float>::Zero(), 0.1F);
  actor.body = make_body<float>({}, 1, {1, 1, 1}).value;
  actor.body.momentum.linear_W = {1, 0, 0};
  const auto id = world.add(actor).value;
  actor.body.X_WB.p_W = {1, 0, 0};
  actor.body.momentum.linear_W = Vec3<float>::Zero();
  (void)world.add(actor);
  int begins = 0;
  int ends = 0;
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(world.step(0.1F), Status::kOk);
    ASSERT_TRUE(world.report().complete()) << "step " << i;
    EXPECT_EQ(world.report().time_held, 0);
    for (const auto& event : world.events()) {
      begins += event.kind == EventKind::kBegin ? 1 : 0;
      ends += event.kind == EventKind::kEnd ? 1 : 0;
      if (event.kind == EventKind::kBegin) {
        EXPECT_NEAR(0.1F * static_cast<float>(i) + event.time, 0.8, 1e-4);
      }
    }
  }
  EXPECT_EQ(begins, 1);
  EXPECT_EQ(ends, 1);
  EXPECT_NEAR(world.get(id)->body.X_WB.p_W.x(), 3, 1e-5) << "nothing stopped it";
}

// --- gravity

constexpr SceneOptions falling_options() {
  SceneOptions scene;
  scene.gravity = true;
  return scene;
}
using Falling = Scene<falling_options>;

// The parabola, whatever the step.
TEST(GravityScene, FreeFall_IsTheParabola) {
  World<Falling> world;
  Actor<Falling> actor;
  actor.capsule_B.radius = 0.1F;
  actor.body = make_body<float>({}, 2, {1, 1, 1}).value;
  const auto id = world.add(actor).value;
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(world.step(1e-3F), Status::kOk);
  EXPECT_NEAR(world.get(id)->body.momentum.linear_W.z(), -2 * 9.81, 1e-3);
  EXPECT_NEAR(world.get(id)->body.X_WB.p_W.z(), -9.81 / 2, 1e-5 * 9.81 / 2);
}

TEST(GravityScene, WhatHasNoMassOrIsHeld_DoesNotFall) {
  World<Falling> world;
  Actor<Falling> actor;
  actor.capsule_B.radius = 0.1F;
  const auto id = world.add(actor).value;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(world.step(1e-3F), Status::kOk);
  EXPECT_EQ(world.get(id)->body.X_WB.p_W.z(), 0);
}

constexpr SceneOptions crowded_options() {
  SceneOptions scene = falling_options();
  scene.max_bodies = 3;
  scene.max_pairs = 1;
  return scene;
}
using Crowded = Scene<crowded_options>;

// Two pairs of boxes overlap where one has room: the bodies of the other go on together, which for
// bodies that fall side by side is as if nothing were between them.
TEST(GravityScene, WhatHasNoRoom_FallsTogether) {
  World<Crowded> world;
  for (const float x : {0.0F, 0.15F, -0.15F}) {
    Actor<Crowded> actor;
    actor.capsule_B.radius = 0.1F;
    const Vec3<float> place(x, x == 0 ? 0 : 0.15F, 0);
    actor.body = make_body<float>({place, Quat<float>::Identity()}, 2, {1, 1, 1}).value;
    (void)world.add(actor);
  }
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(world.step(1e-3F), Status::kOk);
    EXPECT_EQ(world.report().pairs_dropped, 1U);
  }
  const double time = 0.01;
  for (std::uint16_t slot = 0; slot < 3; ++slot) {
    const auto& body = world.get(world.id_at(slot))->body;
    const double place = static_cast<double>(body.X_WB.p_W.z());
    EXPECT_NEAR(place, -9.81 * time * time / 2, 1e-7) << slot;
    EXPECT_NEAR(body.momentum.linear_W.z(), -2 * 9.81 * time, 1e-6) << slot;
  }
}

// --- filters

constexpr SceneOptions filters_options() {
  SceneOptions scene = straight_spheres();
  scene.filters = true;
  return scene;
}
using Filters = Scene<filters_options, Spheres<float>>;

TEST(FilterScene, PairsThatMayNotMeet_CostNoSearch) {
  const std::array<std::pair<Filter, bool>, 3> cases = {
      {{{1, 0xFFFF}, true}, {{2, 0xFFFE}, false}, {{4, 0x0001}, true}}};
  for (const auto& [filter, meets] : cases) {
    World<Filters> world;
    Actor<Filters> actor;
    actor.radius = 0.1F;
    actor.body.inverse_mass = 1;
    actor.body.momentum_W = {1, 0, 0};
    (void)world.add(actor);  // group 1, meets all
    actor.body.p_W = {1, 0, 0};
    actor.body.momentum_W = {-1, 0, 0};
    actor.filter = filter;
    (void)world.add(actor);
    ASSERT_EQ(world.step(1.0F), Status::kOk);
    EXPECT_EQ(world.report().collisions, meets ? 1U : 0U) << filter.groups;
    EXPECT_EQ(world.report().pairs > 0, meets);
  }
}

// --- bodies of several capsules

constexpr SceneOptions guards_options() {
  SceneOptions scene;
  scene.capsules_per_body = 2;
  scene.max_pairs = 4;
  return scene;
}
using Guards = Scene<guards_options>;

/// A T: a blade along z and a guard across it, along x.
Actor<Guards> tee(const Pose<float>& X_WS) {
  const Capsule<float> blade{{{0, 0, 0}, {0, 0, 1}}, 0.01F};
  const Capsule<float> guard{{{-0.1F, 0, 0}, {0.1F, 0, 0}}, 0.02F};
  const auto compound = make_compound<float>({{blade, 1000.0F}, {guard, 1000.0F}}, X_WS).value;
  Actor<Guards> actor;
  actor.body = compound.body;
  for (const auto& capsule : compound.capsules_B) actor.capsules_B.push(capsule);
  return actor;
}

TEST(CompoundScene, EventNamesThePartThatIsHit) {
  for (const bool hits_guard : {false, true}) {
    World<Guards> world;
    (void)world.add(tee({}));
    Actor<Guards> ball;
    ball.capsules_B.push(Capsule<float>::sphere(Vec3<float>::Zero(), 0.01F));
    const float x = hits_guard ? 0.08F : 0.0F;
    const float z = hits_guard ? 0.0F : 0.8F;
    ball.body =
        make_body<float>({{x, -0.5F, z}, Quat<float>::Identity()}, 0.1F, {1e-5F, 1e-5F, 1e-5F})
            .value;
    ball.body.momentum.linear_W = {0, 0.5F, 0};
    (void)world.add(ball);
    ASSERT_EQ(world.step(0.2F), Status::kOk);
    ASSERT_GE(world.events().size(), 1);
    EXPECT_EQ(world.events()[0].body_A, 0);
    EXPECT_EQ(world.events()[0].part_A, hits_guard ? 1 : 0);
    EXPECT_EQ(world.events()[0].part_B, 0);
    EXPECT_NEAR(world.events()[0].contact.point_W.x(), x, 1e-4);
    EXPECT_NEAR(world.events()[0].contact.point_W.z(), z, 1e-4);
    EXPECT_LT(
        world.get(world.id_at(0))
            ->body.momentum.angular_W.dot(hits_guard ? vec<float>(0, 0, -1) : vec<float>(1, 0, 0)),
        0)
        << "it turns away from the blow";
  }
}

TEST(CompoundScene, BodyWithoutParts_IsRefused) {
  World<Guards> world;
  Actor<Guards> actor;
  EXPECT_EQ(world.add(actor).status, Status::kInvalidArgument);
}

TEST(CompoundScene, PartsOfOneBody_NeverMeet) {
  World<Guards> world;
  (void)world.add(tee({}));
  ASSERT_EQ(world.step(0.1F), Status::kOk);
  EXPECT_EQ(world.report().pairs, 0U);
}

// --- order of simultaneous contacts

constexpr SceneOptions elastic_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  return scene;
}
using Elastic = Scene<elastic_options>;

// The middle ball is hit from both sides at once; the lower pair is answered first, however the
// last bits of the two times fall.
TEST(Order, ContactsAtTheSameTime_AreAnsweredByTheirNames) {
  for (const int ulps : {-1, 0, 1}) {
    World<Elastic> world;
    Actor<Elastic> actor;
    actor.capsule_B.radius = 0.1F;
    actor.restitution = 1;
    for (int i = 0; i < 3; ++i) {
      float x = static_cast<float>(i - 1);
      if (i == 2 && ulps != 0) x = std::nextafter(x, ulps > 0 ? 2.0F : 0.0F);
      actor.body = make_body<float>({{x, 0, 0}, Quat<float>::Identity()}, 1, {1, 1, 1}).value;
      actor.body.momentum.linear_W = {static_cast<float>(1 - i), 0, 0};
      (void)world.add(actor);
    }
    ASSERT_EQ(world.step(1.0F), Status::kOk);
    ASSERT_GE(world.events().size(), 2);
    EXPECT_EQ(world.events()[0].body_A, 0) << ulps;
    EXPECT_EQ(world.events()[0].body_B, 1) << ulps;
    EXPECT_NEAR(world.get(world.id_at(0))->body.momentum.linear_W.x(), -1, 1e-4);
    EXPECT_NEAR(world.get(world.id_at(2))->body.momentum.linear_W.x(), 1, 1e-4);
  }
}

}  // namespace
}  // namespace batuta
