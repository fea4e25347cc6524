// SPDX-License-Identifier: MIT
// The search that never misses, on the hand-made cases of cases.hpp: outcomes, times, costs.
#include <gtest/gtest.h>

#include <cmath>

#include "advancement_cases.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

constexpr double kDigitsGiven = 2e-12;

TEST(AdvancementCases, Table_IsTheReferencesOwn) {
  for (const Case& c : all_cases()) {
    const test::Reference<long double> truth(moving(c.A), moving(c.B));
    const auto march = truth.march(1e-15L * truth.scale());
    if (c.t == kNever) {
      EXPECT_EQ(march.verdict, test::Verdict::kFree) << c.name;
    } else if (std::string(c.name) == "T12" || std::string(c.name) == "T28") {
      // Rounded to double these stay a unit round-off apart.
      EXPECT_LT(std::abs(truth.gap(c.t)), 1e-15) << c.name;
    } else {
      ASSERT_EQ(march.verdict, test::Verdict::kReached) << c.name;
      const double tolerance = std::string(c.name) == "T05" ? 1e-7 : kDigitsGiven;
      EXPECT_NEAR(static_cast<double>(march.t_free), c.t, tolerance) << c.name;
    }
  }
}

/// The gap at t_free is within the contact tolerance, so the time is right to contact tolerance /
/// closing speed, and never late: both are among the claims.
TEST(AdvancementCases, Double_OutcomeAndTimeOfTheTable) {
  for (const Case& c : all_cases()) {
    const auto found = search_truly(ask<double>(c), c.name);
    expect_outcome(c, found.outcome);
    if (found.outcome != Outcome::kContact) continue;
    EXPECT_LE(found.t_free, c.t + kDigitsGiven) << c.name;
    EXPECT_LT(found.gap_rate, kContactTolerance) << c.name;
  }
}

TEST(AdvancementCases, Double_ForeseesWhereTheGapVanishes) {
  for (const Case& c : robust_cases()) {
    if (c.t == kNever) continue;
    const auto found = search_truly(ask<double>(c), c.name);
    if (found.outcome != Outcome::kContact) continue;
    const test::Reference<double> truth(moving(c.A), moving(c.B));
    EXPECT_LE(std::abs(truth.gap(found.t_hit)), kContactTolerance) << c.name;
    EXPECT_LE(found.t_hit - found.t_free, 1e-3) << c.name;
  }
}

TEST(AdvancementCases, Double_SmallerToleranceIsCloser) {
  for (const Case& c : robust_cases()) {
    if (c.t == kNever) continue;
    const auto found = search_truly(ask<double>(c, 1e-12), c.name);
    ASSERT_EQ(found.outcome, Outcome::kContact) << c.name;
    EXPECT_NEAR(found.t_free, c.t, 2e-6 * c.t + 1e-8) << c.name;
  }
}

TEST(AdvancementCases, Float_OutcomeOfTheTable) {
  for (const Case& c : robust_cases()) {
    const auto found = search_truly(ask<float>(c), c.name);
    // Gaps of 1e-5 are within the least contact tolerance of a float: contact is a true answer too.
    const std::string name = c.name;
    const bool slight = name == "T10" || name == "T29";
    if (!slight || found.outcome == Outcome::kFree) expect_outcome(c, found.outcome);
  }
}

/// Where rounding the inputs decides, only what is claimed about the rounded numbers can be held
/// against an answer.
TEST(AdvancementCases, Float_DelicateCasesClaimNothingUntrue) {
  for (const auto& cases : {delicate_cases(), bare_cases()}) {
    for (const Case& c : cases) {
      const auto found = search_truly(ask<float>(c), c.name);
      EXPECT_NE(found.outcome, Outcome::kBudget) << c.name;
    }
  }
}

TEST(AdvancementCases, WideTolerance_TakesNearMissForContact) {
  const Case near{"T06", post_z(kO, .1), ball({-2, .2001, 0}, .1, {4, 0, 0})};
  const auto passed = search_truly(ask<double>(near, 1e-3), near.name);
  EXPECT_TRUE(passed.outcome == Outcome::kFree || passed.outcome == Outcome::kContact);
  const Case slow{"T30", bar_y(0, 0), bar_y(.2001, -1e-3)};
  EXPECT_EQ(search_truly(ask<double>(slow, 1e-3), slow.name).outcome, Outcome::kTouching);
  EXPECT_EQ(search_truly(ask<float>(slow, 1e-3), slow.name).outcome, Outcome::kTouching);
}

constexpr std::uint32_t kDefaultBudget = 64;

/// T18 rolls on within the contact tolerance's reach for the whole step: it has to fit the default
/// budget only. Counts of the prototype in which the method was first tried, contact tolerance 1e-6
/// m.
TEST(AdvancementCases, Double_CostsNoMoreThanThePrototype) {
  const std::vector<std::pair<std::string, std::uint32_t>> prototype = {
      {"T01", 2},  {"T02", 2},   {"T08", 6},
      {"T10", 12}, {"T11", 11},  {"T12", 12},
      {"T16", 6},  {"T17", 1},   {"T18", kDefaultBudget},
      {"T19", 38}, {"T19b", 36}, {"T19b, 2e-6", 324},
      {"T34", 13}, {"T56", 1}};
  std::size_t seen = 0;
  for (const Case& c : all_cases()) {
    for (const auto& [name, count] : prototype) {
      if (name != c.name) continue;
      ++seen;
      EXPECT_LE(search_truly(ask<double>(c), c.name).evaluations, count) << c.name;
    }
  }
  EXPECT_EQ(seen, prototype.size());
}

}  // namespace
}  // namespace batuta
