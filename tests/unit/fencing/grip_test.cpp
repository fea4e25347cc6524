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
  /// One step with a blow at its time `at`.
  void step_with_blow(double at, double j, const Vec3<S>& v, const Vec3<S>& w) {
    command();
    move(0, at);
    body.momentum = momentum_of(body, Twist<S>{v, w});
    grip.on_contact(body, {static_cast<S>(at), static_cast<S>(j), Vec3<S>::Zero()});
    move(at, kStep);
    finish();
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

// 0.4 N s against 4 N: caught in 0.1 s. Pose and velocity are continuous throughout, and at the end
// the hand has it.
TYPED_TEST(GripOf, Blow_IsCaughtAfterImpulseOverStrength) {
  using S = TypeParam;
  for (int i = 0; i < 5; ++i) this->step();
  const Pose<S> before = this->body.X_WB;
  this->step_with_blow(0.5e-3, 0.4, vec<S>(0.1, -2, 0), vec<S>(0, 0, -6));
  EXPECT_EQ(this->grip.phase(), GripPhase::kRegaining);
  EXPECT_LE(distance(before, this->body.X_WB), 0.02);
  Pose<S> last = this->body.X_WB;
  double last_v = -2;
  double farthest = 0;
  int regaining = 1;
  for (int i = 0; i < 99; ++i) {
    this->step();
    const double v = static_cast<double>(this->body.X_WB.p_W.y() - last.p_W.y()) / kStep;
    ASSERT_LE(std::abs(v - last_v), 0.2) << i;  // 4 m/s up and down in 0.1 s
    last_v = v;
    last = this->body.X_WB;
    farthest = std::max(farthest, std::abs(static_cast<double>(last.p_W.y())));
    regaining += this->grip.phase() == GripPhase::kRegaining ? 1 : 0;
  }
  EXPECT_EQ(regaining, 100);
  this->step();
  EXPECT_EQ(this->grip.phase(), GripPhase::kHeld);
  EXPECT_GT(farthest, 0.03);
  this->step();
  EXPECT_LE(distance(this->body.X_WB, this->hand(this->now())), 10 * kClose<S>);
}

TYPED_TEST(GripOf, FirstMomentAfterABlow_IsFreeFlight) {
  using S = TypeParam;
  this->command();
  this->body.momentum = momentum_of(this->body, Twist<S>{vec<S>(0, -3, 1), vec<S>(0, 5, 2)});
  const auto flight = free_flight(this->body, S(kStep));
  this->grip.on_contact(this->body, {S(0), S(0.4), Vec3<S>::Zero()});
  const auto course = this->grip.plan(this->body, S(0), S(kStep));
  // s = 0.01 after the step: the hand's weight is 3e-4.
  EXPECT_LE((course.motion.twist.v_W - flight.twist.v_W).norm(), S(5e-3));
  EXPECT_LE((course.motion.twist.w_W - flight.twist.w_W).norm(), S(2e-2));
}

TYPED_TEST(GripOf, SecondBlow_StartsAgainFromThePresent) {
  using S = TypeParam;
  this->step_with_blow(0, 0.4, vec<S>(0, -2, 0), vec<S>(0, 0, 0));
  for (int i = 0; i < 50; ++i) this->step();
  EXPECT_GT(this->grip.control(), S(0.4));
  const Pose<S> before = this->body.X_WB;
  this->step_with_blow(0, 0.8, vec<S>(0, 2, 0), vec<S>(0, 0, 0));
  EXPECT_LT(this->grip.control(), S(0.01));
  EXPECT_NEAR((this->body.X_WB.p_W - before.p_W).y(), 2e-3, 1e-4);
}

// A huge blow: the time is clamped, the blade comes back, and turning many times over does not make
// it jump.
TYPED_TEST(GripOf, HugeBlow_IsCaughtInTheLongestTimeWithoutJumps) {
  using S = TypeParam;
  this->step_with_blow(0, 1e6, vec<S>(0, -8, 0), vec<S>(0, 0, 60));
  Pose<S> last = this->body.X_WB;
  for (int i = 0; i < 401; ++i) {
    this->step();
    ASSERT_LE(distance(last, this->body.X_WB), 0.15) << i;  // 60 rad/s both ways, 8 m/s
    last = this->body.X_WB;
  }
  EXPECT_EQ(this->grip.phase(), GripPhase::kHeld);
  EXPECT_LE(distance(this->body.X_WB, this->hand(this->now())), 0.2);
}

TYPED_TEST(GripOf, FlightThatCannotBeTold_IsTakenAsStill) {
  using S = TypeParam;
  this->step_with_blow(0, 1e6, vec<S>(0, 0, 0), vec<S>(0, 0, 1e6));
  EXPECT_LE(distance(this->body.X_WB, this->hand(0)), 1e-2);
}

// A separation by 1 mm: no loss of control, no snapping back within the step, and it fades.
TYPED_TEST(GripOf, Separation_KeepsTheShiftAndFades) {
  using S = TypeParam;
  this->step();
  this->command();
  this->move(0, 0.4e-3);
  const Vec3<S> shift = vec<S>(0, 1e-3, 0);
  this->body.X_WB.p_W += shift;
  this->grip.on_contact(this->body, {S(0.4e-3), S(0), shift});
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

TEST(Caught, EndsAreFlightAndHand) {
  const Motion<double> flight{{vec<double>(1, 2, 3), exp_map(vec<double>(0.3, 0.2, -1))},
                              {vec<double>(-1, 0.5, 2), vec<double>(3, -4, 5)},
                              1.0};
  const Pose<double> hand{vec<double>(0.1, 0.2, 0.3), exp_map(vec<double>(-0.3, 1.2, 0.4))};
  EXPECT_LE(distance(caught(flight, 0.3, hand, 0.0), pose_at(flight, 0.3)), 1e-14);
  EXPECT_EQ(caught(flight, 0.3, hand, 1.0).p_W, hand.p_W);
  EXPECT_EQ(caught(flight, 0.3, hand, 1.0).q_WB.coeffs(), hand.q_WB.coeffs());
  EXPECT_EQ(caught(flight, 0.3, hand, 7.0).p_W, hand.p_W);
  EXPECT_LE(distance(caught(flight, 0.3, hand, -1.0), pose_at(flight, 0.3)), 1e-14);
  const Vec3<double> middle = caught(flight, 0.3, hand, 0.5).p_W;
  EXPECT_LE((middle - (pose_at(flight, 0.3).p_W + hand.p_W) / 2).norm(), 1e-14);
}

TEST(RegainTime, IsThatOfAForceWithinItsLimits) {
  GripSettings<double> s;
  s.strength = 5;
  s.min_regain = 0.02;
  s.max_regain = 0.4;
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(regain_time(s, 0.0, 0.3, 2.0), 0.0);
  EXPECT_EQ(regain_time(s, -1.0, 0.3, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(regain_time(s, 0.5, 0.0, 2.0), 0.1);
  EXPECT_DOUBLE_EQ(regain_time(s, 0.5, 0.15, 10.0), std::sqrt(6 * 0.15 / 50));
  EXPECT_EQ(regain_time(s, 1e-9, 0.0, 2.0), 0.02);
  EXPECT_EQ(regain_time(s, 1e30, 0.0, 2.0), 0.4);
  EXPECT_EQ(regain_time(s, inf, 0.0, 2.0), 0.4);
  EXPECT_EQ(regain_time(s, 0.1, 0.1, 0.0), 0.4) << "a blade that nothing moves";
  EXPECT_EQ(regain_time(s, 0.1, 0.0, 0.0), 0.4);
  EXPECT_EQ(regain_time(s, inf - inf, 0.0, 2.0), 0.0);
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
  for (auto member : {&G::strength, &G::min_regain, &G::max_regain, &G::recover_time, &G::lever}) {
    EXPECT_TRUE(refused(member, 0));
    EXPECT_TRUE(refused(member, -1));
    EXPECT_TRUE(refused(member, inf));
    EXPECT_TRUE(refused(member, inf - inf));
  }
  EXPECT_TRUE(refused(&G::max_regain, 0.001));
}

}  // namespace
}  // namespace batuta
