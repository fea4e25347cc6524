// SPDX-License-Identifier: MIT
#pragma once
// What the queries of one row cost.

#include <algorithm>

#include "section.hpp"

namespace batuta::report {

struct Figures {
  std::uint64_t queries = 0;
  std::uint64_t sum = 0;  ///< of the evaluations
  double worst = 0;
  Histogram evaluations;

  void add(std::uint32_t count) {
    ++queries;
    sum += count;
    worst = std::max(worst, static_cast<double>(count));
    evaluations.add(count);
  }
};

}  // namespace batuta::report
