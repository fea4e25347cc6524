// SPDX-License-Identifier: MIT
#include "batuta/detection/stepping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "batuta/detection/speed_bound.hpp"
#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class SteppingOf : public testing::Test {
 protected:
  static MovingPair<Scalar> pair_of(const Capsule64& A, const Capsule64& B, double duration = 1) {
    const auto pair = make_moving_pair(moving<Scalar>(A, duration), moving<Scalar>(B, duration));
    EXPECT_TRUE(pair.ok());
    return pair.value;
  }
  /// T01: contact at 0.7.
  const Capsule64 post_{{0, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1};
  const Capsule64 comer_{{3, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {-4, 0, 0}};
  const MovingPair<Scalar> meeting_ = pair_of(post_, comer_);
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SteppingOf, Scalars);

TYPED_TEST(SteppingOf, Contact_BracketIsOneStepHalved) {
  SteppingOptions<TypeParam> options;
  options.epsilon = TypeParam(0.25);
  options.unit = EpsilonIn::kMetres;
  options.halvings = 6;
  const auto found = search_stepping(this->meeting_, options);
  ASSERT_EQ(found.outcome, Outcome::kContact);
  // 4 m at 0.25 m a step: 16 steps, or 17 because the bound is rounded up.
  const double step = 1.0 / 17;
  EXPECT_NEAR(static_cast<double>(found.t_hit - found.t_free), step / 64, 1e-6);
  EXPECT_LE(found.t_free, TypeParam(0.7));
  EXPECT_GE(found.t_hit, TypeParam(0.7) - TypeParam(1e-6));
  EXPECT_EQ(found.evaluations, 1U + 12U + 6U);
  EXPECT_NEAR(static_cast<double>(found.gap_rate), -4, 1e-5);
  EXPECT_EQ(found.witness.gap, gap_at(this->meeting_, found.t_free).gap);
}

TYPED_TEST(SteppingOf, FreePair_IsFreeToTheEnd) {
  const auto found = search_stepping(
      this->pair_of(this->post_, {{3, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {-2, 0, 0}}), {});
  EXPECT_EQ(found.outcome, Outcome::kFree);
  EXPECT_EQ(found.t_free, TypeParam(1));
  EXPECT_EQ(found.t_hit, TypeParam(1));
  EXPECT_NEAR(static_cast<double>(found.witness.gap), 0.8, 1e-6);
}

TYPED_TEST(SteppingOf, OverlapAtTheStart_IsTouching) {
  const auto found = search_stepping(
      this->pair_of(this->post_, {{0.15, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {4, 0, 0}}), {});
  EXPECT_EQ(found.outcome, Outcome::kTouching);
  EXPECT_EQ(found.t_free, TypeParam(0));
  EXPECT_EQ(found.t_hit, TypeParam(0));
  EXPECT_NEAR(static_cast<double>(found.gap_rate), 4, 1e-5);  // T50: it is leaving
  EXPECT_EQ(found.evaluations, 1U);
}

TYPED_TEST(SteppingOf, SameBodyAtTheSamePlace_IsTouchingWithAUnitNormal) {  // T49
  const auto found = search_stepping(this->pair_of(this->post_, this->post_), {});
  EXPECT_EQ(found.outcome, Outcome::kTouching);
  EXPECT_NEAR(static_cast<double>(found.witness.axes.normal_AB.norm()), 1, 1e-6);
}

TYPED_TEST(SteppingOf, NoRelativeMotion_TakesOneEvaluation) {  // T48, T56
  Capsule64 A = this->post_;
  Capsule64 B{{0.201, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {7, 0, 0}};
  A.v = B.v;
  const auto found = search_stepping(this->pair_of(A, B), {});
  EXPECT_EQ(found.outcome, Outcome::kFree);
  EXPECT_EQ(found.t_free, TypeParam(1));
  EXPECT_EQ(found.evaluations, 1U);
}

TYPED_TEST(SteppingOf, NoDuration_TakesOneEvaluation) {  // T47
  const auto found = search_stepping(this->pair_of(this->post_, this->comer_, 0), {});
  EXPECT_EQ(found.outcome, Outcome::kFree);
  EXPECT_EQ(found.t_free, TypeParam(0));
  EXPECT_EQ(found.evaluations, 1U);
}

TYPED_TEST(SteppingOf, BudgetUsedUp_SaysSoAndIsFreeUpToThere) {  // T46
  for (const std::uint32_t budget : {1U, 4U, 50U}) {
    SteppingOptions<TypeParam> options;
    options.max_steps = budget;
    const auto found = search_stepping(this->meeting_, options);
    ASSERT_EQ(found.outcome, Outcome::kBudget);
    EXPECT_GT(found.t_free, TypeParam(0));
    EXPECT_EQ(found.t_hit, TypeParam(1));
    EXPECT_EQ(found.evaluations, budget + 1);
    EXPECT_EQ(found.witness.gap, gap_at(this->meeting_, found.t_free).gap);
    for (int i = 0; i <= 100; ++i) {
      EXPECT_GT(gap_at(this->meeting_, found.t_free * TypeParam(i) / TypeParam(100)).gap,
                TypeParam(0));
    }
  }
}

TYPED_TEST(SteppingOf, BudgetJustEnough_Answers) {
  const auto free = this->pair_of(this->post_, {{3, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {-2, 0, 0}});
  SteppingOptions<TypeParam> options;
  const auto ample = search_stepping(free, options);
  ASSERT_EQ(ample.outcome, Outcome::kFree);
  options.max_steps = ample.evaluations - 1;
  EXPECT_EQ(search_stepping(free, options).outcome, Outcome::kFree);
  options.max_steps -= 1;
  EXPECT_EQ(search_stepping(free, options).outcome, Outcome::kBudget);
}

TYPED_TEST(SteppingOf, EndlessSteps_AreBudgetNotFree) {
  SteppingOptions<TypeParam> options;
  options.unit = EpsilonIn::kMetres;
  options.epsilon = std::numeric_limits<TypeParam>::denorm_min();
  options.max_steps = 100;
  const auto found = search_stepping(this->meeting_, options);
  EXPECT_EQ(found.outcome, Outcome::kBudget);
  EXPECT_LT(found.t_free, TypeParam(0.7));
}

TYPED_TEST(SteppingOf, BadOptions_AreInvalid) {
  const auto outcome = [&](auto change) {
    SteppingOptions<TypeParam> options;
    change(options);
    const auto found = search_stepping(this->meeting_, options).outcome;
    const bool valid = found != Outcome::kInvalid;
    EXPECT_EQ(validate(options), valid ? Status::kOk : Status::kInvalidArgument);
    return found;
  };
  using Options = SteppingOptions<TypeParam>;
  constexpr TypeParam kNan = std::numeric_limits<TypeParam>::quiet_NaN();
  constexpr TypeParam kInfinity = std::numeric_limits<TypeParam>::infinity();
  EXPECT_EQ(outcome([](Options& o) { o.epsilon = 0; }), Outcome::kInvalid);
  EXPECT_EQ(outcome([](Options& o) { o.epsilon = -1; }), Outcome::kInvalid);
  EXPECT_EQ(outcome([](Options& o) { o.epsilon = kNan; }), Outcome::kInvalid);
  EXPECT_EQ(outcome([](Options& o) { o.epsilon = kInfinity; }), Outcome::kInvalid);
  EXPECT_EQ(outcome([](Options& o) { o.max_steps = 0; }), Outcome::kInvalid);
  EXPECT_EQ(outcome([](Options& o) { o.halvings = -1; }), Outcome::kInvalid);
  EXPECT_EQ(outcome([](Options& o) { o.halvings = detail::kMaxHalvings + 1; }), Outcome::kInvalid);
  EXPECT_EQ(outcome([](Options& o) { o.halvings = detail::kMaxHalvings; }), Outcome::kContact);
}

TYPED_TEST(SteppingOf, BadPair_IsInvalid) {
  auto pair = this->meeting_;
  pair.duration = TypeParam(-1);
  EXPECT_EQ(search_stepping(pair, {}).outcome, Outcome::kInvalid);
  pair = this->meeting_;
  pair.scale = std::numeric_limits<TypeParam>::quiet_NaN();
  EXPECT_EQ(search_stepping(pair, {}).outcome, Outcome::kInvalid);
}

// A distance that cannot be told is neither contact nor free, at the start or on the way.
TYPED_TEST(SteppingOf, DistanceThatCannotBeTold_IsInvalid) {
  constexpr TypeParam kHuge = std::numeric_limits<TypeParam>::max();
  auto pair = this->meeting_;
  pair.B.ends[0].start.x() = pair.B.ends[1].start.x() = kHuge;  // beyond kLargestCoordinate
  EXPECT_EQ(search_stepping(pair, {}).outcome, Outcome::kInvalid);
  pair = this->meeting_;
  pair.B.v.x() = kHuge / 2;  // fine at the start, not at the end of the first step
  SteppingOptions<TypeParam> options;
  options.unit = EpsilonIn::kMetres;
  options.epsilon = kHuge;
  EXPECT_EQ(search_stepping(pair, options).outcome, Outcome::kInvalid);
}

TYPED_TEST(SteppingOf, ZeroRadius_NeedsEpsilonInMetres) {
  const Capsule64 point{{2, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, {-4, 0, 0}};
  const auto pair = this->pair_of(this->post_, point);
  EXPECT_EQ(search_stepping(pair, {}).outcome, Outcome::kInvalid);
  SteppingOptions<TypeParam> options;
  options.unit = EpsilonIn::kMetres;
  options.epsilon = TypeParam(0.05);
  const auto found = search_stepping(pair, options);
  EXPECT_EQ(found.outcome, Outcome::kContact);
  EXPECT_NEAR(static_cast<double>(found.t_hit), 0.475, 1e-5);
}

TYPED_TEST(SteppingOf, TouchesDeeperThanHalfEpsilon_AreNeverMissed) {
  SteppingOptions<TypeParam> options;
  options.unit = EpsilonIn::kMetres;
  const double sum = 0.2;
  for (int i = 1; i < 200; ++i) {
    const double depth = 0.0005 * i;
    options.epsilon = static_cast<TypeParam>(1.99 * depth);
    const Capsule64 ball{{-2 - 0.003 * i, sum - depth, 0}, {0, 0, 0}, {0, 0, 0}, 0.1, {4, 0, 0}};
    const Capsule64 post{{0, 0, 0}, {0, 0, -1}, {0, 0, 1}, 0.1};
    EXPECT_EQ(search_stepping(this->pair_of(post, ball), options).outcome, Outcome::kContact) << i;
  }
}

TYPED_TEST(SteppingOf, FarFromTheOrigin_IsTheSameToTheLastBit) {  // T44
  auto A = moving<TypeParam>(this->post_);
  auto B = moving<TypeParam>(
      {{2.5, 0.25, 0}, {-0.5, -0.5, 0}, {0.5, 0.5, 0}, 0.1, {-3, 0, 0}, {0, 1, 2}});
  const auto near = search_stepping(make_moving_pair(A, B).value, {});
  const Vec3<TypeParam> shift(16384, -16384, 16384);
  A.motion.X_WB.p_W += shift;
  B.motion.X_WB.p_W += shift;
  const auto far = search_stepping(make_moving_pair(A, B).value, {});
  ASSERT_EQ(near.outcome, Outcome::kContact);
  EXPECT_EQ(far.outcome, near.outcome);
  EXPECT_EQ(far.t_free, near.t_free);
  EXPECT_EQ(far.t_hit, near.t_hit);
  EXPECT_EQ(far.witness.surface_A, near.witness.surface_A);
}

TYPED_TEST(SteppingOf, Swapped_FindsTheSameTime) {  // T45
  std::mt19937 random(11);
  SteppingOptions<TypeParam> options;
  options.max_steps = 100000;
  int contacts = 0;
  for (int i = 0; i < 200; ++i) {
    auto A = random_moving<TypeParam>(random, 3);
    auto B = random_moving<TypeParam>(random, 3);
    A.motion.X_WB.p_W = -A.motion.twist.v_W / TypeParam(2);  // both pass the origin half-way
    B.motion.X_WB.p_W = -B.motion.twist.v_W / TypeParam(2);
    const auto one = search_stepping(make_moving_pair(A, B).value, options);
    const auto other = search_stepping(make_moving_pair(B, A).value, options);
    EXPECT_EQ(one.outcome, other.outcome) << i;
    if (one.outcome != Outcome::kContact || other.outcome != Outcome::kContact) continue;
    ++contacts;
    const double slack = 1e-4 / max_of(0.1, std::abs(static_cast<double>(one.gap_rate)));
    EXPECT_NEAR(static_cast<double>(one.t_hit), static_cast<double>(other.t_hit), slack) << i;
  }
  EXPECT_GT(contacts, 20);
}

}  // namespace
}  // namespace batuta
