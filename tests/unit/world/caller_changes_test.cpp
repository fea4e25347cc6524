// SPDX-License-Identifier: MIT
// A caller moves, changes or pushes bodies between steps: the next step takes them as they are, as
// a world would into which they were put so.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

constexpr SceneOptions settling_options() {
  SceneOptions scene;
  scene.max_bodies = 6;
  scene.max_pairs = 15;
  scene.max_contacts = 2;
  scene.max_events = 16;
  scene.resting = RestingContact::kSettling;
  scene.gravity = true;
  return scene;
}
using Settling = Scene<settling_options>;

constexpr float kBallRadius = 0.1F;

template <class SceneT>
Handle<Actor<SceneT>> add_ball(World<SceneT>& world, float y, float gap) {
  const Capsule<float> ball = {{{0, 0, 0}, {0, 0, 0}}, kBallRadius};
  const Pose<float> X_WB = {{0, y, kBallRadius + gap}, Quat<float>::Identity()};
  return world.add(make_actor<SceneT>(ball, 1000.0F, X_WB).value).value;
}

/// A fixed bar along x whose top is at z = 0.
template <class SceneT>
void add_pad(World<SceneT>& world, float y) {
  const Capsule<float> bar = {{{-1, y, -0.1F}, {1, y, -0.1F}}, 0.1F};
  const auto actor = make_actor<SceneT>(bar, std::numeric_limits<float>::infinity(), {});
  ASSERT_TRUE(world.add(actor.value).ok());
}

/// Two balls on two of three pads, and room for two contacts.
class FullList : public ::testing::Test {
 protected:
  static constexpr float kBetween = 5;

  FullList() {
    for (int i = 0; i < 3; ++i) add_pad(world, kBetween * static_cast<float>(i));
    moved = add_ball(world, 0, 5e-5F);
    (void)add_ball(world, kBetween, 5e-5F);
    steps(50);
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(world.step(1e-3F), Status::kOk);
      EXPECT_TRUE(world.report().complete());
      EXPECT_EQ(world.report().contacts_dropped, 0);
    }
  }
  const Body<float>& ball() const { return world.get(moved)->body; }

  World<Settling> world;
  Handle<Actor<Settling>> moved;
};

TEST_F(FullList, OneIsPutOnTheThirdPad_ItsNewContactTakesThePlaceOfTheOld) {
  world.get(moved)->body.X_WB.p_W.y() = 2 * kBetween;
  steps(500);
  auto& body = world.get(moved)->body;
  body.momentum.linear_W = {0.5F / body.inverse_mass, 0, 0};  // 0.5 m/s, and nothing resists
  steps(500);
  EXPECT_NEAR(std::as_const(*this).ball().X_WB.p_W.x(), 0.25F, 1e-3F);
}

/// Neither of the two can be moved then, and no pair asks for their contact again.
TEST_F(FullList, OneIsFixedElsewhere_ItsContactGivesItsPlaceBack) {
  auto& fixed = world.get(moved)->body;
  fixed.inverse_mass = 0;
  fixed.inverse_moments.setZero();
  fixed.momentum = {};
  fixed.X_WB.p_W = {0, -2 * kBetween, 3};
  steps(1);
  const auto third = add_ball(world, 2 * kBetween, 5e-5F);
  auto& body = world.get(third)->body;
  body.momentum.linear_W = {0.5F / body.inverse_mass, 0, 0};
  steps(500);
  EXPECT_NEAR(std::as_const(world).get(third)->body.X_WB.p_W.x(), 0.25F, 1e-3F);
}

/// What does not fit is told, as long as it does not, and no longer.
TEST_F(FullList, AThirdBall_IsTold_UntilItIsTakenAway) {
  const auto third = add_ball(world, 2 * kBetween, 5e-5F);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(world.step(1e-3F), Status::kOk);
    EXPECT_FALSE(world.report().complete());
    EXPECT_EQ(world.report().contacts_dropped, 1);
  }
  EXPECT_EQ(world.remove(third), Status::kOk);
  steps(20);
}

std::vector<EventKind> kinds_of(const World<Settling>& world) {
  std::vector<EventKind> kinds;
  for (const auto& event : world.events()) kinds.push_back(event.kind);
  return kinds;
}

