// SPDX-License-Identifier: MIT
// Stepping on the hand-made cases of cases.hpp.
#include <gtest/gtest.h>

#include "batuta/detection/stepping.hpp"
#include "cases.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

SearchResult<double> answer(const Case& c, double epsilon) {
  const auto pair = make_moving_pair(moving(c.A), moving(c.B));
  EXPECT_TRUE(pair.ok()) << c.name;
  SteppingOptions<double> options;
  options.epsilon = epsilon;
  options.max_steps = 10'000'000;
  options.halvings = detail::kMaxHalvings;
  return search_stepping(pair.value, options);
}

/// @param epsilon  times the thinner radius; grazes of 1e-4 and less need a small one
void expect_answer(const Case& c, double epsilon) {
  constexpr double kDigitsGiven = 2e-12;
  const SearchResult<double> found = answer(c, epsilon);
  if (c.t == kNever) {
    EXPECT_EQ(found.outcome, Outcome::kFree) << c.name;
    return;
  }
  ASSERT_EQ(found.outcome, Outcome::kContact) << c.name;
  EXPECT_NEAR(found.t_hit, c.t, kDigitsGiven) << c.name;
  EXPECT_NEAR(found.t_free, c.t, kDigitsGiven) << c.name;
}

TEST(SteppingCases, Translation_FindsTheTime) {
  for (const Case& c : plain_cases()) expect_answer(c, 1e-3);
}
TEST(SteppingCases, Turning_FindsTheTime) {
  for (const Case& c : turning_cases()) expect_answer(c, 2e-4);
}
TEST(SteppingCases, InSpace_FindsTheTime) {
  for (const Case& c : spatial_cases()) expect_answer(c, 0.01);
}

TEST(SteppingCases, AnyScale_SameTime) {  // T38
  for (const double scale : {1e-6, 1e6}) {
    const auto pair = make_moving_pair(
        moving<float>({kO, {-scale, 0, 0}, {scale, 0, 0}, .05 * scale, kO, {0, 0, kPi}}),
        moving<float>({{0, .8 * scale, 0}, {0, 0, -scale}, {0, 0, scale}, .05 * scale}));
    SteppingOptions<float> options;
    options.halvings = detail::kMaxHalvings;
    const auto found = search_stepping(pair.value, options);
    ASSERT_EQ(found.outcome, Outcome::kContact);
    EXPECT_NEAR(found.t_hit, 0.460106912325F, 1e-6F);
  }
}

TEST(SteppingCases, FastAndSmall_IsSlowAndLarge) {  // T52: T08 with lengths and times 1e-6
  const double k = 1e-6;
  const auto pair =
      make_moving_pair(moving({kO, {-k, 0, 0}, {k, 0, 0}, .05 * k, kO, {0, 0, kPi / k}}, k),
                       moving({{0, .8 * k, 0}, {0, 0, -k}, {0, 0, k}, .05 * k}, k));
  const auto found = search_stepping(pair.value, SteppingOptions<double>{});
  ASSERT_EQ(found.outcome, Outcome::kContact);
  EXPECT_NEAR(found.t_hit / k, 0.460106912325, 1e-6);
}

TEST(SteppingCases, AstronomicAndMinute_NeverFreeWrongly) {  // T53
  const auto fast =
      make_moving_pair(moving<float>(bar_y(0, 0), 1e-19), moving<float>(bar_y(3, -4e19), 1e-19));
  ASSERT_TRUE(fast.ok());
  EXPECT_EQ(search_stepping(fast.value, {}).outcome, Outcome::kContact);
  const double k = 1e-25;
  const auto small = make_moving_pair(
      moving<float>({kO, {0, -k, 0}, {0, k, 0}, .1 * k}),
      moving<float>({{3 * k, 0, 0}, {0, -k, 0}, {0, k, 0}, .1 * k, {-4 * k, 0, 0}}));
  ASSERT_TRUE(small.ok());
  const auto found = search_stepping(small.value, {});
  EXPECT_EQ(found.outcome, Outcome::kContact);
  EXPECT_NEAR(found.t_hit, 0.7F, 1e-5F);
}

}  // namespace
}  // namespace batuta
