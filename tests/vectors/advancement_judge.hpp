// SPDX-License-Identifier: MIT
#pragma once
// What a search that never misses must keep on every row of toc.csv. With tau =
// contact_tolerance_of() and eps = kInflation L, what advancement.hpp states:
// - a contact on the way is never answered with kFree, one at the start with nothing but kTouching,
//   and the default budget suffices;
// - t_free is never later than the contact, not by a rounding error;
// - kContact and kTouching only where the gap comes down to tau + eps, as it has at t_free and
// t_hit;
// - t_hit errs by no more than the way through tau + eps takes, and mostly by far less.
// The gap at an instant is the reference's, in long double; times and least gaps are the file's.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>
#include <vector>

#include "batuta/detection/search.hpp"
#include "claims.hpp"
#include "contact_row.hpp"
#include "judge_file.hpp"

namespace batuta::test {

using Wide = long double;

/// A contact is ordinary if the two approach faster than this share of S in the duration.
constexpr double kOrdinaryRate = 0.01;

/// Beyond eps / |rate|, what rounding allows, t_hit errs by less than this share of the duration in
/// nearly all ordinary contacts; what is left are grazes and the ends of thin capsules.
constexpr double kTimeError = 1e-6;
constexpr double kTimely = 0.995;

/// Distance evaluations of a contact, generic or fencing: mean, and what 99.9 % do not exceed.
constexpr double kMeanCost = 4.5;
constexpr double kMostCost = 14;

/// Of a contact where nothing turns, and how many of all such queries, some 3,000 in the whole
/// file, take more. The same for a part of the file, which may hold all of these.
constexpr double kSteadyCost = 2;
constexpr long kCostlier = 6;

/// Figures of many queries.
class Sample {
 public:
  void add(double figure) { figures_.push_back(figure); }
  std::size_t size() const { return figures_.size(); }
  double mean() const {
    double sum = 0;
    for (const double figure : figures_) sum += figure;
    return sum / static_cast<double>(size());
  }
  /// What so large a share of them does not exceed. @pre size() > 0, 0 < share <= 1
  double quantile(double share) const {
    std::vector<double> sorted = figures_;
    std::sort(sorted.begin(), sorted.end());
    const double rank = std::ceil(share * static_cast<double>(size()));
    return sorted[static_cast<std::size_t>(rank) - 1];
  }
  /// How many exceed a bound.
  long above(double bound) const {
    return std::count_if(figures_.begin(), figures_.end(), [bound](double x) { return x > bound; });
  }
  /// @pre size() > 0
  double worst() const { return quantile(1); }

 private:
  std::vector<double> figures_;
};

/// One row, and what a search claims about it.
struct Answered {
  ContactTruth truth;
  Claim claim;
  Reference<Wide> reference;
  double uS = 0;  ///< m

  bool says_contact() const {
    return claim.outcome == Outcome::kContact || claim.outcome == Outcome::kTouching;
  }
  double gap(double t) const { return static_cast<double>(reference.gap(t)); }
  double contact_gap() const { return claim.contact_tolerance + claim.inflation; }
};

inline void expect_true(const Answered& row) {
  const Claim& claim = row.claim;
  EXPECT_NE(claim.outcome, Outcome::kInvalid);
  EXPECT_NE(claim.outcome, Outcome::kBudget);
  EXPECT_TRUE(row.truth.kind == kNever || claim.outcome != Outcome::kFree);
  EXPECT_TRUE(row.truth.kind != kAtStart || claim.outcome == Outcome::kTouching);
  EXPECT_LE(0, claim.t_free);
  EXPECT_LE(claim.t_free, claim.t_hit);
  EXPECT_LE(claim.t_hit, static_cast<double>(row.reference.duration()));
  if (row.truth.kind != kOnTheWay) return;
  EXPECT_LE(claim.t_free, row.truth.t);
}

inline void expect_near(const Answered& row) {
  EXPECT_LE(row.truth.least_gap - row.truth.gap_error, row.contact_gap());
  EXPECT_LE(row.gap(row.claim.t_free), row.contact_gap());
  EXPECT_TRUE(row.claim.outcome == Outcome::kTouching ||
              row.gap(row.claim.t_hit) <= row.contact_gap());
}

/// Checks the answers of one search to one file and keeps the worst figures.
template <class Search>
class Judge {
 public:
  void judge(host::QueryRow& row) {
    SCOPED_TRACE(testing::Message() << "line " << row.line());
    const auto pair = read_pair<Scalar>(row);
    ASSERT_TRUE(pair.ok());
    AdvancementOptions<Scalar> options;
    auto found = Search::search(pair.value, options, Vec3<Scalar>::Zero());
    if (found.outcome == Outcome::kBudget) {
      ++unanswered_;
      options.budget *= 2;  // the worst of these queries takes 36
      found = Search::search(pair.value, options, Vec3<Scalar>::Zero());
    }
    const Answered answered{read_truth(row),
                            claim_of(pair.value, options, found),
                            {read_bits(row, "A"), read_bits(row, "B")},
                            static_cast<double>(kRoundOff<Scalar> * pair.value.scale)};
    ASSERT_TRUE(row.ok()) << row.error();
    expect_true(answered);
    all_.add(found.evaluations);
    if (!answered.says_contact()) return;
    expect_near(answered);
    hits_.add(found.evaluations);
    if (answered.claim.outcome != Outcome::kContact) return;
    see_times(answered);
    const std::string_view family = row.text("family");
    if (family == "generic") generic_.add(found.evaluations);
    if (family == "fence60" || family == "fence1ms") fencing_.add(found.evaluations);
  }

