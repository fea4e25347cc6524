// SPDX-License-Identifier: MIT
#pragma once
// What is measured for each chunk of the file of queries. Each function stands at the root of a
// stack that is computed as well: their names are known to price.py.

#include "digest/input.hpp"
#include "samples.hpp"

namespace batuta::price {

/// One chunk, and where its figures go.
struct Task {
  digest::Input& input;
  SampleFile& out;
  std::uint32_t every = 1;       ///< takes each so many-th query
  std::uint32_t most_steps = 0;  ///< of a bout
};

}  // namespace batuta::price

extern "C" {
void price_search(const batuta::price::Task& task);
void price_segments(const batuta::price::Task& task);
void price_impulses(const batuta::price::Task& task);
void price_bout(const batuta::price::Task& task, std::uint32_t steps);
}
