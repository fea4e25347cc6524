// SPDX-License-Identifier: MIT
// What a random search for weak places found: each case failed once.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "batuta/record/snapshot.hpp"
#include "batuta/record/world.hpp"
#include "scenes.hpp"

namespace batuta {
namespace {

constexpr float kDt = 0.001F;

/// Falls, settles and sleeps; room for two pairs, so that a third one holds its bodies.
constexpr SceneOptions tight_scene_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.max_bodies = 4;
  scene.max_pairs = 2;
  scene.sleep_time = 0.005F;
  scene.gravity = true;
  scene.sleep = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using TightScene = Scene<tight_scene_options, Advancement<float>, test::AnyFlight<float>>;

/// Flies past a ball on the post, in a box that holds both.
Actor<TightScene> passing(float x, float z) {
  Actor<TightScene> actor = test::ball<TightScene>(0, 0.1, 0);
  actor.body.X_WB.p_W = {x, 0, z};
  actor.body.momentum.linear_W = {1000, 0, 1000};
  return actor;
}

TEST(WorldAttack, HeldSleeperIsSaved_SleepsOnWhereItIsRestored) {
  const auto world = std::make_unique<World<TightScene>>();
  ASSERT_TRUE(world->add(test::post<TightScene>(0, 0.1)).ok());
  Actor<TightScene> ball = test::ball<TightScene>(0, 0.1, 0);
  ball.body.X_WB.p_W.z() = 0.2001F;
  ball.restitution = 0;
  const auto sleeper = world->add(ball);
  ASSERT_TRUE(sleeper.ok());
  for (int i = 0; i < 100; ++i) ASSERT_EQ(world->step(kDt), Status::kOk);
  ASSERT_TRUE(world->is_asleep(sleeper.value));
  ASSERT_TRUE(world->add(passing(-0.5F, 0.1F)).ok());
  ASSERT_TRUE(world->add(passing(-0.2F, 0.4F)).ok());
  ASSERT_EQ(world->step(kDt), Status::kOk);
  ASSERT_GT(world->report().pairs_dropped, 0U);
  ASSERT_TRUE(world->is_asleep(sleeper.value));

  const auto bytes = std::make_unique<std::array<std::uint8_t, kSnapshotRoom<World<TightScene>>>>();
  const auto size = save(*world, bytes->data(), static_cast<int>(bytes->size()));
  ASSERT_TRUE(size.ok());
  const auto restored = std::make_unique<World<TightScene>>();
  ASSERT_EQ(restore(*restored, bytes->data(), size.value), Restored::kOk);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(world->step(kDt), Status::kOk);
    ASSERT_EQ(restored->step(kDt), Status::kOk);
    ASSERT_EQ(hash_of(*world), hash_of(*restored)) << "step " << i;
  }
}

// A turn that cannot be known is left out; the body falls as any other.
TEST(WorldAttack, TooFastASpinUnderGravity_FallsWithoutATurn) {
  const auto world = std::make_unique<World<TightScene>>();
  Actor<TightScene> top = test::ball<TightScene>(0, 0.1, 0);
  top.body.inverse_moments = {100, 200, 300};
  top.body.momentum.angular_W = {0, 0, 15};  // 4500 rad/s: more than half a turn in a step
  const auto id = world->add(top);
  ASSERT_TRUE(id.ok());
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(world->step(kDt), Status::kOk);
    ASSERT_EQ(world->report().plans_invalid, 1U);
    ASSERT_FALSE(world->report().complete());
  }
  const Actor<TightScene>& after = *world->get(id.value);
  EXPECT_NEAR(after.body.X_WB.p_W.z(), -9.81 * 0.1 * 0.1 / 2, 1e-5 * 0.05);
  EXPECT_NEAR(after.body.momentum.linear_W.z(), -9.81 * 0.1, 1e-5);
  EXPECT_EQ(after.body.momentum.angular_W.z(), 15.0F);
}

constexpr SceneOptions two_part_scene_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.capsules_per_body = 2;
  return scene;
}
using TwoPartScene = Scene<two_part_scene_options, Advancement<float>, test::AnyFlight<float>>;

/// The same, with contacts that last.
constexpr SceneOptions two_resting_parts_options() {
  SceneOptions scene = two_part_scene_options();
  scene.gravity = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using RestingParts = Scene<two_resting_parts_options, Advancement<float>, test::AnyFlight<float>>;

/// A step after which the second capsule of a body touches a ball that is held; that capsule is
/// then taken off.
template <class SceneT>
struct PartTakenOff {
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  Handle<Actor<SceneT>> id;

  PartTakenOff() {
    const auto sphere = [](float z) { return Capsule<float>::sphere({0, 0, z}, 0.1F); };
    Actor<SceneT> ground;
    ground.controller = Fixed<float>{};
    EXPECT_TRUE(ground.capsules_B.push(sphere(0)));
    EXPECT_TRUE(world->add(ground).ok());
    Actor<SceneT> body;
    body.body = make_body<float>({{0, 0, 0.2005F}, Quat<float>::Identity()}, 1, {1, 1, 1}).value;
    body.body.momentum.linear_W = {0, 0, -1};
    EXPECT_TRUE(body.capsules_B.push(sphere(0.5F)));
    EXPECT_TRUE(body.capsules_B.push(sphere(0)));
    const auto added = world->add(body);
    EXPECT_TRUE(added.ok());
    id = added.value;
    EXPECT_EQ(world->step(kDt), Status::kOk);
    EXPECT_EQ(world->events().size(), 1);
    EXPECT_EQ(world->events()[0].part_B, 1);
    world->get(id)->capsules_B.remove_swapping(1);
  }
};

TEST(WorldAttack, PartInContactIsTakenOff_ContactEndsWithoutAnEvent) {
  PartTakenOff<TwoPartScene> rig;
  rig.world->get(rig.id)->body.momentum.linear_W = {0, 0, 1};
  ASSERT_EQ(rig.world->step(kDt), Status::kOk);
  EXPECT_EQ(rig.world->events().size(), 0);
  EXPECT_TRUE(rig.world->report().complete());
}

/// What touched a part that is no more is a state that a world may be in, and may be saved in.
template <class SceneT>
void expect_saved_without_the_part() {
  PartTakenOff<SceneT> rig;
  std::vector<std::uint8_t> bytes(kSnapshotRoom<World<SceneT>>);
  const auto size = save(*rig.world, bytes.data(), static_cast<int>(bytes.size()));
  ASSERT_TRUE(size.ok());
  const auto restored = std::make_unique<World<SceneT>>();
  ASSERT_EQ(restore(*restored, bytes.data(), size.value), Restored::kOk);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(rig.world->step(kDt), Status::kOk);
    ASSERT_EQ(restored->step(kDt), Status::kOk);
    ASSERT_EQ(hash_of(*rig.world), hash_of(*restored)) << "step " << i;
  }
}

TEST(WorldAttack, PartInContactIsTakenOffAndTheWorldSaved_GoesOnWithTheSameBits) {
  expect_saved_without_the_part<TwoPartScene>();
  expect_saved_without_the_part<RestingParts>();
}

}  // namespace
}  // namespace batuta
