// SPDX-License-Identifier: MIT
#pragma once
// The cases whose energy, momentum and height are drawn over time.

#include "engine.hpp"

namespace batuta::worlds {

enum class Case : std::uint8_t {
  kBounce,  ///< an elastic ball dropped from 1 m
  kRow,     ///< five balls that fly in line at 25 m/s and close at 0.1 m/s in all, C = 0.5
  kTumble,  ///< a rod that turns freely, about no axis of its own
  kStack,   ///< ten crossed layers of two bars each
};
inline constexpr Case kCases[] = {Case::kBounce, Case::kRow, Case::kTumble, Case::kStack};

const char* name(Case which);
/// Long enough to see a trend, s.
double duration(Case which);
/// The bodies that can be moved come first.
Plan plan_of(Case which);

}  // namespace batuta::worlds
