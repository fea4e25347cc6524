// SPDX-License-Identifier: MIT
// Actors from capsules, in scenes of every kind of body.
#include "batuta/world/make_actor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

constexpr SceneOptions two_part_options() {
  SceneOptions scene = two_blades();
  scene.capsules_per_body = 2;
  return scene;
}
constexpr SceneOptions slider_options() {
  SceneOptions scene = two_blades();
  scene.rotation = false;
  scene.resting = RestingContact::kNone;
  return scene;
}
using TwoParts = Scene<two_part_options>;
using Sliders = Scene<slider_options, Translation<float>>;

/// Beside the origin of G, and along none of its axes.
const Capsule<float> kRod = {{{0.1F, 0.2F, -0.3F}, {0.4F, -0.1F, 0.5F}}, 0.02F};
const Pose<float> kPlace = {{1, 2, 3}, Quat<float>(0.5F, -0.5F, 0.5F, 0.5F)};
constexpr float kIron = 7850;
constexpr float kNear = 2e-6F;

Vec3<float> middle_W() {
  return to_world(kPlace, Vec3<float>((kRod.axis.a + kRod.axis.b) / 2));
}
/// Cylinder and ball.
float mass_of(const Capsule<float>& capsule) {
  const double r = static_cast<double>(capsule.radius);
  const double core = static_cast<double>((capsule.axis.b - capsule.axis.a).norm());
  return static_cast<float>(static_cast<double>(kIron) * M_PI * r * r * (core + 4 * r / 3));
}

TEST(MakeActor, WhereBodiesTurn_IsTheSolidBody) {
  const Twist<float> twist = {{1, -2, 3}, {4, 5, -6}};
  const auto made = make_actor<TwoBlades>(kRod, kIron, kPlace, twist);
  ASSERT_TRUE(made.ok());
  const auto& body = made.value.body;
  EXPECT_LT((body.X_WB.p_W - middle_W()).norm(), kNear);
  EXPECT_NEAR(1 / body.inverse_mass, mass_of(kRod), 1e-5F * mass_of(kRod));
  const Twist<float> moves = twist_of(body);
  EXPECT_LT((moves.v_W - twist.v_W).norm(), 1e-5F);
  // Its spin about the rod comes back from a momentum that is rounded as a whole, most of which
  // turns the rod about its other axes.
  const float unlike = body.inverse_moments.maxCoeff() / body.inverse_moments.minCoeff();
  EXPECT_LT((moves.w_W - twist.w_W).norm(), kRoundOff<float> * unlike * twist.w_W.norm());
  const Capsule<float> shape_W = to_world(body.X_WB, made.value.capsule_B);
  EXPECT_LT((shape_W.axis.a - to_world(kPlace, kRod.axis.a)).norm(), kNear);
  EXPECT_LT((shape_W.axis.b - to_world(kPlace, kRod.axis.b)).norm(), kNear);
  World<TwoBlades> world;
  EXPECT_TRUE(world.add(made.value).ok());
}

TEST(MakeActor, OfSeveralParts_HasItsCapsuleAsTheFirst) {
  const auto one = make_actor<TwoBlades>(kRod, kIron, kPlace);
  const auto made = make_actor<TwoParts>(kRod, kIron, kPlace);
  ASSERT_TRUE(one.ok() && made.ok());
  ASSERT_EQ(made.value.capsules_B.size(), 1);
  EXPECT_EQ(made.value.capsules_B[0].axis.b, one.value.capsule_B.axis.b);
  EXPECT_EQ(made.value.body.inverse_moments, one.value.body.inverse_moments);
}

TEST(MakeActor, WhereNothingTurns_ShapeIsTurnedIntoTheWorld) {
  const Twist<float> twist = {{1, -2, 3}, {0, 0, 0}};
  const auto made = make_actor<Sliders>(kRod, kIron, kPlace, twist);
  ASSERT_TRUE(made.ok());
  const auto& actor = made.value;
  EXPECT_LT((actor.body.p_W - middle_W()).norm(), kNear);
  EXPECT_LT((actor.body.p_W + actor.capsule_B.axis.a - to_world(kPlace, kRod.axis.a)).norm(),
            kNear);
  EXPECT_LT((actor.body.p_W + actor.capsule_B.axis.b - to_world(kPlace, kRod.axis.b)).norm(),
            kNear);
  EXPECT_LT((velocity_of(actor.body) - twist.v_W).norm(), 1e-5F);
  EXPECT_NEAR(1 / actor.body.inverse_mass, mass_of(kRod), 1e-5F * mass_of(kRod));
  World<Sliders> world;
  EXPECT_TRUE(world.add(actor).ok());
  const Twist<float> turning = {{1, 0, 0}, {0, 0, 1e-3F}};
  EXPECT_EQ(make_actor<Sliders>(kRod, kIron, kPlace, turning).status, Status::kInvalidArgument);
}

TEST(MakeActor, OfSpheres_TakesBallsOnly) {
  const auto ball = Capsule<float>::sphere({0.1F, 0.2F, 0.3F}, 0.05F);
  const auto made = make_actor<StraightSpheres>(ball, kIron, kPlace, {{0, 0, 2}, {0, 0, 0}});
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made.value.radius, 0.05F);
  EXPECT_LT((made.value.body.p_W - to_world(kPlace, ball.axis.a)).norm(), kNear);
  EXPECT_NEAR(1 / made.value.body.inverse_mass, mass_of(ball), 1e-5F * mass_of(ball));
  World<StraightSpheres> world;
  EXPECT_TRUE(world.add(made.value).ok());
  EXPECT_EQ(make_actor<StraightSpheres>(kRod, kIron, kPlace).status, Status::kInvalidArgument);
}

TEST(MakeActor, InfiniteDensity_CannotBeMoved) {
  const auto post = make_actor<TwoBlades>(kRod, INFINITY, kPlace);
  ASSERT_TRUE(post.ok());
  EXPECT_TRUE(is_fixed(post.value.body));
  const auto contact_tolerance = make_actor<Sliders>(kRod, INFINITY, kPlace);
  ASSERT_TRUE(contact_tolerance.ok());
  EXPECT_EQ(contact_tolerance.value.body.inverse_mass, 0);
}

TEST(MakeActor, WhatSolidBodyRefuses_IsRefused) {
  for (const float density : {0.0F, -1.0F, NAN}) {
    EXPECT_EQ(make_actor<TwoBlades>(kRod, density, kPlace).status, Status::kInvalidArgument);
    EXPECT_EQ(make_actor<Sliders>(kRod, density, kPlace).status, Status::kInvalidArgument);
  }
  Pose<float> nowhere = kPlace;
  nowhere.q_WB.coeffs().setZero();
  EXPECT_EQ(make_actor<TwoBlades>(kRod, 1.0F, nowhere).status, Status::kInvalidArgument);
  EXPECT_EQ(make_actor<Sliders>(kRod, 1.0F, nowhere).status, Status::kInvalidArgument);
}

}  // namespace
}  // namespace batuta
