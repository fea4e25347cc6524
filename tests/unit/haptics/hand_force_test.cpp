// SPDX-License-Identifier: MIT
// What a stick feels: of states made by hand, and of a duel in which one blade beats the other.

#include "batuta/haptics/duel_hand.hpp"

#include <gtest/gtest.h>

namespace batuta {
using namespace haptics;
using namespace fencing;
namespace {

using State = HandState<double>;
constexpr double kStep = 1e-3;

/// The stick moves the hand along x and y of W, 1 m for each unit.
State plain_state() {
  State state;
  state.commanded.jacobian(0, 0) = 1;
  state.commanded.jacobian(1, 1) = 1;
  return state;
}

HandForce<double> hand_force(const HandForceSettings<double>& settings = {}) {
  HandForce<double> force;
  EXPECT_EQ(force.configure(settings), Status::kOk);
  return force;
}

TEST(HandForce, BladeInTheHand_IsNotFelt) {
  HandForce<double> force = hand_force();
  EXPECT_EQ(force.advance(plain_state(), kStep), Vec2<double>::Zero());
}

TEST(HandForce, BladeHeldBack_PullsTheStickBack) {
  HandForce<double> force = hand_force();
  State state = plain_state();
  state.held_W.p_W.x() = -0.02;
  EXPECT_DOUBLE_EQ(force.advance(state, kStep).x(), -8);  // 400 N/m
  EXPECT_EQ(force.advance(state, kStep).y(), 0);
  EXPECT_DOUBLE_EQ(force.stored(), 0.08);  // 400 x 0.02^2 / 2 J
}

TEST(HandForce, BladeHalfInTheHand_PullsHalfAsMuch_AndALooseOneNotAtAll) {
  for (const double hold : {0.0, 0.5}) {
    HandForce<double> force = hand_force();
    State state = plain_state();
    state.held_W.p_W.x() = -0.02;
    state.hold = hold;
    EXPECT_DOUBLE_EQ(force.advance(state, kStep).x(), -8 * hold);
    EXPECT_DOUBLE_EQ(force.stored(), 0.08 * hold);
  }
}

TEST(HandForce, HandThatMovesAwayFromItsBlade_IsBraked) {
  HandForceSettings<double> settings;
  settings.coupling.stiffness = 0;
  HandForce<double> force = hand_force(settings);
  State state = plain_state();
  EXPECT_EQ(force.advance(state, kStep).x(), 0);            // nothing is known of a velocity yet
  state.commanded.X_WH.p_W.x() = 0.003;                     // 3 m/s
  EXPECT_NEAR(force.advance(state, kStep).x(), -6, 1e-12);  // 2 N s/m
}

TEST(HandForce, BladeThatMovesAwayFromItsHand_DragsItAsLongAsItMoves) {
  HandForceSettings<double> settings;
  settings.coupling.stiffness = 0;
  HandForce<double> force = hand_force(settings);
  State state = plain_state();
  (void)force.advance(state, kStep);
  for (const double place : {0.003, 0.006}) {
    state.held_W.p_W.y() = place;                            // 3 m/s
    EXPECT_NEAR(force.advance(state, kStep).y(), 6, 1e-12);  // 2 N s/m
  }
  EXPECT_NEAR(force.advance(state, kStep).y(), 0, 1e-12);
}

// Whose hand is put elsewhere, and lets the blade lag by nothing there, has not moved there.
TEST(HandForce, HandThatIsPutElsewhere_FeelsNothingOfTheWay) {
  HandForceSettings<double> settings;
  settings.coupling.stiffness = 0;
  for (const bool leaps : {false, true}) {
    HandForce<double> force = hand_force(settings);
    State state = plain_state();
    state.held_W.p_W.x() = -0.002;
    EXPECT_EQ(force.advance(state, kStep).x(), 0);
    state.commanded.X_WH.p_W.x() = 0.7;
    state.held_W.p_W.x() = 0.7;
    if (leaps) force.leap();
    EXPECT_EQ(force.advance(state, kStep).x() == 0, leaps);
  }
}

TEST(HandForce, Blow_IsPlayedWhole) {
  HandForce<double> force = hand_force();
  State state = plain_state();
  state.blow.linear_W = {0.1, -0.05, 7};
  Vec2<double> area = kStep * force.advance(state, kStep);
  state.blow = {};
  for (int i = 0; i < 10; ++i) area += kStep * force.advance(state, kStep);
  EXPECT_NEAR(area.x(), 0.1, 1e-15);
  EXPECT_NEAR(area.y(), -0.05, 1e-15);
}

TEST(HandForce, BlowAtTheLimit_LeavesTheCouplingNoRoom) {
  HandForce<double> force = hand_force();
  State state = plain_state();
  state.blow.linear_W.x() = 10;
  state.held_W.p_W.y() = -0.02;
  state.held_W.p_W.x() = -0.02;  // against the blow: has all the room
  const Vec2<double> against = force.advance(state, kStep);
  EXPECT_NEAR(against.x(), 40 - 8, 1e-12);
  EXPECT_NEAR(against.y(), -8, 1e-12);
  state.held_W.p_W.x() = 0.02;  // along it: none
  const Vec2<double> along = force.advance(state, kStep);
  EXPECT_EQ(along.x(), 40);
  EXPECT_EQ(along.y(), 0);
}

// 0.02 m at 400 N/m are 8 N, of which 2 fit: beyond the range by 3 of them.
TEST(HandForce, CouplingBeyondTheRange_IsToldAndCounted) {
  HandForceSettings<double> settings;
  settings.transient.max_force = 2;
  HandForce<double> force = hand_force(settings);
  HandForceReport<double> report;
  State state = plain_state();
  for (const double way : {0.0, 0.004, 0.02, 0.004}) {
    state.held_W.p_W.x() = -way;
    (void)force.advance(state, kStep);
    report.take(force);
  }
  EXPECT_EQ(report.steps, 4U);
  EXPECT_EQ(report.clipped, 3U);                // by the damper already on the first way
  EXPECT_NEAR(report.worst_excess, 19, 1e-12);  // 8 N, and 2 N s/m at 16 m/s
  EXPECT_EQ(report.limited, 0U);
}

TEST(HandForce, StiffHand_IsToldAsClippedAndAtItsOwnLimit) {
  HandForceSettings<double> settings;
  settings.coupling.stiffness = 1e9;
  HandForce<double> force = hand_force(settings);
  HandForceReport<double> report;
  State state = plain_state();
  for (int i = 0; i < 10; ++i) {
    EXPECT_LE(force.advance(state, kStep).cwiseAbs().maxCoeff(), 40);
    report.take(force);
    state.held_W.p_W.x() = -0.001;
  }
  EXPECT_EQ(report.clipped, 9U);
  EXPECT_EQ(report.limited, 9U);
  EXPECT_NEAR(report.worst_excess, 0.5, 1e-12);  // 60 N of 40
}

// 0.8 N m s in 4 ms are 200, of 40: beyond it by 4, and played for 20 ms.
TEST(HandForce, BlowBeyondTheRange_IsClippedForAsLongAsItIsHeldBack) {
  HandForce<double> force = hand_force();
  HandForceReport<double> report;
  State state = plain_state();
  state.blow.linear_W.x() = -0.8;
  (void)force.advance(state, kStep);
  report.take(force);
  EXPECT_NEAR(force.excess(), 4, 1e-6);  // 4 ms is a float
  state.blow = {};
  for (int i = 1; i < 30; ++i) {
    (void)force.advance(state, kStep);
    report.take(force);
  }
  EXPECT_FALSE(force.is_clipped());
  EXPECT_EQ(report.clipped, 19U);  // what the 20th plays is left over, and fits
  EXPECT_NEAR(report.worst_excess, 4, 1e-6);
}

TEST(HandForce, StateThatIsNotFinite_IsNotFeltAndNotKept) {
  HandForce<double> force = hand_force();
  State state = plain_state();
  (void)force.advance(state, kStep);
  State bad = state;
  bad.held_W.p_W.x() = NAN;
  EXPECT_EQ(force.advance(bad, kStep), Vec2<double>::Zero());
  EXPECT_TRUE(force.is_invalid());
  bad = state;
  bad.blow.angular_W.z() = INFINITY;
  EXPECT_EQ(force.advance(bad, kStep), Vec2<double>::Zero());
  EXPECT_TRUE(force.is_invalid());
  EXPECT_EQ(force.advance(state, kStep), Vec2<double>::Zero());
  EXPECT_FALSE(force.is_invalid());
}

// Pose and energy are numbers, and the force is none: 400 N/m over 1e306 m, or 2 N s/m at 1e308
// m/s.
TEST(HandForce, CouplingBeyondNumbers_IsNotFeltAndNotKept) {
  for (const double stiffness : {400.0, 0.0}) {
    HandForceSettings<double> settings;
    settings.coupling.stiffness = stiffness;
    HandForce<double> force = hand_force(settings);
    const State state = plain_state();
    (void)force.advance(state, kStep);
    State far = state;
    far.held_W.p_W.x() = stiffness > 0 ? 1e306 : 1e305;
    EXPECT_EQ(force.advance(far, kStep), Vec2<double>::Zero());
    EXPECT_TRUE(force.is_invalid()) << stiffness;
    EXPECT_FALSE(force.is_limited()) << stiffness;
    EXPECT_EQ(force.stored(), 0) << stiffness;
    EXPECT_EQ(force.advance(state, kStep), Vec2<double>::Zero());
    EXPECT_FALSE(force.is_invalid()) << "nothing is known of the way back";
  }
}

// Each blow is a number, and their sum is none.
TEST(HandForce, BlowsBeyondNumbers_AreNotFeltAndSaid) {
  HandForce<double> force = hand_force();
  State state = plain_state();
  state.blow.linear_W.x() = 1e308;
  (void)force.advance(state, kStep);
  EXPECT_FALSE(force.is_invalid());
  EXPECT_EQ(force.advance(state, kStep), Vec2<double>::Zero());
  EXPECT_TRUE(force.is_invalid());
}

TEST(HandForce, SettingsOutOfRange_AreRefused) {
  HandForce<double> force;
  HandForceSettings<double> settings;
  settings.coupling.stiffness = -1;
  EXPECT_EQ(force.configure(settings), Status::kInvalidArgument);
  settings = {};
  settings.transient.duration = 0;
  EXPECT_EQ(force.configure(settings), Status::kInvalidArgument);
}

/// A duel in which the left stick beats to the left, and stays there; the right one holds guard.
class Beat : public ::testing::Test {
 protected:
  Duel<DuelScene<two_fencers, Advancement<double>>> duel;
  HandForce<double> left;
  HandForce<double> right;
  InputSample sample;

