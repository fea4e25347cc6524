// SPDX-License-Identifier: MIT
#pragma once
// What the campaign of misses takes besides the options of every section.

#include <cstdint>
#include <vector>

#include "../section.hpp"

namespace batuta::report {

struct CampaignOptions {
  Options common;
  std::uint64_t seed = 1;  ///< another seed: other queries
  double inflation = 1;    ///< share of the inflation that is left in the search; 1: all
  bool sweeps = true;      ///< whether shares of the inflation are tried in turn as well
};

/// Reads --seed N and --inflation-factor X (which leaves out the sweep), and the common options.
CampaignOptions parse_campaign(int argc, const char* const* argv, const About& about);

}  // namespace batuta::report
