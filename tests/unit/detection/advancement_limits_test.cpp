// SPDX-License-Identifier: MIT
// Budgets, degenerate motions, touching starts, and input that makes no sense.
#include <gtest/gtest.h>

#include <limits>

#include "advancement_cases.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class AdvancementLimits : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(AdvancementLimits, Scalars);

Case two_bars(double x, double speed) {
  return {"T01", bar_y(0, 0), bar_y(x, speed)};
}

TYPED_TEST(AdvancementLimits, AnyBudget_StopsBeforeContactOrTellsTheTruth) {  // T46
  for (const Case& c : all_cases()) {
    const auto full = search_truly(ask<TypeParam>(c), c.name);
    TypeParam t_free = 0;
    for (std::uint32_t budget = 0; budget <= full.evaluations; ++budget) {  // Bound: kAmple
      const auto found = search_truly(ask<TypeParam>(c, kContactTolerance, budget), c.name);
      EXPECT_GE(found.t_free, t_free) << c.name << ", budget " << budget;
      t_free = found.t_free;
      if (found.outcome == Outcome::kBudget) continue;
      EXPECT_EQ(found.outcome, full.outcome) << c.name << ", budget " << budget;
    }
    EXPECT_EQ(t_free, full.t_free) << c.name;
  }
}

TYPED_TEST(AdvancementLimits, LastingNearContactWithBudgetFour_IsFreeForAWhile) {  // T46
  for (const Case& c : delicate_cases()) {
    if (std::string(c.name) != "T18") continue;
    const auto found = search_truly(ask<TypeParam>(c, kContactTolerance, 4), c.name);
    EXPECT_EQ(found.outcome, Outcome::kBudget);
    EXPECT_GT(found.t_free, 0);
    return;
  }
  FAIL() << "there is no T18";
}

TYPED_TEST(AdvancementLimits, NoBudget_NoDistanceIsLookedAt) {  // T46
  const auto found = search_truly(ask<TypeParam>(two_bars(3, -4), kContactTolerance, 0), "T46");
  EXPECT_EQ(found.outcome, Outcome::kBudget);
  EXPECT_EQ(found.evaluations, 0U);
}

template <class Scalar>
Outcome outcome_at_once(double x, Scalar duration, double speed) {
  auto A = moving<Scalar>(bar_y(0, 0));
  auto B = moving<Scalar>(bar_y(x, speed));
  A.motion.duration = duration;
  B.motion.duration = duration;
  return search_truly(ask<Scalar>(A, B), "at x = " + std::to_string(x)).outcome;
}

TYPED_TEST(AdvancementLimits, NoTimeOrNoSpeed_AnswerOfTheStart) {  // T47, T48
  EXPECT_EQ(outcome_at_once<TypeParam>(.3, 0, -4), Outcome::kFree);
  EXPECT_EQ(outcome_at_once<TypeParam>(.15, 0, -4), Outcome::kTouching);
  EXPECT_EQ(outcome_at_once<TypeParam>(.3, 1, 0), Outcome::kFree);
  for (const double x : {.15, 0., .199}) {
    EXPECT_EQ(outcome_at_once<TypeParam>(x, 1, 0), Outcome::kTouching);
  }
}

TYPED_TEST(AdvancementLimits, SameBodyTwice_TouchesWithUnitNormal) {  // T49
  const auto found = search_truly(ask<TypeParam>(two_bars(0, 0)), "T49");
  ASSERT_EQ(found.outcome, Outcome::kTouching);
  EXPECT_NEAR(found.witness.axes.normal_AB.norm(), 1, 4 * kRoundOff<TypeParam>);
}

TYPED_TEST(AdvancementLimits, DeepAndParting_TouchesThenLeaves) {  // T50
  const auto found = search_truly(ask<TypeParam>(two_bars(.199, 4)), "T50");
  ASSERT_EQ(found.outcome, Outcome::kTouching);
  EXPECT_NEAR(found.gap_rate, 4, 1e-5);
  EXPECT_EQ(search_truly(ask<TypeParam>(two_bars(.2001, 4)), "T50").outcome, Outcome::kFree);
}

TYPED_TEST(AdvancementLimits, NotANumber_IsRefused) {  // T51
  const TypeParam inf = std::numeric_limits<TypeParam>::infinity();
  const auto good = moving<TypeParam>(bar_y(0, 0));
  for (const TypeParam bad : {inf, -inf, std::numeric_limits<TypeParam>::quiet_NaN()}) {
    for (int place = 0; place < 5; ++place) {  // Bound: five fields
      auto m = good;
      if (place == 0) m.capsule_B.axis.a.y() = bad;
      if (place == 1) m.capsule_B.radius = bad;
      if (place == 2) m.motion.X_WB.p_W.x() = bad;
      if (place == 3) m.motion.twist.v_W.z() = bad;
      if (place == 4) m.motion.twist.w_W.x() = bad;
      EXPECT_FALSE(make_moving_pair(m, good).ok());
      EXPECT_FALSE(make_moving_pair(good, m).ok());
    }
    auto asked = ask<TypeParam>(two_bars(3, -4));
    asked.pair.B.ends[0].start.x() = bad;
    const auto found = search_advancement(asked.pair, asked.options);
    EXPECT_EQ(found.t_free, 0) << "nothing can be claimed of a pair that make_moving_pair refuses";
    EXPECT_EQ(found.outcome, Outcome::kInvalid);
  }
  auto negative = good;
  negative.capsule_B.radius = -1;
  EXPECT_FALSE(make_moving_pair(negative, good).ok());
}

