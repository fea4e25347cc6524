// SPDX-License-Identifier: MIT
// Where a search in closed form looks: at no instant outside its step, and at the right one.
#include "batuta/detection/translation.hpp"

#include "advancement_cases.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

/// The middles of a slanted bar and a ball come nearest after 1.29 steps, when the bar would be
/// within the ball; in the step it stays 0.18 m away.
TEST(Translation, NearestAfterTheEnd_WitnessIsOfTheStep) {
  const Capsule64 ball{kO, kO, kO, 0.1};
  Capsule64 bar{{1, 0, 0}, {0, -0.2, 0}, {-0.2, 3, 0}, 0.0};
  bar.v = {-0.7, 0, 0};
  const auto asked = ask(moving<double>(ball), moving<double>(bar));
  const auto found = search_translation(asked.pair, asked.options);
  EXPECT_EQ(found.outcome, Outcome::kFree);
  ASSERT_GT(found.evaluations, 0U) << "the line between the middles must not do";
  EXPECT_GT(found.witness.gap, 0.15);
}

/// A ball passes another of one diameter, 1 m, off by `aside`. The line between the middles proves
/// it free up to a gap of 7/8 tau. That is a touch at the start alone: here the entry at 3/4 tau
/// (translation.md) lies ahead, and one evaluation proves the way to it.
TEST(Translation, SeenWithinTheToleranceOnTheWay_IsContactWhereItIsPredicted) {
  for (const double aside : {0.3, 0.5, 0.7}) {
    const Capsule64 A{kO, kO, kO, 0.5};
    Capsule64 B{{3, aside, 0}, kO, kO, 0.5};
    B.v = {-3, 0, 0};
    // In the direction of the start, (3, aside), the two are 1 m apart at this x:
    const double x = (std::sqrt(9 + aside * aside) - aside * aside) / 3;
    const double gap = std::sqrt(x * x + aside * aside) - 1;
    const double tau = gap / 0.875;
    const double entry = 1 + 0.75 * tau;
    const auto asked = ask(moving<double>(A), moving<double>(B), tau);
    const auto found = search_translation(asked.pair, asked.options);
    expect_true_claims(asked, found, "balls");
    EXPECT_EQ(found.outcome, Outcome::kContact);
    EXPECT_NEAR(found.t_free, (3 - std::sqrt(entry * entry - aside * aside)) / 3, 1e-12) << aside;
    EXPECT_EQ(found.evaluations, 1U) << aside;
  }
}

/// Two bars that meet tip to tip, each named by either end first: the closed form knows the
/// instant.
TEST(Translation, TipMeetsTip_IsFoundInTwoEvaluations) {
  const Vec3<double> tail_A{-1, -0.4, 0.1};
  const Vec3<double> tail_B{1, 0.3, -0.4};
  for (const bool A_turned : {false, true}) {
    for (const bool B_turned : {false, true}) {
      const Capsule64 A{kO, A_turned ? tail_A : kO, A_turned ? kO : tail_A, 0.05};
      Capsule64 B{{2, 0, 0}, B_turned ? tail_B : kO, B_turned ? kO : tail_B, 0.05};
      B.v = {-3, 0, 0};
      const auto asked = ask(moving<double>(A), moving<double>(B));
      const auto found = search_translation(asked.pair, asked.options);
      EXPECT_EQ(found.outcome, Outcome::kContact);
      EXPECT_NEAR(found.t_hit, 1.9 / 3, 1e-5);
      EXPECT_LE(found.evaluations, 2U) << A_turned << B_turned;
    }
  }
}

}  // namespace
}  // namespace batuta
