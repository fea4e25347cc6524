// SPDX-License-Identifier: MIT
#pragma once
// What something that moves in a straight line sweeps along one axis.

#include "batuta/core/types.hpp"

namespace batuta {

template <class Scalar>
struct SweptExtent {
  Scalar low;
  Scalar high;
};

/// What rounding can do to an extent, relative to the sum of the sizes in it (straight_pair.md).
template <class Scalar>
constexpr Scalar kExtentRounding = 6 * kRoundOff<Scalar>;

/// From the place at the start and the travel; rounded outward.
/// @param shape  what of it lies about its place, low <= high
template <class Scalar>
inline SweptExtent<Scalar> swept_extent(Scalar start, Scalar travel,
                                        const SweptExtent<Scalar>& shape) {
  const Scalar end = start + travel;
  const Scalar low = min_of(start, end) + shape.low;
  const Scalar high = max_of(start, end) + shape.high;
  const Scalar size = std::abs(start) + std::abs(end) + max_of(-shape.low, shape.high);
  const Scalar outward = kExtentRounding<Scalar> * size;
  return {low - outward, high + outward};
}

}  // namespace batuta
