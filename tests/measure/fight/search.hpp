// SPDX-License-Identifier: MIT
#pragma once
// A climb to better keys: a few knobs at a time are moved at random. What is better at a glance is
// kept if it is better on tries that nobody has seen before.

#include "table.hpp"

namespace fight {

struct SearchOrder {
  int tries;  ///< of each case, to keep what is better; with fewer than 16 it only seems so
  int rounds;
  std::uint64_t seed;
  std::string path;  ///< of the knobs: read, and written whenever they are better
};

/// Moves one to three of the knobs by up to a few of their steps.
Knobs moved(const Knobs& knobs, Random& random);

/// @returns what is wrong; empty: it has run
std::string search(const SearchOrder& order);

}  // namespace fight
