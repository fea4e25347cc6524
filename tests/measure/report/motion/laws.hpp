// SPDX-License-Identifier: MIT
#pragma once
// Laws of motion that have an error at each length of the step: what a formula says against what
// the world does.

#include <string>

namespace batuta::worlds {

struct LawError {
  std::string law;
  std::string scalar;
  double step_us = 0;
  double error = 0;  ///< as a share of what the formula says
};

/// How many laws there are.
inline constexpr int kLaws = 5;
/// A law at one step, in float or double. @pre 0 <= law < kLaws
LawError law_error(int law, bool is_float, double step_us);

}  // namespace batuta::worlds
