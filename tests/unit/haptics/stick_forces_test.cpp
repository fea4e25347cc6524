// SPDX-License-Identifier: MIT
#include "batuta/haptics/stick_forces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace batuta::haptics {
using namespace fencing;
namespace {

/// A duel in which the left blade beats the right one: the right fencer waits.
class ABeat : public ::testing::Test {
 protected:
  std::unique_ptr<Duel<>> duel = std::make_unique<Duel<>>();
  StickForces forces;

  void SetUp() override {
    ASSERT_EQ(duel->configure(duel_settings(), first_fencer<float>(), second_fencer<float>()),
              Status::kOk);
  }

  /// One step in which the left stick is at (0, y) of a beat that lasts 150 steps.
  void step() {
    InputSample left;
    left.time = duel->steps() * 1000;
    left.sequence = duel->steps();
    left.y = 0.5F * std::fmin(static_cast<float>(duel->steps()) / 150.0F, 1.0F);
    InputSample right = left;
    right.y = 0;
    ASSERT_EQ(duel->step(&left, &right), Status::kOk);
    forces.advance(*duel, {true, true});
  }
  bool has_blow() const {
    for (const auto& event : duel->world().events()) {
      if (event.impulse > 0) return true;
    }
    return false;
  }
};

TEST_F(ABeat, PushesTheStickBackFromWhereItStruck_AndTheOtherAlong) {
  ASSERT_EQ(forces.configure({1000, {100, 1}}), Status::kOk);
  for (int i = 0; i < 150 && !has_blow(); ++i) step();
  ASSERT_TRUE(has_blow());
  // The left stick moves to +y and meets something: it is pushed to -y. It leads the hand to the
  // left. The right fencer faces the other way: what comes from the left fencer's right comes from
  // his own left, and pushes him to his own right.
  EXPECT_LT(forces.of(Side::kLeft).share.y(), 0);
  EXPECT_GT(forces.of(Side::kRight).share.x(), 0);
}

// The hand cuts its pulse to the range before the shares are made: it is marked all the same.
TEST_F(ABeat, BlowBeyondTheRange_IsMarkedAsLimited) {
  ASSERT_EQ(forces.configure({0.01F, {100, 1}}), Status::kOk);
  for (step(); !has_blow() && duel->steps() < 150; step()) {
    EXPECT_FALSE(forces.of(Side::kLeft).limited);
  }
  ASSERT_TRUE(has_blow());
  EXPECT_TRUE(forces.of(Side::kLeft).limited);
  EXPECT_GT(forces.of(Side::kLeft).excess, 1);
  EXPECT_LE(forces.of(Side::kLeft).share.cwiseAbs().maxCoeff(), 1);
}

TEST_F(ABeat, BeforeTheFirstBlow_ThereIsNoForce) {
  ASSERT_EQ(forces.configure({}), Status::kOk);
  int quiet = 0;
  for (step(); !has_blow() && quiet < 150; step()) {
    ++quiet;
    EXPECT_EQ(forces.of(Side::kLeft).share, Vec2<float>(0, 0));
    EXPECT_EQ(forces.of(Side::kRight).share, Vec2<float>(0, 0));
  }
  EXPECT_GT(quiet, 10);
}

/// Between blows the hand feels its blade being caught, either way: no harder than the grip can.
TEST_F(ABeat, HeldAgainstTheOtherBlade_TheBladePullsNoHarderThanItsGrip) {
  ASSERT_EQ(forces.configure({}), Status::kOk);
  float hardest = 0;
  for (int i = 0; i < 450; ++i) {
    step();
    hardest = std::fmin(hardest, forces.of(Side::kLeft).demanded.y());
  }
  EXPECT_GT(hardest, -60 - 2 * 6.0F);  // N and N m; less than 1 m and 2 rad for each unit
  EXPECT_LT(hardest, -0.5F) << "else nothing was caught";
}

TEST_F(ABeat, SmallestForces_AreNone) {
  ForceSettings settings;
  settings.full_scale = 1e6F;  // of which the coupling is a millionth
  ASSERT_EQ(forces.configure(settings), Status::kOk);
  for (int i = 0; i < 300; ++i) {
    step();
    EXPECT_EQ(forces.of(Side::kLeft).demanded, Vec2<float>(0, 0)) << i;
  }
}

TEST_F(ABeat, TheRampScalesEachSideByItself) {
  ASSERT_EQ(forces.configure({1000, {0, 1000}}), Status::kOk);
  StickForces full;
  ASSERT_EQ(full.configure({1000, {0, 1}}), Status::kOk);
  int blows = 0;
  for (int i = 1; i <= 150; ++i) {
    InputSample left;
    left.time = duel->steps() * 1000;
    left.y = 0.5F * static_cast<float>(i) / 150.0F;
    ASSERT_EQ(duel->step(&left, nullptr), Status::kOk);
    forces.advance(*duel, {true, false});
    full.advance(*duel, {true, false});
    const Vec2<float> whole = full.of(Side::kLeft).share;
    const float share = static_cast<float>(i) / 1000.0F;
    EXPECT_EQ(forces.of(Side::kLeft).share, Vec2<float>(share * whole));
    EXPECT_EQ(forces.of(Side::kRight).share, Vec2<float>(0, 0)) << "it never had a sample";
    blows += has_blow() ? 1 : 0;
  }
  EXPECT_GT(blows, 0);
  EXPECT_TRUE(forces.of(Side::kLeft).ramped);
  EXPECT_FALSE(forces.of(Side::kLeft).silent);
  EXPECT_TRUE(forces.of(Side::kRight).silent);
}

/// As much of a duel as forces ask for, in which a hand and what it holds may be anywhere.
struct AnyDuel {
  struct WorldType {
    using Scalar = float;
    std::array<ContactEvent<float>, 0> none;
    const std::array<ContactEvent<float>, 0>& events() const { return none; }
  };
  struct SceneType {
    static constexpr bool kGrip = false;
  };
  Bout<float> state;
  WorldType of_blades;
  KeyedPose<float> commanded;
  Pose<float> held_W;