 protected:
  using Scalar = typename Search::Scalar;

  void report_times(const char* scalar) const {
    EXPECT_GE(static_cast<double>(timely_), kTimely * static_cast<double>(errors_.size()));
    std::printf(
        "%s: %zu queries, %zu contacts; gap at t_free >= %.3g u S and <= tau %+.3g u S; t_hit of "
        "%zu ordinary contacts: error / T median %.1e, 99 %% %.1e, worst %.1e\n",
        scalar, all_.size(), hits_.size(), least_gap_, most_gap_, errors_.size(),
        errors_.quantile(0.5), errors_.quantile(0.99), errors_.worst());
  }

  static void report_cost(const char* of, const Sample& cost) {
    std::printf("  evaluations, %s: mean %.2f, 99.9 %% %.0f, worst %.0f\n", of, cost.mean(),
                cost.quantile(0.999), cost.worst());
  }

  /// By default one query in ten thousand may be left without an answer.
  void expect_answers(const Evidence& evidence) const {
    EXPECT_LE(10000 * unanswered_, static_cast<long>(evidence.whole));
  }

  const Sample& all() const { return all_; }
  const Sample& hits() const { return hits_; }
  const Sample& generic() const { return generic_; }
  const Sample& fencing() const { return fencing_; }

 private:
  void see_times(const Answered& row) {
    const double gap = row.gap(row.claim.t_free);
    least_gap_ = std::min(least_gap_, gap / row.uS);
    most_gap_ = std::max(most_gap_, (gap - row.claim.contact_tolerance) / row.uS);
    if (row.truth.kind != kOnTheWay) return;
    const double rate = std::abs(row.truth.rate);
    const double T = static_cast<double>(row.reference.duration());
    const double error = std::abs(row.claim.t_hit - row.truth.t);
    EXPECT_LE(error * rate, row.contact_gap());
    if (!(rate * T > kOrdinaryRate * static_cast<double>(row.reference.scale()))) return;
    errors_.add(error / T);
    if (error <= kTimeError * T + row.claim.inflation / rate) ++timely_;
  }

  long unanswered_ = 0;  ///< by the default budget
  // Distance evaluations: of all queries, of contacts, and of contacts on the way by family.
  Sample all_;
  Sample hits_;
  Sample generic_;
  Sample fencing_;
  // Of contacts on the way, and of those of them that are ordinary.
  double least_gap_ = std::numeric_limits<double>::infinity();
  double most_gap_ = -std::numeric_limits<double>::infinity();
  Sample errors_;
  std::size_t timely_ = 0;
};

/// @tparam Search  the library's, or one that is to be found out (planted_faults_test.cpp)
template <class Scalar, class Search = Advancement<Scalar>>
class AdvancementJudge : public Judge<Search> {
 public:
  void report(const char* scalar, const Evidence& evidence) const {
    EXPECT_GE(this->all().size(), evidence.rows);
    EXPECT_GE(this->hits().size(), evidence.part_of(12000));
    this->expect_answers(evidence);
    this->report_times(scalar);
    expect_cheap("generic contacts", this->generic(), evidence);
    expect_cheap("fencing contacts", this->fencing(), evidence);
    this->report_cost("all", this->all());
  }

 private:
  static void expect_cheap(const char* of, const Sample& cost, const Evidence& evidence) {
    EXPECT_GE(cost.size(), evidence.part_of(1000));
    EXPECT_LE(cost.mean(), kMeanCost) << of;
    EXPECT_LE(cost.quantile(0.999), kMostCost) << of;
    AdvancementJudge::report_cost(of, cost);
  }
};

inline bool is_straight(host::QueryRow& row) {
  return read_bits(row, "A").motion.twist.w_W.isZero(0) &&
         read_bits(row, "B").motion.twist.w_W.isZero(0);
}

template <class Scalar, class Search = Translation<Scalar>>
class TranslationJudge : public Judge<Search> {
 public:
  void judge(host::QueryRow& row) {
    if (is_straight(row)) Judge<Search>::judge(row);
  }

  void report(const char* scalar, const Evidence& evidence) const {
    EXPECT_GE(this->all().size(), evidence.part_of(3000));
    EXPECT_GE(this->hits().size(), evidence.part_of(1600));
    EXPECT_LE(this->hits().worst(), kSteadyCost);
    EXPECT_LE(this->all().above(kSteadyCost), kCostlier);
    this->expect_answers(evidence);
    this->report_times(scalar);
    this->report_cost("contacts", this->hits());
    this->report_cost("all", this->all());
  }
};

}  // namespace batuta::test
