// SPDX-License-Identifier: MIT
// Every claim on a thousand queries of each family, and on queries that once went wrong. The
// campaign of tests/measure/report/misses asks ten thousand times as many.
#include <gtest/gtest.h>

#include <string>

#include "batuta/detection/translation.hpp"
#include "claims.hpp"
#include "ensemble.hpp"

namespace batuta {
namespace {

using test::Family;

template <class Scalar>
class AdvancementEnsemble : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(AdvancementEnsemble, Scalars);

template <class Scalar>
void expect_true_claims(const test::Query& query, const std::string& what) {
  const auto pair = make_moving_pair(test::cast<Scalar>(query.A), test::cast<Scalar>(query.B));
  const AdvancementOptions<Scalar> options;
  const test::Truth truth(query.A, query.B);
  const auto found = search_advancement(pair.value, options);
  const auto findings = judge(test::claim_of(pair.value, options, found), truth);
  EXPECT_FALSE(findings.wrong()) << what << ": overlap " << findings.overlap;
  EXPECT_NE(found.outcome, Outcome::kBudget) << what;
  if (pair.value.A.turn_rate + pair.value.B.turn_rate > 0) return;
  const auto translated = search_translation(pair.value, options);
  EXPECT_FALSE(judge(test::claim_of(pair.value, options, translated), truth).wrong()) << what;
  EXPECT_LE(translated.evaluations, 8U) << what;
}

TYPED_TEST(AdvancementEnsemble, EveryFamily_EveryClaimIsTrue) {
  constexpr std::uint64_t kSeed = 54;  // T54
  for (const Family family : test::kFamilies) {
    for (std::uint64_t i = 0; i < 1000; ++i) {  // Bound: 1000 queries
      expect_true_claims<TypeParam>(test::make_query(family, kSeed, i),
                                    test::name(family) + (' ' + std::to_string(i)));
    }
  }
}

/// The path of the normal leant towards the normal itself where the axes were all but parallel.
TYPED_TEST(AdvancementEnsemble, AxesThatTurnOutOfParallel_NotLate) {
  for (const std::uint64_t i : {9017U, 9218U, 13382U}) {
    expect_true_claims<TypeParam>(test::make_query(Family::kUnfolding, 7, i), std::to_string(i));
  }
}

}  // namespace
}  // namespace batuta
