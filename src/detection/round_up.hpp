// SPDX-License-Identifier: MIT
#pragma once
// How an upper bound stays one when it is rounded.

#include "batuta/geometry/direction.hpp"

namespace batuta {

/// What a sum of a few length() is multiplied with to be an upper bound: more than the 5 u of each,
/// 2 u of a product and 1 u of each of at most eight additions.
template <class Scalar>
inline constexpr Scalar kRoundUp = 1 + 16 * kRoundOff<Scalar>;

/// What a step is multiplied with: covers the rounding of a root or a quotient.
template <class Scalar>
inline constexpr Scalar kRoundDown = 1 - 16 * kRoundOff<Scalar>;

}  // namespace batuta
