// SPDX-License-Identifier: MIT
// A search in closed form looks at no instant outside its step.
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

}  // namespace
}  // namespace batuta
