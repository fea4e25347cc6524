// SPDX-License-Identifier: MIT
#pragma once
// A climb to better keys: a few knobs at a time are moved at random, and what is better on the
// tries that it was found with has to be better on others as well.

#include "table.hpp"

namespace fight {

struct SearchOrder {
  int tries;  ///< of each case, for every comparison; fewer than 16 find what only seems better
  int rounds;
  std::uint64_t seed;
  std::string path;  ///< of the knobs: read, and written whenever they are better
};

/// Moves one to three of the knobs by up to a few of their steps.
Knobs moved(const Knobs& knobs, Random& random);

/// @returns what is wrong; empty: it has run
std::string search(const SearchOrder& order);

}  // namespace fight
