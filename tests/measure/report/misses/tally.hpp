// SPDX-License-Identifier: MIT
#pragma once
// What the reference found wrong with the answers of one search to one family.

#include <array>
#include <cstdint>
#include <string>

#include "../section.hpp"
#include "claims.hpp"

namespace batuta::report {

/// What names a row.
struct TallyKey {
  std::string family;
  std::string scalar;
  std::string search;
  double inflation = 1;
};

class Tally {
 public:
  /// @param round_off  u of the search's scalar
  explicit Tally(double round_off) : round_off_(round_off) {}

  void add(const test::Claim& claim, std::uint32_t evaluations, const test::Truth& truth);
  /// Besides the proof: dense samples of what the claim calls free.
  void probe(const test::Claim& claim, const test::Truth& truth);
  void write(Table& table, const TallyKey& key) const;

  /// Claims of freedom that are not true.
  std::uint64_t untrue() const { return missed_ + late_; }

 private:
  double round_off_;
  std::array<std::uint64_t, 5> outcomes_{};
  std::uint64_t missed_ = 0;
  std::uint64_t late_ = 0;
  std::uint64_t false_contacts_ = 0;
  std::uint64_t loose_ = 0;
  std::uint64_t disordered_ = 0;
  std::uint64_t open_ = 0;  // the reference's own budget was spent
  std::uint64_t probed_ = 0;
  std::uint64_t probe_overlaps_ = 0;
  double overlap_ = 0;  // deepest in what was called free, over u S
  Histogram hit_evaluations_;
  Histogram free_evaluations_;
};

}  // namespace batuta::report