  void SetUp() override {
    ASSERT_EQ(duel.configure(duel_settings<DuelScene<two_fencers, Advancement<double>>>(),
                             first_fencer<double>(), second_fencer<double>()),
              Status::kOk);
    ASSERT_EQ(left.configure({}), Status::kOk);
    ASSERT_EQ(right.configure({}), Status::kOk);
  }

  /// @param right_out  how far the right fencer's arm is out, into the high inside line, 0 ... 1
  void step(float x, float y, float right_out) {
    sample.time += 1000;
    ++sample.sequence;
    sample.x = x;
    sample.y = y;
    InputSample other = sample;
    other.x = -0.5F * right_out;
    other.y = 0.5F * right_out;
    ASSERT_EQ(duel.step(&sample, &other), Status::kOk);
  }
  /// Where the hand of the coupling went in the step: the power of the force on the stick.
  static double power(const Vec2<double>& force, const Vec2<double>& rate) {
    return force.dot(rate);
  }
};

TEST_F(Beat, OnGuard_NothingIsFeltBeyondRounding) {
  for (int i = 0; i < 200; ++i) {
    step(0, 0, 0);
    EXPECT_LT(left.advance(hand_state(duel, Side::kLeft), kStep).norm(), 1e-6) << i;
  }
}

TEST_F(Beat, HeldHandIsTheCommandedOne_UntilTheBladesMeet) {
  for (int i = 0; i < 300 && duel.report().blows == 0; ++i) {
    const auto state = hand_state(duel, Side::kLeft);
    EXPECT_LT((state.held_W.p_W - state.commanded.X_WH.p_W).norm(), 1e-9) << i;
    EXPECT_LT(state.held_W.q_WB.angularDistance(state.commanded.X_WH.q_WB), 1e-7) << i;
    const float share = 0.01F * static_cast<float>(i);
    step(-std::clamp(share - 1, 0.0F, 1.0F), 0, std::min(1.0F, share));
  }
  EXPECT_GT(duel.report().blows, 0U);
}

TEST_F(Beat, BothHandsFeelTheBlow_AndItBrakesTheOneThatBeats) {
  double work = 0;
  double area = 0;
  double felt_right = 0;
  for (int i = 0; i < 100; ++i) step(0, 0, std::min(1.0F, 0.02F * static_cast<float>(i)));
  for (int i = 0; i < 150; ++i) {
    step(-std::min(1.0F, 0.02F * static_cast<float>(i)), 0, 1);
    const Vec2<double> rate = duel.stick(Side::kLeft).velocity();
    work += kStep * power(left.advance(hand_state(duel, Side::kLeft), kStep), rate);
    const Vec2<double> on_right = right.advance(hand_state(duel, Side::kRight), kStep);
    felt_right = std::max(felt_right, on_right.norm());
    area += left.transient().left().norm();
  }
  EXPECT_GT(duel.report().blows, 0U);
  EXPECT_LT(work, -1e-3);  // J
  EXPECT_GT(area, 0);
  EXPECT_GT(felt_right, 0.5);
}

}  // namespace
}  // namespace batuta
