// SPDX-License-Identifier: MIT
#include "tally.hpp"

#include <algorithm>

namespace batuta::report {

void Tally::add(const test::Claim& claim, std::uint32_t evaluations, const test::Truth& truth) {
  const test::Findings found = judge(claim, truth);
  ++outcomes_[static_cast<std::size_t>(claim.outcome)];
  missed_ += found.missed ? 1 : 0;
  late_ += found.late ? 1 : 0;
  false_contacts_ += found.false_contact ? 1 : 0;
  loose_ += found.loose ? 1 : 0;
  disordered_ += found.disordered ? 1 : 0;
  open_ += truth.march().verdict == test::Verdict::kUnknown ? 1 : 0;
  overlap_ = std::max(overlap_, found.overlap / (round_off_ * truth.fast().scale()));
  const bool free = claim.outcome == Outcome::kFree;
  (free ? free_evaluations_ : hit_evaluations_).add(evaluations);
}

void Tally::probe(const test::Claim& claim, const test::Truth& truth) {
  constexpr int kSamples = 64;
  if (claim.outcome == Outcome::kTouching || claim.outcome == Outcome::kInvalid) return;
  ++probed_;
  const auto least = truth.fast().least_gap(0, claim.t_free, kSamples);
  probe_overlaps_ += least.gap < -truth.fast().rounding() ? 1 : 0;
}

void Tally::write(Table& table, const TallyKey& key) const {
  table.key("family", key.family).key("scalar", key.scalar).key("search", key.search);
  table.key("inflation", key.inflation);
  const char* const names[] = {"free", "contact", "touching", "budget", "invalid"};
  for (std::size_t i = 0; i < outcomes_.size(); ++i) table.sum(names[i], outcomes_[i]);
  table.sum("missed", missed_).sum("late", late_).sum("false_contacts", false_contacts_);
  table.sum("loose", loose_).sum("disordered", disordered_).sum("open", open_);
  table.sum("probed", probed_).sum("probe_overlaps", probe_overlaps_);
  table.max("overlap_uS", overlap_);
  table.hist("hit_evaluations", hit_evaluations_).hist("free_evaluations", free_evaluations_);
  table.end_row();
}

}  // namespace batuta::report