/// A ball that was thrown up from its floor, and has just ended its touch.
class ThrownUp : public ::testing::Test {
 protected:
  ThrownUp() {
    add_pad(world, 0);
    ball = add_ball(world, 0, 1e-4F);
    for (int i = 0; i < 30; ++i) EXPECT_EQ(world.step(1e-3F), Status::kOk);
    auto& body = world.get(ball)->body;
    body.momentum.linear_W = {0, 0, 0.26F / body.inverse_mass};
    EXPECT_EQ(world.step(1e-3F), Status::kOk);
    EXPECT_EQ(kinds_of(world), std::vector<EventKind>{EventKind::kEnd});
  }
  /// Events of so many steps, all of them complete.
  std::vector<EventKind> step(int count, float dt) {
    std::vector<EventKind> kinds;
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(world.step(dt), Status::kOk);
      EXPECT_TRUE(world.report().complete());
      for (const EventKind kind : kinds_of(world)) kinds.push_back(kind);
    }
    return kinds;
  }

  World<Settling> world;
  Handle<Actor<Settling>> ball;
};

TEST_F(ThrownUp, LongerSteps_InWhichTheGapIsContactAgain_TellABegin_AndItsEnd) {
  EXPECT_EQ(step(120, 1.0F / 30), std::vector<EventKind>{EventKind::kBegin});
  world.get(ball)->body.X_WB.p_W.z() += 1;
  EXPECT_EQ(step(1, 1.0F / 30), std::vector<EventKind>{EventKind::kEnd});
}

TEST_F(ThrownUp, AnotherSeparation_InWhichTheGapIsContactAgain_TellsABegin) {
  world.get(ball)->body.momentum.linear_W.setZero();
  auto settings = world.settings();
  settings.separation = 1e-2F;
  ASSERT_EQ(world.configure(settings), Status::kOk);
  EXPECT_EQ(step(30, 1e-3F), std::vector<EventKind>{EventKind::kBegin});
}

template <RestingContact kRests>
constexpr SceneOptions still_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  scene.max_events = 8;
  scene.filters = true;
  scene.resting = kRests;
  return scene;
}

/// Two balls that stand still, 1 m apart.
template <class SceneT>
class Still : public ::testing::Test {
 protected:
  Still() {
    grown = add_ball(world, 0, 0);
    (void)add_ball(world, 1, 0);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(world.step(1e-3F), Status::kOk);
  }
  World<SceneT> world;
  Handle<Actor<SceneT>> grown;
};
using StillScenes = ::testing::Types<Scene<still_options<RestingContact::kNone>>,
                                     Scene<still_options<RestingContact::kSeparation>>,
                                     Scene<still_options<RestingContact::kSettling>>>;
TYPED_TEST_SUITE(Still, StillScenes);

TYPED_TEST(Still, OneThatIsMadeLarger_IsSeenInTheOther) {
  this->world.get(this->grown)->capsule_B.radius = 1.2F;
  ASSERT_EQ(this->world.step(1e-3F), Status::kOk);
  EXPECT_GE(this->world.report().overlaps_at_start, 1);
  EXPECT_NEAR(this->world.report().deepest_overlap, 0.3F, 1e-5F);
}

TYPED_TEST(Still, OneThatIsSteered_IsSeenWhereItIsPut) {
  this->world.steer(this->grown)->body.X_WB.p_W.y() = 0.9F;
  ASSERT_EQ(this->world.step(1e-3F), Status::kOk);
  EXPECT_GE(this->world.report().overlaps_at_start, 1);
  EXPECT_NEAR(this->world.report().deepest_overlap, 0.1F, 1e-5F);
}

/// Larger, but it meets nobody; then it does.
TYPED_TEST(Still, OneWhoseFilterChanges_IsSeenInTheOther) {
  auto& actor = *this->world.get(this->grown);
  actor.capsule_B.radius = 1.2F;
  actor.filter.meets = 0;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(this->world.step(1e-3F), Status::kOk);
    EXPECT_EQ(this->world.report().overlaps_at_start, 0);
  }
  this->world.get(this->grown)->filter.meets = 0xFFFF;
  ASSERT_EQ(this->world.step(1e-3F), Status::kOk);
  EXPECT_GE(this->world.report().overlaps_at_start, 1);
}

}  // namespace
}  // namespace batuta
