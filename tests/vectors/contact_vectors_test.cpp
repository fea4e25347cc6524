// SPDX-License-Identifier: MIT
// Stepping against times of contact known to many digits, for both scalars. What is claimed
// for epsilon = half the thinner radius, with P = kGapRounding u S (1 + turn) for the rounding of a
// gap (src/detection/moving_pair.md):
// - FREE only where the overlap is nowhere deeper than epsilon / 2 + P;
// - CONTACT and TOUCHING only where there is one, to within P;
// - a first contact that lasts longer than one step is bracketed, to within P / |rate|; a shorter
//   one may be passed over for a later one, never for an earlier.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "batuta/detection/speed_bound.hpp"
#include "batuta/detection/stepping.hpp"
#include "contact_row.hpp"
#include "judge_file.hpp"

namespace batuta {
namespace {

constexpr double kGapRounding = 4;
constexpr double kTimeRounding = 4;  // neighbouring numbers, and the rounding of an instant, in u T

using test::ContactTruth;
using test::kAtStart;
using test::kNever;

template <class Scalar>
struct Query {
  MovingPair<Scalar> pair;
  double rounding = 0;  ///< P, m
};

template <class Scalar>
Query<Scalar> read_query(host::QueryRow& row) {
  const auto pair = test::read_pair<Scalar>(row);
  EXPECT_TRUE(pair.ok()) << "line " << row.line();
  const double turn = static_cast<double>(max_of(pair.value.A.turn_rate, pair.value.B.turn_rate)) *
                      static_cast<double>(pair.value.duration);
  const auto uS = static_cast<double>(kRoundOff<Scalar> * pair.value.scale);
  return {pair.value, kGapRounding * uS * (1 + turn)};
}

/// What the least gap surely is not below, m.
double least_gap(const ContactTruth& truth) {
  return truth.least_gap - truth.gap_error;
}

/// Checks the answers to one file and keeps the worst figures.
template <class Scalar>
class Judge {
 public:
  void judge(host::QueryRow& row) {
    const Query<Scalar> query = read_query<Scalar>(row);
    const ContactTruth truth = test::read_truth(row);
    ASSERT_TRUE(row.ok()) << row.error();
    line_ = row.line();
    gap_at_start_ = std::abs(static_cast<double>(gap_at(read_query<double>(row).pair, 0.0).gap));
    SteppingOptions<Scalar> options;
    options.max_steps = kAmple;
    options.halvings = detail::kMaxHalvings;
    const SearchResult<Scalar> found = search_stepping(query.pair, options);
    check(query, truth, found);
    ++queries_;
  }

  void report(const char* scalar, const test::Evidence& evidence) const {
    EXPECT_GE(queries_, evidence.rows);
    EXPECT_GE(bracketed_, evidence.part_of(10000));
    std::printf(
        "contact, %s: %zu queries, %zu first contacts bracketed, worst rounding %.2f u S "
        "(1 + turn) (line %ld), deepest missed %.3f epsilon\n",
        scalar, queries_, bracketed_, worst_ * kGapRounding, worst_line_, deepest_missed_);
  }

 private:
  static constexpr std::uint32_t kAmple = 10'000'000;

  static double epsilon(const Query<Scalar>& query) {
    return 0.5 * static_cast<double>(min_of(query.pair.A.radius, query.pair.B.radius));
  }

  static double step_of(const Query<Scalar>& query) {
    const auto V = static_cast<double>(closing_speed_bound(query.pair));
    const auto T = static_cast<double>(query.pair.duration);
    return T / std::ceil(T * V / epsilon(query));
  }

  void see_rounding(double error, double bound) {
    EXPECT_LE(error, bound) << "line " << line_;
    if (error > worst_ * bound) {
      worst_ = error / bound;
      worst_line_ = line_;
    }
  }

  void check(const Query<Scalar>& query, const ContactTruth& truth,
             const SearchResult<Scalar>& found) {
    switch (found.outcome) {
      case Outcome::kFree:
        return check_free(query, truth);
      case Outcome::kTouching:
        return check_touching(query, truth);
      case Outcome::kContact:
        return check_contact(query, truth, found);
      default:
        FAIL() << "line " << line_ << ": neither budget nor query is bad";
    }
  }

  void check_free(const Query<Scalar>& query, const ContactTruth& truth) {
    if (truth.kind == kNever) return;
    if (truth.kind == kAtStart) return see_rounding(gap_at_start_, query.rounding);
    EXPECT_LE(-least_gap(truth), epsilon(query) / 2 + query.rounding) << "line " << line_;
    deepest_missed_ = std::max(deepest_missed_, -least_gap(truth) / epsilon(query));
  }

  void check_touching(const Query<Scalar>& query, const ContactTruth& truth) {
    if (truth.kind != kAtStart) see_rounding(gap_at_start_, query.rounding);
  }

  void check_contact(const Query<Scalar>& query, const ContactTruth& truth,
                     const SearchResult<Scalar>& found) {
    EXPECT_GT(found.witness.gap, Scalar(0)) << "line " << line_;
    const double uT = static_cast<double>(kRoundOff<Scalar> * query.pair.duration);
    const auto t_free = static_cast<double>(found.t_free);
    const auto t_hit = static_cast<double>(found.t_hit);
    EXPECT_LE(t_hit - t_free, kTimeRounding * uT) << "line " << line_;
    if (truth.kind == kNever) return see_rounding(least_gap(truth), query.rounding);
    if (truth.kind == kAtStart) return see_rounding(gap_at_start_, query.rounding);
    const double rate = std::abs(truth.rate);
    see_rounding((truth.t - t_hit) * rate, query.rounding);
    if (truth.lasts <= step_of(query) + kTimeRounding * uT) return;
    see_rounding((t_free - truth.t) * rate, query.rounding);
    ++bracketed_;
  }

  long line_ = 0;
  double gap_at_start_ = 0;
  std::size_t queries_ = 0;
  std::size_t bracketed_ = 0;
  double worst_ = 0;
  long worst_line_ = 0;
  double deepest_missed_ = 0;
};

TEST(ContactVectors, Double_EveryDeepContactFoundInItsBracket) {
  test::judge_file<Judge<double>>(test::kTimes, "double");
}
TEST(ContactVectors, Float_EveryDeepContactFoundInItsBracket) {
  test::judge_file<Judge<float>>(test::kTimes, "float");
}

}  // namespace
}  // namespace batuta
