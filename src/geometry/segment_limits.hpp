// SPDX-License-Identifier: MIT
#pragma once
// The numbers that decide which case a pair of segments is: for the kernel that takes one pair, and
// for that which takes one in each lane.

#include "batuta/core/types.hpp"

namespace batuta {

/// sin^2 of the angle above which there is only one closest pair (segment.md).
template <class Scalar>
inline constexpr Scalar kClearAngle2 = Scalar(1) / 256;

/// A distance below this times S is rounding error, its direction means nothing (segment.md).
template <class Scalar>
inline constexpr Scalar kNoise = 4 * kRoundOff<Scalar>;

/// How much longer than the shortest one, over S, the middle pair of a range may be.
template <class Scalar>
inline constexpr Scalar kMiddleSlack = kRoundOff<Scalar> / 2;

/// sin^2 of the angle below which the cross product is rounding error.
template <class Scalar>
inline constexpr Scalar kParallel2 = 64 * kRoundOff<Scalar>* kRoundOff<Scalar>;

}  // namespace batuta
