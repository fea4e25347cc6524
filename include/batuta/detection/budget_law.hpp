// SPDX-License-Identifier: MIT
#pragma once
// How many distance evaluations to allow a certified search, for pairs that stay close for a whole
// step:
//   tolerance = kappa^3 / 6 * lever (turn / budget)^3
// `tolerance` is the gap that counts as contact, m; `turn` the furthest that a body turns in the
// step, rad; `lever` the sum of the two distances of the axis ends from their axes of rotation, m.
// Of tolerance, turn and budget each follows from the two others, at compile time. kappa is
// measured, not proven, and pairs that slide along each other at a gap of about the tolerance may
// need more (src/detection/budget_law.md): the search then answers kBudget, free up to t_free.
// Nothing is missed. "Suffices" below means: by the law.

#include "batuta/core/types.hpp"

namespace batuta {

namespace detail {

/// kappa, measured over pairs that stay close for a whole step.
template <class Scalar>
inline constexpr Scalar kBudgetKappa = Scalar(3.4);

/// Below this number of evaluations the law says nothing.
inline constexpr std::uint32_t kLeastLawBudget = 8;

/// Steps of Newton that cube_root() takes.
/// @pre x 0 or 1e-30 ... 1e15
/// Bound: kCubeRootSteps of Newton, from above, where it falls monotonically; then it has settled.
inline constexpr int kCubeRootSteps = 80;
/// x^(1/3), rounded up by at most 4 u relative.
/// @pre x 0 or 1e-30 ... 1e15
/// Bound: kCubeRootSteps of Newton, from above, where it falls monotonically; then it has settled.
template <class Scalar>
constexpr Scalar cube_root(Scalar x) {
  if (!(x > Scalar(0))) return Scalar(0);
  Scalar root = max_of(x, Scalar(1));         // >= the root
  for (int i = 0; i < kCubeRootSteps; ++i) {  // Bound: kCubeRootSteps
    root -= (root - x / (root * root)) / Scalar(3);
  }
  return root * (Scalar(1) + Scalar(4) * kRoundOff<Scalar>);
}

}  // namespace detail

/// Least contact tolerance, over the lever, at which `budget` evaluations suffice.
/// @pre turn >= 0, rad; budget >= kLeastLawBudget
template <class Scalar>
constexpr Scalar contact_tolerance_for(Scalar turn, std::uint32_t budget) {
  const Scalar share = detail::kBudgetKappa<Scalar> * turn / static_cast<Scalar>(budget);
  const Scalar rounded_up = Scalar(1) + Scalar(16) * kRoundOff<Scalar>;
  return share * share * share / Scalar(6) * rounded_up;
}

/// Furthest turn in a step, rad, at which `budget` evaluations suffice for a contact tolerance.
/// @pre contact_tolerance >= 0, over the lever; budget >= kLeastLawBudget
template <class Scalar>
constexpr Scalar turn_for(std::uint32_t budget, Scalar contact_tolerance) {
  const Scalar rounded_down = Scalar(1) - Scalar(16) * kRoundOff<Scalar>;
  return static_cast<Scalar>(budget) / detail::kBudgetKappa<Scalar> *
         detail::cube_root(Scalar(6) * contact_tolerance) * rounded_down;
}

/// Fewest evaluations that suffice.
/// @pre turn >= 0, rad; contact_tolerance > 0, over the lever
/// @returns at least kLeastLawBudget; the largest number there is where no number suffices
template <class Scalar>
constexpr std::uint32_t budget_for(Scalar turn, Scalar contact_tolerance) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  const Scalar root = detail::cube_root(Scalar(6) * contact_tolerance);
  if (!(root > Scalar(0))) return kMost;
  const Scalar share = detail::kBudgetKappa<Scalar> * turn / root;
  constexpr std::uint32_t kConvertible = kMost / 2;
  if (!(share < static_cast<Scalar>(kConvertible))) return kMost;
  const auto whole = static_cast<std::uint32_t>(share);
  const std::uint32_t enough = static_cast<Scalar>(whole) < share ? whole + 1 : whole;
  return max_of(enough, detail::kLeastLawBudget);
}

}  // namespace batuta
