// SPDX-License-Identifier: MIT
#include "batuta/fencing/grip.hpp"

#include <gtest/gtest.h>

namespace batuta {
using namespace fencing;
namespace {

constexpr double kStep = 1e-3;

template <class S>
Vec3<S> vec(double x, double y, double z) {
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

template <class S>
double distance(const Pose<S>& a, const Pose<S>& b) {
  const Vec3<S> turn = log_map<S>(a.q_WB * b.q_WB.conjugate());
  return static_cast<double>((a.p_W - b.p_W).norm() + turn.norm());
}

/// A blade in a hand that moves at (0.5, 0, 0) m/s and turns at 0.8 rad/s about z.
template <class S>
class GripOf : public ::testing::Test {
 protected:
  Grip<S> grip;
  Body<S> body;
  int steps = 0;

  void SetUp() override {
    body = make_body(hand(0), S(0.77), vec<S>(1e-4, 0.07, 0.07)).value;
    ASSERT_EQ(grip.configure(GripSettings<S>{}), Status::kOk);
    grip.place(body.X_WB);
  }
  static Pose<S> hand(double t) { return {vec<S>(0.5 * t, 0, 1), exp_map(vec<S>(0, 0, 0.8 * t))}; }
  double now() const { return steps * kStep; }

  void command() { grip.command(hand(now() + kStep), static_cast<S>(kStep)); }
  void move(double from, double to) {
    const auto course = grip.plan(body, static_cast<S>(from), static_cast<S>(to - from));
    EXPECT_FALSE(course.by_momentum);
    body.X_WB = pose_at(course.motion, static_cast<S>(to - from));
    body.momentum = momentum_of(body, course.motion.twist);
  }
  void finish() {
    grip.on_step_end(body, static_cast<S>(kStep));
    ++steps;
  }
  void step() {
    command();
    move(0, kStep);
    finish();
  }
  /// One step with a blow at its time `at`: j N s across the blade, `reach` m from its middle.
  void step_with_blow(double at, double j, double reach, const Twist<S>& after) {
    command();
    move(0, at);
    strike(at, j, reach, after);
    move(at, kStep);
    finish();
  }
  void strike(double at, double j, double reach, const Twist<S>& after) {
    body.momentum = momentum_of(body, after);
    Feedback<S> blow;
    blow.time = static_cast<S>(at);
    blow.impulse = static_cast<S>(j);
    blow.impulse_W = vec<S>(0, 0, -j);  // across the blade, which turns about z alone
    blow.point_W = body.X_WB.p_W + body.X_WB.q_WB * vec<S>(reach, 0, 0);
    grip.on_contact(body, blow);
  }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(GripOf, Scalars);

/// Rounding of a pose (1.2e-7 at 1 m) over the 100 steps in which the grip forgets.
template <class S>
constexpr double kClose = std::is_same_v<S, float> ? 1.2e-5 : 1e-12;

TYPED_TEST(GripOf, Held_FollowsTheHand) {
  for (int i = 0; i < 2000; ++i) {
    this->step();
    ASSERT_LE(distance(this->body.X_WB, this->hand(this->now())), kClose<TypeParam>);
  }
  EXPECT_EQ(this->grip.phase(), GripPhase::kHeld);
  EXPECT_EQ(this->grip.control(), TypeParam(1));
}

TYPED_TEST(GripOf, Held_MatterMovesLikeTheHand) {
  this->step();
  this->command();
  const auto course = this->grip.plan(this->body, TypeParam(0), TypeParam(kStep));
  EXPECT_NEAR(course.motion.twist.v_W.x(), 0.5, 1e-3);
  EXPECT_NEAR(course.motion.twist.w_W.z(), 0.8, 1e-3);
}

TYPED_TEST(GripOf, NothingCommanded_StandsStill) {
  this->grip.on_step_end(this->body, TypeParam(kStep));
  const auto course = this->grip.plan(this->body, TypeParam(0), TypeParam(0.5));
  EXPECT_EQ(course.motion.twist.v_W.norm(), TypeParam(0));
  EXPECT_EQ(course.motion.duration, TypeParam(0.5));
}

// 0.6 N s at 0.5 m against 3 N m: caught in 0.1 s. The turn is continuous throughout, and at the
// end the hand has it.
TYPED_TEST(GripOf, Blow_IsCaughtAfterItsMomentOverTheTorque) {
  using S = TypeParam;
  GripSettings<S> settings;
  settings.torque = S(3);
  ASSERT_EQ(this->grip.configure(settings), Status::kOk);
  for (int i = 0; i < 5; ++i) this->step();
  const Twist<S> after{vec<S>(0.5, 0, 0), vec<S>(0, 0, -6)};
  this->step_with_blow(0.5e-3, 0.6, 0.5, after);
  EXPECT_EQ(this->grip.phase(), GripPhase::kRegaining) << "on the forte: not beaten";
  Pose<S> last = this->body.X_WB;
  double last_w = -6;
  double furthest = 0;
  int regaining = 1;
  for (int i = 0; i < 99; ++i) {
    this->step();
    const auto turn = log_map<S>(this->body.X_WB.q_WB * last.q_WB.conjugate());
    const double w = static_cast<double>(turn.z()) / kStep;
    ASSERT_LE(std::abs(w - last_w), 0.5) << i;  // 6.8 rad/s there and back in 0.1 s, and rounding
    last_w = w;
    last = this->body.X_WB;
    const auto away = log_map<S>(last.q_WB * this->hand(this->now()).q_WB.conjugate());
    furthest = std::max(furthest, static_cast<double>(away.norm()));
    regaining += this->grip.phase() == GripPhase::kRegaining ? 1 : 0;
  }
  EXPECT_EQ(regaining, 100);
  this->step();
  EXPECT_EQ(this->grip.phase(), GripPhase::kHeld);
  EXPECT_GT(furthest, 0.1);  // (1 - h) s at s = 1/2, of 6 rad/s and 0.1 s: 0.15
  this->step();
  EXPECT_LE(distance(this->body.X_WB, this->hand(this->now())), 10 * kClose<S>);
}

TYPED_TEST(GripOf, FirstMomentAfterABlow_IsFreeFlight) {
  using S = TypeParam;
  this->command();
  const Twist<S> after{vec<S>(0, -3, 1), vec<S>(0, 5, 2)};
  this->strike(0, 0.4, 1.0, after);
  const auto flight = free_flight(this->body, S(kStep));
  const auto course = this->grip.plan(this->body, S(0), S(kStep));
  // The arm takes 0.02 s at least: s = 0.05 after the step, a weight of 0.0073 of 4 mm in 1 ms; the
  // wrist 0.067 s: 0.0007 of 6 mrad.
  EXPECT_LE((course.motion.twist.v_W - flight.twist.v_W).norm(), S(0.04));
  EXPECT_LE((course.motion.twist.w_W - flight.twist.w_W).norm(), S(0.01));
}

TYPED_TEST(GripOf, SecondBlow_StartsAgainFromThePresent) {
  using S = TypeParam;
  const auto turning = [](double w) { return Twist<S>{vec<S>(0.5, 0, 0), vec<S>(0, 0, w)}; };
  this->step_with_blow(0, 1.2, 0.5, turning(-3));  // 0.1 s
  for (int i = 0; i < 50; ++i) this->step();
  EXPECT_GT(this->grip.control(), S(0.4));
  const Pose<S> before = this->body.X_WB;
  this->step_with_blow(0, 2.4, 0.5, turning(3));
  EXPECT_LT(this->grip.control(), S(0.01));
  const auto turn = log_map<S>(this->body.X_WB.q_WB * before.q_WB.conjugate());
  EXPECT_NEAR(turn.z(), 3e-3, 1e-4);
}

// A huge blow: the time is clamped, the blade comes back, and turning many times over does not make
// it jump: the wrist gives way by 1.2 rad and no further.
TYPED_TEST(GripOf, HugeBlow_IsCaughtInTheLongestTimeWithoutJumps) {
  using S = TypeParam;
  this->step_with_blow(0, 1e6, 0.5, {vec<S>(0, -8, 0), vec<S>(0, 0, 60)});
  Pose<S> last = this->body.X_WB;
  for (int i = 0; i < 401; ++i) {
    this->step();
    ASSERT_LE(distance(last, this->body.X_WB), 0.15) << i;  // 60 rad/s both ways, 8 m/s
    const auto away = log_map<S>(this->body.X_WB.q_WB * this->hand(this->now()).q_WB.conjugate());
    ASSERT_LE(away.norm(), S(1.2 + 0.4)) << i;  // beside what the hand itself has turned on
    last = this->body.X_WB;
  }
  EXPECT_EQ(this->grip.phase(), GripPhase::kHeld);
  EXPECT_LE(distance(this->body.X_WB, this->hand(this->now())), 0.2);
}

TYPED_TEST(GripOf, FlightThatCannotBeTold_IsTakenAsStill) {
  using S = TypeParam;
  this->step_with_blow(0, 1e6, 0.5, {vec<S>(0, 0, 0), vec<S>(0, 0, 1e6)});
  EXPECT_LE(distance(this->body.X_WB, this->hand(0)), 1e-2);
}

// A hand that holds the blade half a metre behind its middle keeps its own place within 0.02 s,
// while the blade is still away.
TYPED_TEST(GripOf, Blow_MovesTheBladeAboutTheHand) {
  using S = TypeParam;
  const Vec3<S> hand_B = vec<S>(-0.5, 0, 0);
  this->grip.hold_at(hand_B);
  const auto slip = [&] {
    return static_cast<double>(
        (to_world(this->body.X_WB, hand_B) - to_world(this->hand(this->now()), hand_B)).norm());
  };
  this->step_with_blow(0, 0.5, 0.0, {vec<S>(0.5, -1, 0), vec<S>(0, 0, -4)});
  double furthest = slip();
  for (int i = 0; i < 21; ++i) {
    this->step();
    furthest = std::max(furthest, slip());
  }
  EXPECT_GT(furthest, 1e-3);
  EXPECT_LT(furthest, 0.02);  // 1 m/s for a part of 0.02 s
  EXPECT_LT(slip(), 1e-3);
  const auto away = log_map<S>(this->body.X_WB.q_WB * this->hand(this->now()).q_WB.conjugate());
  EXPECT_GT(away.norm(), S(0.02));
}

// 0.8 N s at 0.75 m: 0.6 N m s, of which the hand keeps its composure for 0.3; 1 N m: 0.3 s.
TYPED_TEST(GripOf, BlowOnTheFoible_BeatsTheHandForItsTime) {
  using S = TypeParam;
  this->step_with_blow(0, 0.8, 0.75, {vec<S>(0.5, 0, 0), vec<S>(0, 0, -4)});
  int beaten = 0;
  for (int i = 0; i < 400; ++i) {
    const bool is_beaten = this->grip.phase() == GripPhase::kBeaten;
    beaten += is_beaten ? 1 : 0;
    EXPECT_EQ(this->grip.control() == S(0), is_beaten);
    this->step();
  }
  EXPECT_NEAR(beaten, 300, 1);  // rounding of 300 sums
  EXPECT_EQ(this->grip.phase(), GripPhase::kHeld);
}

// A weaker blow while it is beaten does not give the hand its line back.
TYPED_TEST(GripOf, BeatenHand_StaysSoThroughALighterBlow) {
  using S = TypeParam;
  const Twist<S> after{vec<S>(0.5, 0, 0), vec<S>(0, 0, -4)};
  this->step_with_blow(0, 0.8, 0.75, after);
  for (int i = 0; i < 100; ++i) this->step();
  this->step_with_blow(0, 0.01, 0.75, after);
  int beaten = 0;
  for (int i = 0; i < 400; ++i) {
    beaten += this->grip.phase() == GripPhase::kBeaten ? 1 : 0;
    this->step();
  }
  EXPECT_NEAR(beaten, 300 - 101, 2);
}

// The hand stands still; of a turn of 4 rad/s, (1 - s) t is left with the weight of the paper. It
// pulls from the end of the step in which the blow came: for 49 of the 50 ms.
TYPED_TEST(GripOf, LinearWeight_IsThatOfThePaper) {
  using S = TypeParam;
  GripSettings<S> settings;
  settings.weight = CatchWeight::kLinear;
  settings.torque = S(3);
  ASSERT_EQ(this->grip.configure(settings), Status::kOk);
  this->grip.command(this->body.X_WB, S(kStep));
  this->strike(0, 0.6, 0.5, {vec<S>(0, 0, 0), vec<S>(0, 0, -4)});  // 0.1 s
  for (int i = 0; i < 50; ++i) {
    this->grip.command(this->hand(0), S(kStep));
    this->move(0, kStep);
    this->finish();
  }
  const auto turn = log_map<S>(this->body.X_WB.q_WB * this->hand(0).q_WB.conjugate());
  EXPECT_NEAR(turn.z(), -4 * 0.05 * 0.51, 1e-5);
}

// A separation by 1 mm: no loss of control, no snapping back within the step, and it fades.
TYPED_TEST(GripOf, Separation_KeepsTheShiftAndFades) {
  using S = TypeParam;
  this->step();
  this->command();
  this->move(0, 0.4e-3);
  const Vec3<S> shift = vec<S>(0, 1e-3, 0);
  this->body.X_WB.p_W += shift;
  this->grip.on_contact(this->body, {S(0.4e-3), S(0), shift, vec<S>(0, 0, 0), vec<S>(0, 0, 0)});
  EXPECT_EQ(this->grip.phase(), GripPhase::kHeld);
  const double at_shift = static_cast<double>(this->body.X_WB.p_W.y());
  this->move(0.4e-3, kStep);
  EXPECT_NEAR(static_cast<double>(this->body.X_WB.p_W.y()), at_shift, 2e-5);
  this->finish();
  for (int i = 0; i < 100; ++i) this->step();  // the time constant
  const double left =
      static_cast<double>(this->body.X_WB.p_W.y() - this->hand(this->now()).p_W.y());
  EXPECT_NEAR(left, 1e-3 * std::exp(-1.0), 1e-5);
  for (int i = 0; i < 1000; ++i) this->step();
  EXPECT_LE(distance(this->body.X_WB, this->hand(this->now())), 1e-7 + kClose<S>);
}

// Asked for the last moment of a step, a course does not divide rounding by nothing.
TYPED_TEST(GripOf, LastMomentOfAStep_HasTheHandsVelocity) {
  using S = TypeParam;
  this->step();
  this->command();
  const S late = S(kStep) * (S(1) - S(1e-6));
  this->move(0, static_cast<double>(late));
  const auto course = this->grip.plan(this->body, late, S(kStep) - late);
  EXPECT_NEAR(course.motion.twist.v_W.x(), 0.5, 5e-3);
  EXPECT_LE(std::abs(course.motion.twist.v_W.y()), S(5e-3));
}

// Something keeps the blade where it is, whatever the hand wants: the hand pushes with what it has,
// 60 N and 6 N m in a step, and does not gather more from step to step. The hand is 0.2 m and 0.5
// rad away; the way of the first step after a blow is that of its strength from rest.
TYPED_TEST(GripOf, BladeThatIsKeptFromMoving_IsPushedByNoMoreThanTheHandHas) {
  using S = TypeParam;
  const Pose<S> there = this->hand(0);
  const Pose<S> wanted{vec<S>(0.2, 0, 1), exp_map(vec<S>(0, 0, 0.5))};
  this->grip.command(wanted, S(kStep));
  this->strike(0, 0.1, 0.1, {vec<S>(0, 3, 0), vec<S>(0, 0, 40)});
  this->finish();  // it flew nowhere
  for (int i = 0; i < 1000; ++i) {
    this->grip.command(wanted, S(kStep));
    const auto course = this->grip.plan(this->body, S(0), S(kStep));
    ASSERT_LE(course.motion.twist.v_W.norm(), S(60 / 0.77 * kStep)) << i;
    ASSERT_LE(course.motion.twist.w_W.norm(), S(6 / 0.07 * kStep)) << i;
    if (i % 10 == 9) this->strike(0.5e-3, 0.1, 0.1, course.motion.twist);
    this->body.X_WB = there;
    this->finish();
    ASSERT_EQ(this->grip.control(), S(0)) << i;
  }
}

// Half of the way of a step was not made: the flight goes on at half its speed, from there.
TYPED_TEST(GripOf, BladeThatIsHeldUp_KeepsTheShareOfItsSpeedThatItMade) {
  using S = TypeParam;
  this->command();
  this->strike(0, 0.4, 0.1, {vec<S>(0, -3, 0), vec<S>(0, 0, 0)});
  this->move(0, 0.5e-3);
  this->finish();
  this->command();
  const auto course = this->grip.plan(this->body, S(0), S(kStep));
  // The arm pulls for at least 0.02 s: 3 (1 / 20)^2 of 4.5 mm in 1 ms.
  EXPECT_NEAR(course.motion.twist.v_W.y(), -1.5, 0.033);
}

// A hand that turns on by more than half a turn while it fetches its blade: the way between them
// would become the other way round, and the blade jump by up to a turn.
TYPED_TEST(GripOf, HandThatTurnsOn_IsFollowedWithoutAJump) {
  using S = TypeParam;
  const auto turned = [](double angle) {
    return Pose<S>{vec<S>(0, 0, 1), exp_map(vec<S>(0, 0, angle))};
  };
  this->grip.command(turned(0), S(kStep));
  this->strike(0, 1e6, 0.5, {vec<S>(0, 0, 0), vec<S>(0, 0, 2)});
  this->move(0, kStep);  // it flies, unhindered: else the blow would be over
  this->finish();
  EXPECT_EQ(this->grip.control(), S(0));
  Pose<S> last = this->body.X_WB;
  for (int i = 1; i <= 1000; ++i) {
    this->grip.command(turned(15e-3 * std::min(i, 400)), S(kStep));  // 6 rad in 0.4 s
    this->move(0, kStep);
    this->finish();
    ASSERT_LE(distance(last, this->body.X_WB), 0.06) << i;  // four times the hand's speed
    last = this->body.X_WB;
  }
  EXPECT_LE(distance(this->body.X_WB, turned(6)), 0.01);
}

TEST(Caught, EndsAreFlightAndHand) {
  const Motion<double> flight{{vec<double>(1, 2, 3), exp_map(vec<double>(0.3, 0.2, -1))},
                              {vec<double>(-1, 0.5, 2), vec<double>(3, -4, 5)},
                              1.0};
  const Pose<double> hand{vec<double>(0.1, 0.2, 0.3), exp_map(vec<double>(-0.3, 1.2, 0.4))};
  Catch<double> state;
  state.largest_turn = 3;
  EXPECT_LE(distance(caught(flight, 0.3, hand, state), pose_at(flight, 0.3)), 1e-14);
  state.place = 0.5;
  const Vec3<double> middle = caught(flight, 0.3, hand, state).p_W;
  EXPECT_LE((middle - (pose_at(flight, 0.3).p_W + hand.p_W) / 2).norm(), 1e-14);
  state.turn = state.place = 1;
  state.hand_B = vec<double>(0.1, 0.7, -2);
  EXPECT_EQ(caught(flight, 0.3, hand, state).p_W, hand.p_W);
  EXPECT_EQ(caught(flight, 0.3, hand, state).q_WB.coeffs(), hand.q_WB.coeffs());
}

// Where the hand holds it, the weapon is between both ways, whatever the blade does about it.
TEST(Caught, HandIsBetweenBothWays) {
  const Motion<double> flight{{vec<double>(1, 2, 3), exp_map(vec<double>(0.3, 0.2, -1))},
                              {vec<double>(-1, 0.5, 2), vec<double>(3, -4, 5)},
                              1.0};
  const Pose<double> hand{vec<double>(0.1, 0.2, 0.3), exp_map(vec<double>(-0.3, 1.2, 0.4))};
  const Catch<double> state{vec<double>(0.2, -0.1, 0.4), 0.7, 0.25, 3.0};
  const Vec3<double> free_W = to_world(pose_at(flight, 0.3), state.hand_B);
  const Vec3<double> wanted = 0.75 * free_W + 0.25 * to_world(hand, state.hand_B);
  const Pose<double> at = caught(flight, 0.3, hand, state);
  EXPECT_LE((to_world(at, state.hand_B) - wanted).norm(), 1e-14);
}

TEST(Caught, FlightTurnsNoFurtherThanTheWrist) {
  const Motion<double> flight{{vec<double>(0, 0, 0), exp_map(vec<double>(0, 0, 0))},
                              {vec<double>(0, 0, 0), vec<double>(0, 0, 9)},
                              1.0};
  const Pose<double> hand{vec<double>(0, 0, 0), exp_map(vec<double>(0, 0, 0))};
  Catch<double> state;
  state.largest_turn = 1.2;
  EXPECT_NEAR(log_map<double>(caught(flight, 0.1, hand, state).q_WB).z(), 0.9, 1e-12);
  EXPECT_NEAR(log_map<double>(caught(flight, 0.4, hand, state).q_WB).z(), 1.2, 1e-12);
}

TEST(RegainTime, IsThatOfAnEffortWithinItsLimits) {
  GripSettings<double> s;
  s.min_regain = 0.02;
  s.max_regain = 0.4;
  const auto time = [&s](double blow, double lag, double inverse_inertia) {
    return regain_time(s, GripLoad<double>{5, blow, lag, inverse_inertia});
  };
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(time(0.5, 0.0, 2.0), 0.1);
  EXPECT_DOUBLE_EQ(time(0.5, 0.15, 10.0), std::sqrt(6 * 0.15 / 50));
  EXPECT_EQ(time(1e-9, 0.0, 2.0), 0.02);
  EXPECT_EQ(time(1e30, 0.0, 2.0), 0.4);
  EXPECT_EQ(time(inf, 0.0, 2.0), 0.4);
  EXPECT_EQ(time(0.1, 0.1, 0.0), 0.4) << "a blade that nothing moves";
  EXPECT_EQ(time(0.1, 0.0, 0.0), 0.4);
}

TEST(LostTime, IsTheExcessOverTheComposureBeyondTheForte) {
  GripSettings<double> s;
  s.forte = 0.6;
  s.composure = 0.3;
  s.settle_torque = 2;
  s.max_lost = 0.35;
  const auto time = [&s](double reach, double moment) {
    return lost_time(s, HandBlow<double>{reach, moment});
  };
  EXPECT_DOUBLE_EQ(time(0.9, 0.7), 0.2);
  EXPECT_EQ(time(0.6, 0.7), 0.0) << "on the forte";
  EXPECT_EQ(time(0.9, 0.3), 0.0);
  EXPECT_EQ(time(0.9, 1e30), 0.35);
  EXPECT_EQ(time(0.9, std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(GripSettings, OutOfRange_IsRefused) {
  Grip<double> grip;
  const auto refused = [&grip](double GripSettings<double>::*member, double value) {
    GripSettings<double> settings;
    settings.*member = value;
    return grip.configure(settings) == Status::kInvalidArgument;
  };
  using G = GripSettings<double>;
  const double inf = std::numeric_limits<double>::infinity();
  for (auto member :
       {&G::torque, &G::force, &G::min_regain, &G::max_regain, &G::recover_time, &G::largest_turn,
        &G::forte, &G::composure, &G::settle_torque, &G::max_lost}) {
    EXPECT_TRUE(refused(member, 0));
    EXPECT_TRUE(refused(member, -1));
    EXPECT_TRUE(refused(member, inf));
    EXPECT_TRUE(refused(member, inf - inf));
    EXPECT_TRUE(refused(member, 1.001e9));
  }
  EXPECT_TRUE(refused(&G::max_regain, 0.001));
  GripSettings<double> settings;
  settings.weight = static_cast<CatchWeight>(7);
  EXPECT_EQ(grip.configure(settings), Status::kInvalidArgument);
}

}  // namespace
}  // namespace batuta