  const Bout<float>& bout() const { return state; }
  const WorldType& world() const { return of_blades; }
  KeyedPose<float> hand(Side /*side*/) const { return commanded; }
  Pose<float> held_hand_W(Side /*side*/) const { return held_W; }
  float dt() const { return 0.001F; }
};

// A demand that is no number is none, and is told, in its step and no other.
TEST(StickForces, DemandThatIsNoNumber_IsMarkedAsLimited) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinite, 1e36F}) {  // the last: 400 N/m over so many m are none
    StickForces forces;
    ASSERT_EQ(forces.configure({}), Status::kOk);
    AnyDuel duel;
    duel.commanded.jacobian.setConstant(0.1F);
    duel.held_W.p_W.x() = 0.005F;  // 2 N
    forces.advance(duel, {true, true});
    EXPECT_FALSE(forces.of(Side::kLeft).limited);
    EXPECT_GT(forces.of(Side::kLeft).demanded.x(), 0);
    AnyDuel wrong = duel;
    wrong.held_W.p_W.x() = bad;
    forces.advance(wrong, {true, true});
    EXPECT_TRUE(forces.of(Side::kLeft).limited) << bad;
    EXPECT_EQ(forces.of(Side::kLeft).demanded, Vec2<float>(0, 0)) << bad;
    forces.advance(duel, {true, true});
    EXPECT_FALSE(forces.of(Side::kLeft).limited) << bad;
  }
}

TEST(StickForces, SettingsOutOfRange_AreRefused) {
  StickForces forces;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const float bad : {0.0F, -1.0F, nan, infinite}) {
    EXPECT_EQ(forces.configure({bad, {}}), Status::kInvalidArgument) << bad;
  }
  EXPECT_EQ(forces.configure({1, {-1, 1}}), Status::kInvalidArgument);
}

}  // namespace
}  // namespace batuta::haptics
