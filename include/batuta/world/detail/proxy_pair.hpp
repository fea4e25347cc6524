// SPDX-License-Identifier: MIT
#pragma once
// What the broad phase speaks of [Kavan §3.2]; which boxes overlap is found by sweep.hpp.

#include <cstdint>

namespace batuta::detail {

/// Two slots, first < second; first == second: no pair.
struct ProxyPair {
  std::uint16_t first = 0;
  std::uint16_t second = 0;
};

}  // namespace batuta::detail
