// SPDX-License-Identifier: MIT
#pragma once
// Holds the answers of one method to the queries of one family against the truth.

#include "batuta/detection/moving_pair.hpp"
#include "section.hpp"
#include "truth.hpp"

namespace batuta::report {

/// What an answer is judged by besides the truth.
struct Judged {
  const Case& query;
  double contact_gap;  ///< m: contact may be claimed up to here
  double scale;        ///< S of the pair, m
};

/// Distance evaluations of a group of queries.
struct Evaluations {
  std::uint64_t sum = 0;
  Histogram each;

  void add(std::uint32_t evaluations) {
    sum += evaluations;
    each.add(evaluations);
  }
};

/// Counts and histograms of the answers; merges by adding.
class Score {
 public:
  template <class Scalar>
  void add(const SearchResult<Scalar>& answer, const Judged& judged);
  /// Times of one query, ns: with the set-up of the pair, and of the search alone.
  void add_time(double whole, double search, double plain);
  /// The columns after the keys.
  void write(Table& table) const;

 private:
  /// t_free of any answer where the truth is contact: is it free?
  void judge_free(double t_free, const Judged& judged);
  /// Both ends of the bracket of a contact that was found.
  void judge_contact(double t_free, double t_hit, const Judged& judged);

  std::uint64_t queries_ = 0;
  std::uint64_t contacts_ = 0;  ///< in truth; overlaps at the start are among them
  std::array<std::uint64_t, 5> outcomes_{};
  std::uint64_t misses_ = 0;
  std::uint64_t false_contacts_ = 0;
  std::uint64_t late_ = 0;
  double missed_depth_ = 0;
  Histogram error_free_;
  Histogram error_hit_;
  double worst_error_free_ = 0;
  double worst_error_hit_ = 0;
  double worst_late_ = 0;
  double overlap_passed_ = 0;  ///< anywhere before t_free
  double overlap_free_ = 0;
  double overlap_hit_ = 0;
  Evaluations all_;
  Evaluations found_;  ///< of the answers that claim a contact
  Evaluations near_;   ///< of the pairs whose swept boxes meet
  std::uint64_t timed_ = 0;
  double whole_ns_ = 0;
  double search_ns_ = 0;
  double plain_ps_ = 0;
  Histogram whole_ratio_;
  Histogram search_ratio_;
};

}  // namespace batuta::report
