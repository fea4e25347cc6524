// SPDX-License-Identifier: MIT
#pragma once
// Searches that others use, for comparison only: not in the library, and not safe in float.

#include "batuta/detection/moving_pair.hpp"
#include "batuta/detection/stepping.hpp"

namespace batuta::report {

/// Classic directional conservative advancement (Mirtich; also Bullet's and FCL's): from t on, the
/// gap along the normal of t shrinks no faster than a speed, so that gap / speed is free. Contact
/// means gap <= contact_tolerance S. Rounding is not accounted for. Bound: budget evaluations, then
/// kBudget.
template <class Scalar>
SearchResult<Scalar> search_conservative(const MovingPair<Scalar>& pair, Scalar contact_tolerance,
                                         std::uint32_t budget);

enum class FalsePosition : std::uint8_t {
  kPlain,     ///< regula falsi, the choice of Eckstein and Schoemer
  kIllinois,  ///< with the end that stays put weighed down by half
};

/// Stepping's bracket, made smaller by false position instead of bisection.
/// Bound: as search_stepping(), with `iterations` in place of the halvings.
template <class Scalar>
SearchResult<Scalar> search_false_position(const MovingPair<Scalar>& pair,
                                           const SteppingOptions<Scalar>& stepping, int iterations,
                                           FalsePosition form);

}  // namespace batuta::report
