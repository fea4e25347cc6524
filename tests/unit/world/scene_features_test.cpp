// SPDX-License-Identifier: MIT
// What a scene leaves out takes no room: in its actors, its settings and its world.
#include <gtest/gtest.h>

#include "batuta/fencing/duel.hpp"
#include "batuta/world/scene_cost.hpp"
#include "batuta/world/scenes.hpp"

namespace batuta {
using namespace detail;
namespace {

constexpr SceneOptions no_restitution_options() {
  SceneOptions scene = two_blades();
  scene.restitution = false;
  return scene;
}
using NoRestitution = Scene<no_restitution_options>;
constexpr SceneOptions no_owners_options() {
  SceneOptions scene = two_blades();
  scene.owners = false;
  return scene;
}
using NoOwners = Scene<no_owners_options>;
constexpr SceneOptions with_filters_options() {
  SceneOptions scene = two_blades();
  scene.filters = true;
  return scene;
}
using WithFilters = Scene<with_filters_options>;
constexpr SceneOptions with_gravity_options() {
  SceneOptions scene = two_blades();
  scene.gravity = true;
  return scene;
}
using WithGravity = Scene<with_gravity_options>;
constexpr SceneOptions settling_options() {
  SceneOptions scene = two_blades();
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Settling = Scene<settling_options>;
constexpr SceneOptions rubbing_options() {
  SceneOptions scene = settling_options();
  scene.friction = true;
  return scene;
}
using Rubbing = Scene<rubbing_options>;
constexpr SceneOptions sleeping_options() {
  SceneOptions scene = settling_options();
  scene.sleep = true;
  return scene;
}
using Sleeping = Scene<sleeping_options>;
constexpr SceneOptions no_events_options() {
  SceneOptions scene = two_blades();
  scene.max_events = 0;
  return scene;
}
using NoEvents = Scene<no_events_options>;
using Seedless = Scene<two_blades, Translation<float>>;
constexpr SceneOptions plainest_options() {
  SceneOptions scene = two_blades();
  scene.resting = RestingContact::kNone;
  scene.restitution = false;
  scene.owners = false;
  scene.max_events = 0;
  return scene;
}
using Plainest = Scene<plainest_options, Translation<float>>;
constexpr SceneOptions straight_options() {
  SceneOptions scene = plainest_options();
  scene.engine = Engine::kSmall;
  scene.rotation = false;
  return scene;
}
using Straight = Scene<straight_options, Translation<float>>;
using Balls = Scene<straight_options, Spheres<float>>;
constexpr SceneOptions two_parts_options() {
  SceneOptions scene = two_blades();
  scene.capsules_per_body = 2;
  return scene;
}
using TwoParts = Scene<two_parts_options>;

template <class SceneT>
constexpr std::size_t kActor = sizeof(Actor<SceneT>);
template <class SceneT>
constexpr std::size_t kWorld = sizeof(World<SceneT>);
template <class SceneT>
constexpr std::size_t kSettings = sizeof(WorldSettings<SceneT>);

TEST(SceneFeatures, ActorsFeatures_TakeTheRoomOfTheirMembers) {
  EXPECT_GE(kActor<TwoBlades> - kActor<NoRestitution>, sizeof(float));
  EXPECT_GE(kActor<Rubbing> - kActor<Settling>, sizeof(float));
  EXPECT_GT(kActor<TwoBlades>, kActor<NoOwners>);
  EXPECT_GT(kActor<WithFilters>, kActor<NoOwners>);
  EXPECT_GE(kActor<TwoParts> - kActor<TwoBlades>, sizeof(Capsule<float>));
}

// Where bodies turn, the controller's own place, which no type is without, is the only other thing.
TEST(SceneFeatures, PlainestActor_IsABodyAndItsShape) {
  EXPECT_LE(kActor<Plainest>, sizeof(Body<float>) + sizeof(Capsule<float>) + sizeof(float));
  EXPECT_EQ(kActor<Straight>, sizeof(StraightBody<float>) + sizeof(Capsule<float>));
  EXPECT_EQ(kActor<Balls>, sizeof(StraightBody<float>) + sizeof(float));
}

TEST(SceneFeatures, Settings_HoldWhatTheSceneKnows) {
  using Search = AdvancementOptions<float>;
  EXPECT_EQ(kSettings<Plainest>, sizeof(Search));
  EXPECT_EQ(kSettings<TwoBlades>, sizeof(detail::RestSettings<float>) + sizeof(Search));
  EXPECT_EQ(kSettings<WithGravity>, sizeof(Vec3<float>) + kSettings<TwoBlades>);
  EXPECT_EQ(kSettings<Balls>, sizeof(float));
}

TEST(SceneFeatures, WorldWithoutAFeature_IsSmaller) {
  EXPECT_LT(kWorld<NoRestitution>, kWorld<TwoBlades>);
  EXPECT_LT(kWorld<NoOwners>, kWorld<TwoBlades>);
  EXPECT_LT(kWorld<TwoBlades>, kWorld<WithFilters>);
  EXPECT_LT(kWorld<TwoBlades>, kWorld<WithGravity>);
  EXPECT_LT(kWorld<TwoBlades>, kWorld<TwoParts>);
  EXPECT_LT(kWorld<Settling>, kWorld<Rubbing>);
  EXPECT_LT(kWorld<Settling>, kWorld<Sleeping>);
  EXPECT_LT(kWorld<Seedless>, kWorld<TwoBlades>);
  EXPECT_LT(kWorld<Straight>, kWorld<Plainest>);
  EXPECT_LT(kWorld<Balls>, kWorld<Straight>);
}

TEST(SceneFeatures, WorldWithoutEvents_HasNoRoomForThem) {
  const std::size_t events = TwoBlades::kMaxEvents * sizeof(ContactEvent<float>);
  EXPECT_GE(kWorld<TwoBlades> - kWorld<NoEvents>, events);
}

/// A scene with room for some more, written out: what Enlarged is to be.
template <class SceneT, int kPairs, int kEvents>
constexpr SceneOptions roomier_options() {
  const SceneOptions& stated = SceneT::kStated;  // of a duel, too: its world is a world
  SceneOptions scene = stated;
  scene.max_pairs = stated.max_pairs + kPairs;
  scene.max_events = stated.max_events + kEvents;
  return scene;
}
template <class SceneT, int kPairs, int kEvents>
using Roomier = Scene<roomier_options<SceneT, kPairs, kEvents>, typename SceneT::Search,
                      typename SceneT::Controller>;

/// What is stated for one more holds for many: at least what they take, and hardly more.
void expect_rate(std::size_t stated, std::size_t taken, std::size_t count) {
  EXPECT_GE(stated * count, taken);
  EXPECT_LE(9 * stated * count, 10 * taken);
}

template <class SceneT>
void expect_cost_is_that_of_the_world() {
  constexpr int kMore = 64;
  const SceneCost cost = scene_cost<SceneT>;
  EXPECT_EQ(cost.world, kWorld<SceneT>);
  EXPECT_GE(cost.body, kActor<SceneT>);
  expect_rate(cost.pair, kWorld<Roomier<SceneT, kMore, 0>> - kWorld<SceneT>, kMore);
  expect_rate(cost.event, kWorld<Roomier<SceneT, 0, kMore>> - kWorld<SceneT>, kMore);
  EXPECT_EQ(cost.event, sizeof(ContactEvent<float>));
  EXPECT_EQ(cost.rounds, static_cast<std::uint64_t>(World<SceneT>::kMaxRounds));
  EXPECT_EQ(cost.evaluations,
            cost.rounds * static_cast<std::uint64_t>(SceneT::kMaxPairs) * SceneT::kBudget);
}

TEST(SceneCost, ReadyMadeScenes_CostWhatTheirWorldsTake) {
  expect_cost_is_that_of_the_world<TwoBlades>();
  expect_cost_is_that_of_the_world<DetectionOnly>();
  expect_cost_is_that_of_the_world<Rack>();
  expect_cost_is_that_of_the_world<fencing::Duel<>::SceneType>();
  EXPECT_EQ(scene_cost<StraightSpheres>.world, kWorld<StraightSpheres>);
  EXPECT_EQ(scene_cost<StraightSpheres>.event, 0U);
}

TEST(SceneCost, CostIsAConstant) {
  static_assert(scene_cost<StraightSpheres>.world <= 2048, "eight balls fit into 2 KiB");
  static_assert(scene_cost<StraightSpheres>.event == 0, "and have no events");
  static_assert(scene_cost<TwoBlades>.rounds > 0, "rounds are bounded");
}

}  // namespace
}  // namespace batuta
