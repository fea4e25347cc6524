// SPDX-License-Identifier: MIT
#pragma once
// The exact motion of a mass on a spring and a damper under a push that grows evenly.

#include "batuta/core/types.hpp"

namespace batuta::port_simulated {

/// M q'' = -k q - c q' + u, u' = constant.
struct Oscillator {
  double mass = 1;       ///< M > 0
  double stiffness = 0;  ///< k >= 0
  double damping = 0;    ///< c >= 0
};

/// (k span + c) span / M up to which kMostSquarings suffice.
inline constexpr double kStiffestSpan = 1e11;

/// (q, q') after `span` seconds from (q, q', u, u') before: the first two rows of the matrix
/// exponential, by its series for a power of two less, squared as often. Error: some 1e-15 of the
/// largest entry for each squaring.
/// @pre span > 0, finite; (k span + c) span / M <= kStiffestSpan
/// Bound: kTerms terms, kMostSquarings squarings.
Eigen::Matrix<double, 2, 4> transition_of(const Oscillator& oscillator, double span);

}  // namespace batuta::port_simulated
