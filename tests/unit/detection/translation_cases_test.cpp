// SPDX-License-Identifier: MIT
// The closed form on those hand-made cases in which nothing turns.
#include "batuta/detection/translation.hpp"

#include "advancement_cases.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class TranslationCases : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(TranslationCases, Scalars);

bool turns(const Case& c) {
  return c.A.w != kO || c.B.w != kO;
}

TYPED_TEST(TranslationCases, WhatDoesNotTurn_OutcomeOfTheTableInTwoEvaluations) {
  int seen = 0;
  for (const Case& c : all_cases()) {
    if (turns(c)) continue;
    ++seen;
    const auto asked = ask<TypeParam>(c);
    const auto found = search_translation(asked.pair, asked.options);
    expect_true_claims(asked, found, c.name);
    EXPECT_LE(found.evaluations, 2U) << c.name;
    if (std::is_same_v<TypeParam, double>) expect_outcome(c, found.outcome);
  }
  EXPECT_GE(seen, 12);
}

TYPED_TEST(TranslationCases, WhatTurns_IsRefused) {
  for (const Case& c : all_cases()) {
    if (!turns(c)) continue;
    const auto asked = ask<TypeParam>(c);
    EXPECT_EQ(search_translation(asked.pair, asked.options).outcome, Outcome::kInvalid) << c.name;
  }
}

}  // namespace
}  // namespace batuta
