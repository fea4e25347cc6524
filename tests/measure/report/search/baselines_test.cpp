// SPDX-License-Identifier: MIT
#include "baselines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "timing.hpp"
#include "truth.hpp"

namespace batuta::report {
namespace {

constexpr std::uint64_t kSeed = 3;
constexpr std::uint64_t kQueries = 40;
constexpr double kRounding = 1e-12;  // of a time over the duration

template <class Check>
void for_each_case(Check&& check) {
  for (const test::Family family : {test::Family::kGeneric, test::Family::kBlade,
                                    test::Family::kSpin, test::Family::kTranslation}) {
    for (std::uint64_t i = 0; i < kQueries; ++i) {
      const Case query = make_case(family, kSeed, i);
      check(query, make_moving_pair(query.A, query.B).value);
    }
  }
}

TEST(Conservative, Answers_AreTheTruthToTheTolerance) {
  int contacts = 0;
  for_each_case([&](const Case& query, const MovingPair<double>& pair) {
    constexpr double kContactTolerance = 1e-9;
    const auto answer = search_conservative(pair, kContactTolerance, 100'000);
    ASSERT_NE(answer.outcome, Outcome::kBudget);
    if (query.truth.contact) ++contacts;
    EXPECT_EQ(answer.outcome == Outcome::kFree, !query.truth.contact);
    if (answer.outcome != Outcome::kContact) return;
    EXPECT_LE(answer.t_free, query.truth.time + kRounding * pair.duration);
    EXPECT_LE(gap_at(pair, answer.t_free).gap, kContactTolerance * pair.scale);
  });
  EXPECT_GT(contacts, 40);
}

TEST(Conservative, Budget_EndsFree) {
  for_each_case([](const Case& query, const MovingPair<double>& pair) {
    const auto answer = search_conservative(pair, 1e-9, 3);
    EXPECT_LE(answer.evaluations, 3U);
    if (answer.outcome != Outcome::kBudget) return;
    EXPECT_LE(answer.t_free, query.truth.time + kRounding * pair.duration);
  });
}

TEST(FalsePosition, Bracket_KeepsTheContact) {
  for (const FalsePosition form : {FalsePosition::kPlain, FalsePosition::kIllinois}) {
    for_each_case([form](const Case&, const MovingPair<double>& pair) {
      for (const int iterations : {0, 1, 3, 20}) {
        const auto found = search_false_position(pair, {}, iterations, form);
        if (found.outcome != Outcome::kContact) continue;
        EXPECT_LT(found.t_free, found.t_hit);
        EXPECT_GT(gap_at(pair, found.t_free).gap, 0);
        EXPECT_LE(gap_at(pair, found.t_hit).gap, 0);
      }
    });
  }
}

TEST(FalsePosition, BothForms_FindTheRootWithinTheBracketOfStepping) {
  for (const FalsePosition form : {FalsePosition::kPlain, FalsePosition::kIllinois}) {
    int found_contacts = 0;
    for_each_case([&](const Case&, const MovingPair<double>& pair) {
      SteppingOptions<double> fine;
      fine.halvings = 60;
      const auto truth = search_stepping(pair, fine);
      const auto found = search_false_position(pair, fine, 60, form);
      if (found.outcome != Outcome::kContact) return;
      ++found_contacts;
      const double error =
          std::min(std::abs(found.t_free - truth.t_free), std::abs(found.t_hit - truth.t_free));
      EXPECT_LE(error, 1e-9 * pair.duration);
    });
    EXPECT_GT(found_contacts, 40);
  }
}

TEST(PlainSegmentDistance, GeneralPosition_IsTheDistance) {
  for_each_case([](const Case&, const MovingPair<double>& pair) {
    const detail::CapsulesAt<double> at = detail::capsules_at(pair, 0.0);
    EXPECT_NEAR(plain_segment_distance(at.A.axis, at.B.axis),
                closest_points(at.A.axis, at.B.axis).distance, 1e-12 * pair.scale);
  });
}

}  // namespace
}  // namespace batuta::report
