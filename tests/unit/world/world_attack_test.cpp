// SPDX-License-Identifier: MIT
// What a random search for weak places found: each case failed once.
#include <gtest/gtest.h>

#include <array>
#include <limits>
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

/// The state of a world in another one, through bytes.
template <class SceneT>
void restore_through_bytes(const World<SceneT>& from, World<SceneT>& into) {
  std::vector<std::uint8_t> bytes(kSnapshotRoom<World<SceneT>>);
  const auto size = save(from, bytes.data(), static_cast<int>(bytes.size()));
  ASSERT_TRUE(size.ok());
  ASSERT_EQ(restore(into, bytes.data(), size.value), Restored::kOk);
}

// The boxes of bodies that are no more stayed, and others bounced off them.
TEST(WorldAttack, WorldInUseTakesASavedOne_NothingOfItsOwnIsLeft) {
  using SceneT = test::FlightScene<float>;
  const auto saved = std::make_unique<World<SceneT>>();
  const auto ball = saved->add(test::ball<SceneT>(-1, 0.1, 2));
  ASSERT_TRUE(ball.ok());
  const auto used = std::make_unique<World<SceneT>>();
  ASSERT_TRUE(used->add(test::ball<SceneT>(50, 0.1, 0)).ok());
  ASSERT_TRUE(used->add(test::post<SceneT>(0, 0.1)).ok());
  ASSERT_EQ(used->step(kDt), Status::kOk);
  restore_through_bytes(*saved, *used);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(saved->step(kDt), Status::kOk);
    ASSERT_EQ(used->step(kDt), Status::kOk);
    ASSERT_EQ(hash_of(*saved), hash_of(*used)) << "step " << i;
    ASSERT_EQ(used->report().pairs, 0U);
  }
  EXPECT_NEAR(used->get(used->id_at(0))->body.X_WB.p_W.x(), 1, 1e-4);  // -1 m + 1 s at 2 m/s
}

/// A ball that sleeps on a post, in a world with friction.
constexpr SceneOptions lying_scene_options() {
  SceneOptions scene = tight_scene_options();
  scene.friction = true;
  return scene;
}
using LyingScene = Scene<lying_scene_options, Advancement<float>, test::AnyFlight<float>>;
struct SleeperOnPost {
  std::unique_ptr<World<LyingScene>> world = std::make_unique<World<LyingScene>>();
  Handle<Actor<LyingScene>> post, ball;

  explicit SleeperOnPost(int steps = 100) {
    post = world->add(test::post<LyingScene>(0, 0.1)).value;
    Actor<LyingScene> actor = test::ball<LyingScene>(0, 0.1, 0);
    actor.body.X_WB.p_W.z() = 0.2001F;
    actor.restitution = 0;
    ball = world->add(actor).value;
    for (int i = 0; i < steps; ++i) EXPECT_EQ(world->step(kDt), Status::kOk);
    EXPECT_EQ(world->is_asleep(ball), steps == 100);
  }
  float height() const { return world->get(ball)->body.X_WB.p_W.z(); }
  /// Saved as it is, it goes on with the same bits.
  void expect_to_go_on_alike(int steps) {
    const auto restored = std::make_unique<World<LyingScene>>();
    restore_through_bytes(*world, *restored);
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(world->step(kDt), Status::kOk);
      ASSERT_EQ(restored->step(kDt), Status::kOk);
      ASSERT_EQ(hash_of(*world), hash_of(*restored)) << "step " << i;
    }
  }
};

// It slept on in the air where the world had been saved before the step.
TEST(WorldAttack, SupportIsMadeUnusableAndTheWorldSaved_SleeperFalls) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const auto spoil = [](int how, Body<float>& body) {
    if (how == 0) body.X_WB.p_W.x() = kNan;
    if (how == 1) body.X_WB.p_W.x() = 1e30F;
    if (how == 2) body.X_WB.q_WB.x() = kNan;
  };
  for (int how = 0; how < 3; ++how) {
    SleeperOnPost rig;
    const float before = rig.height();
    spoil(how, rig.world->get(rig.post)->body);
    rig.expect_to_go_on_alike(100);
    EXPECT_NEAR(before - rig.height(), 9.81F * 0.1F * 0.1F / 2, 1e-4F) << how;
  }
}

// A support that the caller moves starts no new count for who is awake on it: what is saved does
// not tell whether it stood before.
TEST(WorldAttack, SupportIsMovedAndTheWorldSaved_WhoIsNearlyAsleepGoesOnAlike) {
  SleeperOnPost rig(4);
  rig.world->get(rig.post)->body.X_WB.p_W.z() -= 1e-5F;
  rig.expect_to_go_on_alike(50);
  EXPECT_TRUE(rig.world->is_asleep(rig.ball));
}

// What is no number has a sign, and bits that mean nothing: an archive keeps neither.
TEST(WorldAttack, NoNumberWithASign_IsOneAsAnyOther) {
  const float of_x86 = -std::numeric_limits<float>::quiet_NaN();  // 0 / 0 there
  for (const bool is_post : {false, true}) {
    SleeperOnPost rig;
    rig.world->get(is_post ? rig.post : rig.ball)->friction = of_x86;
    rig.expect_to_go_on_alike(20);
  }
}

// Stepping has no tolerance of a contact to ask for, and did not compile.
TEST(WorldAttack, SteppingWithContactsThatLast_HoldsABall) {
  using SceneT = Scene<tight_scene_options, Stepping<float>, test::AnyFlight<float>>;
  const auto world = std::make_unique<World<SceneT>>();
  ASSERT_TRUE(world->add(test::post<SceneT>(0, 0.1)).ok());
  Actor<SceneT> ball = test::ball<SceneT>(0, 0.1, 0);
  ball.body.X_WB.p_W.z() = 0.2001F;
  ball.restitution = 0;
  const auto id = world->add(ball);
  ASSERT_TRUE(id.ok());
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(world->step(kDt), Status::kOk);
    ASSERT_TRUE(world->report().complete());
  }
  EXPECT_NEAR(world->get(id.value)->body.X_WB.p_W.z(), 0.2F, 2e-4F);
  EXPECT_TRUE(world->is_asleep(id.value));
}

}  // namespace
}  // namespace batuta