TYPED_TEST(AdvancementLimits, SpinBeyondTheLimit_IsRefused) {  // T51, T20
  const auto spinning = moving<TypeParam>(bar_y(.21, 0, {0, 1e4, 0}));
  EXPECT_FALSE(make_moving_pair(moving<TypeParam>(bar_y(0, 0)), spinning).ok());
}

/// Rounding of the axis shows after many turns, and the least contact tolerance grows with them:
/// float is asked for fewer.
TYPED_TEST(AdvancementLimits, SpinAboutTheOwnAxis_ShowsNothing) {  // T20
  const Vec3<double> w(0, 1e4, 0);
  const double duration = std::is_same_v<TypeParam, float> ? 0.02 : 0.25;
  for (const auto& [w_A, w_B] : {std::pair{w, kO}, std::pair{kO, w}, std::pair{w, w}}) {
    const auto A = moving<TypeParam>(bar_y(0, 0, w_A), duration);
    const auto B = moving<TypeParam>(bar_y(.21, 0, w_B), duration);
    const auto found = search_truly(ask<TypeParam>(A, B), "T20");
    EXPECT_EQ(found.outcome, Outcome::kFree);
    EXPECT_LE(found.evaluations, 1U);
  }
}

TYPED_TEST(AdvancementLimits, SubnormalLengths_NeverFreeWrongly) {  // T51
  const auto k = static_cast<double>(std::numeric_limits<TypeParam>::min()) / 16;
  const Case tiny{"T51",
                  {kO, {0, -k, 0}, {0, k, 0}, .1 * k},
                  {{3 * k, 0, 0}, {0, -k, 0}, {0, k, 0}, .1 * k, {-4 * k, 0, 0}}};
  const auto pair = make_moving_pair(moving<TypeParam>(tiny.A), moving<TypeParam>(tiny.B));
  if (!pair.ok()) return;
  const auto found = search_advancement(pair.value, AdvancementOptions<TypeParam>{});
  EXPECT_NE(found.outcome, Outcome::kFree);
}

TYPED_TEST(AdvancementLimits, OptionsOutOfRange_AreRefused) {
  auto asked = ask<TypeParam>(two_bars(3, -4));
  const auto outcome = [&](TypeParam contact_tolerance, std::uint32_t budget) {
    AdvancementOptions<TypeParam> options;
    options.contact_tolerance = contact_tolerance;
    options.budget = budget;
    const bool valid = validate(options) == Status::kOk;
    const Outcome found = search_advancement(asked.pair, options).outcome;
    EXPECT_EQ(valid, found != Outcome::kInvalid);
    return found;
  };
  EXPECT_EQ(outcome(TypeParam(-1e-6), 64), Outcome::kInvalid);
  EXPECT_EQ(outcome(TypeParam(1.001), 64), Outcome::kInvalid);
  EXPECT_EQ(outcome(std::numeric_limits<TypeParam>::quiet_NaN(), 64), Outcome::kInvalid);
  EXPECT_EQ(outcome(TypeParam(1e-6), kMaxBudget + 1), Outcome::kInvalid);
  EXPECT_EQ(outcome(TypeParam(1e-6), kMaxBudget), Outcome::kContact);
  EXPECT_EQ(outcome(TypeParam(0), 64), Outcome::kContact);
  EXPECT_EQ(outcome(TypeParam(1), 64), Outcome::kTouching);
}

/// Lengths and times of T08 by a factor, and rates by its inverse.
template <class Scalar>
SearchResult<Scalar> bar_and_post(double length, double time) {
  const auto A = moving<Scalar>(
      {kO, {-length, 0, 0}, {length, 0, 0}, .05 * length, kO, {0, 0, kPi / time}}, time);
  const auto B =
      moving<Scalar>({{0, .8 * length, 0}, {0, 0, -length}, {0, 0, length}, .05 * length}, time);
  return search_truly(ask<Scalar>(A, B, kContactTolerance * length), "T08");
}

TYPED_TEST(AdvancementLimits, FastAndSmall_IsSlowAndLarge) {  // T52
  const auto plain = bar_and_post<TypeParam>(1, 1);
  const auto fast = bar_and_post<TypeParam>(1e-6, 1e-6);
  ASSERT_EQ(fast.outcome, Outcome::kContact);
  const auto k = static_cast<TypeParam>(1e6);
  EXPECT_NEAR(k * fast.t_free, plain.t_free, 16 * kRoundOff<TypeParam>);
}

TYPED_TEST(AdvancementLimits, AstronomicAndMinute_NeverFreeWrongly) {  // T53
  const auto fast = ask<TypeParam>(moving<TypeParam>(bar_y(0, 0), 1e-19),
                                   moving<TypeParam>(bar_y(3, -4e19), 1e-19));
  EXPECT_EQ(search_truly(fast, "T53, fast").outcome, Outcome::kContact);
  const double k = 1e-25;
  const auto small = ask<TypeParam>(
      moving<TypeParam>({kO, {0, -k, 0}, {0, k, 0}, .1 * k}),
      moving<TypeParam>({{3 * k, 0, 0}, {0, -k, 0}, {0, k, 0}, .1 * k, {-4 * k, 0, 0}}),
      kContactTolerance * k);
  EXPECT_EQ(search_truly(small, "T53, small").outcome, Outcome::kContact);
  EXPECT_EQ(bar_and_post<TypeParam>(k, 1).outcome, Outcome::kContact);
}

TYPED_TEST(AdvancementLimits, BodiesInStep_AreFreeAtOnce) {  // T56
  const Case c{"T56", bar_y(0, 5), bar_y(.201, 5)};
  const auto found = search_truly(ask<TypeParam>(c), c.name);
  EXPECT_EQ(found.outcome, Outcome::kFree);
  EXPECT_LE(found.evaluations, 1U);
}

}  // namespace
}  // namespace batuta
