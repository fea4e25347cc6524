// SPDX-License-Identifier: MIT
#include "measure.hpp"

#include <algorithm>
#include <cmath>

#include "reference.hpp"

namespace batuta::report {

namespace {

constexpr int kSamples = 64;  ///< for the deepest overlap that a late answer passed over

/// Overlap at time t over S, in double; 0 where the capsules are apart.
double overlap_at(const Judged& judged, double t) {
  const auto pair = make_moving_pair(judged.query.A, judged.query.B).value;
  const double gap = gap_at(pair, std::min(t, pair.duration)).gap;
  return std::max(0.0, -gap) / judged.scale;
}

std::uint64_t whole(double value) {
  return static_cast<std::uint64_t>(std::llround(value));
}

}  // namespace

template <class Scalar>
void Score::add(const SearchResult<Scalar>& answer, const Judged& judged) {
  const Truth& truth = judged.query.truth;
  ++queries_;
  ++outcomes_[static_cast<std::size_t>(answer.outcome)];
  contacts_ += truth.contact ? 1 : 0;
  const bool claims = answer.outcome == Outcome::kContact || answer.outcome == Outcome::kTouching;
  all_.add(answer.evaluations);
  if (claims) found_.add(answer.evaluations);
  if (judged.query.meets) near_.add(answer.evaluations);
  if (claims && truth.least_gap > judged.contact_gap) ++false_contacts_;
  if (!truth.contact || answer.outcome == Outcome::kInvalid) return;
  if (answer.outcome == Outcome::kFree) {
    ++misses_;
    missed_depth_ = std::max(missed_depth_, -truth.least_gap / judged.scale);
    return;
  }
  if (truth.time == 0) return;  // overlap at the start: there is no error of time
  const double t_free = static_cast<double>(answer.t_free);
  judge_free(t_free, judged);
  if (claims) judge_contact(t_free, static_cast<double>(answer.t_hit), judged);
}

template void Score::add(const SearchResult<float>&, const Judged&);
template void Score::add(const SearchResult<double>&, const Judged&);

void Score::judge_free(double t_free, const Judged& judged) {
  overlap_free_ = std::max(overlap_free_, overlap_at(judged, t_free));
  const double contact = judged.query.truth.time;
  if (t_free <= contact) return;
  ++late_;
  worst_late_ = std::max(worst_late_, (t_free - contact) / judged.query.A.motion.duration);
  const test::Reference<double> reference(judged.query.A, judged.query.B);
  const double gap = reference.least_gap(contact, t_free, kSamples).gap;
  overlap_passed_ = std::max(overlap_passed_, -gap / judged.scale);
}

void Score::judge_contact(double t_free, double t_hit, const Judged& judged) {
  const double duration = judged.query.A.motion.duration;
  const double error_free = std::abs(t_free - judged.query.truth.time) / duration;
  const double error_hit = std::abs(t_hit - judged.query.truth.time) / duration;
  error_free_.add(error_free);
  error_hit_.add(error_hit);
  worst_error_free_ = std::max(worst_error_free_, error_free);
  worst_error_hit_ = std::max(worst_error_hit_, error_hit);
  overlap_hit_ = std::max(overlap_hit_, overlap_at(judged, t_hit));
}

void Score::add_time(double whole, double search, double plain) {
  ++timed_;
  whole_ns_ += whole;
  search_ns_ += search;
  plain_ps_ += 1000 * plain;
  whole_ratio_.add(whole / plain);
  search_ratio_.add(search / plain);
}

void Score::write(Table& table) const {
  const auto outcome = [this](Outcome o) { return outcomes_[static_cast<std::size_t>(o)]; };
  table.sum("queries", queries_)
      .sum("contacts", contacts_)
      .sum("said_free", outcome(Outcome::kFree))
      .sum("said_contact", outcome(Outcome::kContact))
      .sum("said_touching", outcome(Outcome::kTouching))
      .sum("said_budget", outcome(Outcome::kBudget))
      .sum("said_invalid", outcome(Outcome::kInvalid))
      .sum("misses", misses_)
      .max("missed_depth", missed_depth_)
      .sum("false_contacts", false_contacts_)
      .sum("late", late_)
      .max("worst_late", worst_late_)
      .hist("error_free", error_free_)
      .max("worst_error_free", worst_error_free_)
      .hist("error_hit", error_hit_)
      .max("worst_error_hit", worst_error_hit_)
      .max("overlap_passed", overlap_passed_)
      .max("overlap_free", overlap_free_)
      .max("overlap_hit", overlap_hit_)
      .sum("evaluations_sum", all_.sum)
      .hist("evaluations", all_.each)
      .sum("contact_evaluations_sum", found_.sum)
      .hist("contact_evaluations", found_.each)
      .sum("near_evaluations_sum", near_.sum)
      .hist("near_evaluations", near_.each)
      .sum("time_count", timed_)
      .sum("time_whole_ns", whole(whole_ns_))
      .sum("time_search_ns", whole(search_ns_))
      .sum("time_plain_ps", whole(plain_ps_))
      .hist("time_whole_ratio", whole_ratio_)
      .hist("time_search_ratio", search_ratio_)
      .end_row();
}

}  // namespace batuta::report
