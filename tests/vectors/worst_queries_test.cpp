// SPDX-License-Identifier: MIT
// The queries that cost search_advancement the most, as far as hill climbing found them: the
// answers stay true, and no query costs more than the limit for its turn or, where it did so when
// the file was last written, more than then.
//
// worst_queries.csv is written by `batuta_report_climb --mode full --keep FILE`, which adds what it
// finds, with the truth by the reference in long double, and counts anew what the queries of the
// file cost. The first 102 were the worst of an earlier search (two of them exhausted any budget,
// at steps that made no progress); the others are what climbing came to when it no longer fell for
// those. A count that a new run raises is a regression: look at it before it is kept.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "batuta/detection/advancement.hpp"
#include "contact_row.hpp"

namespace batuta {
namespace {

using test::kAtStart;
using test::kNever;
using test::kOnTheWay;

/// What any query may cost: up to a turn of 45 degrees, and beyond.
constexpr std::uint32_t kLimit45 = 25;
constexpr std::uint32_t kLimit180 = 75;

struct CostlyTruth {
  int kind = kNever;
  double t = 0;                  ///< s; free until here
  double least_gap = 0;          ///< m; what sampling found, so not below the truth
  double contact_tolerance = 0;  ///< m
  std::uint32_t limit = 0;
};

CostlyTruth read_truth(host::QueryRow& row) {
  CostlyTruth truth;
  truth.kind = static_cast<int>(row.decimal("kind"));
  truth.t = row.decimal("t");
  truth.least_gap = row.decimal("gmin");
  truth.contact_tolerance = row.decimal("contact_tolerance");
  const std::uint32_t limit = row.decimal("degrees") <= 45 ? kLimit45 : kLimit180;
  truth.limit = std::max(limit, static_cast<std::uint32_t>(row.decimal("evaluations")));
  return truth;
}

template <class Scalar>
AdvancementOptions<Scalar> options_for(const MovingPair<Scalar>& pair, const CostlyTruth& truth) {
  AdvancementOptions<Scalar> options;
  options.contact_tolerance = static_cast<Scalar>(truth.contact_tolerance) / pair.scale;
  return options;
}

/// The gap in double, whatever the search computed in.
double gap_when(host::QueryRow& row, double t) {
  return gap_at(test::read_pair<double>(row).value, t).gap;
}

/// Free as long as it says so, and in contact only where it is.
template <class Scalar>
void expect_true(host::QueryRow& row, const CostlyTruth& truth, const MovingPair<Scalar>& pair,
                 const SearchResult<Scalar>& found) {
  const auto contact_tolerance =
      static_cast<double>(contact_tolerance_of(pair, options_for(pair, truth)));
  const auto inflation = 2 * static_cast<double>(detail::kInflation<Scalar> * pair.scale);
  const auto t_free = static_cast<double>(found.t_free);
  EXPECT_TRUE(truth.kind != kOnTheWay || t_free <= truth.t);
  EXPECT_TRUE(truth.kind != kAtStart || found.outcome == Outcome::kTouching);
  EXPECT_TRUE(found.outcome != Outcome::kFree || truth.kind == kNever);
  if (found.outcome != Outcome::kContact && found.outcome != Outcome::kTouching) return;
  EXPECT_LE(gap_when(row, t_free), contact_tolerance + inflation);
  EXPECT_TRUE(truth.kind != kNever || truth.least_gap <= contact_tolerance + inflation);
}

template <class Scalar>
void judge(host::QueryRow& row, const CostlyTruth& truth) {
  const auto read = test::read_pair<Scalar>(row);
  ASSERT_TRUE(read.ok());
  const MovingPair<Scalar>& pair = read.value;
  AdvancementOptions<Scalar> options = options_for(pair, truth);
  const SearchResult<Scalar> within_budget = search_advancement(pair, options);
  EXPECT_NE(within_budget.outcome, Outcome::kInvalid);
  expect_true(row, truth, pair, within_budget);
  options.budget = kMaxBudget;
  const SearchResult<Scalar> found = search_advancement(pair, options);
  EXPECT_LE(found.evaluations, truth.limit);
  const bool may_run_out = truth.limit >= kMaxBudget;
  EXPECT_TRUE(found.outcome != Outcome::kBudget || may_run_out);
  expect_true(row, truth, pair, found);
}

template <class Scalar>
void judge_all() {
  std::ifstream in(BATUTA_WORST_QUERIES);
  host::QueryFile file(in);
  ASSERT_TRUE(file.ok()) << file.error();
  host::QueryRow row;
  long rows = 0;
  while (file.next(row)) {  // Bound: the length of the file
    SCOPED_TRACE(testing::Message() << "line " << row.line());
    const CostlyTruth truth = read_truth(row);
    judge<Scalar>(row, truth);
    ASSERT_TRUE(row.ok()) << row.error();
    ++rows;
  }
  EXPECT_GE(rows, 150);
}

TEST(WorstQueries, Double_TrueAndNoneCostsMoreThanItMay) {
  judge_all<double>();
}
TEST(WorstQueries, Float_TrueAndNoneCostsMoreThanItMay) {
  judge_all<float>();
}

}  // namespace
}  // namespace batuta
