// SPDX-License-Identifier: MIT
#pragma once
// Whole numbers of a float without libm, which firmware does not link: floor() is a function there.

namespace batuta::detail {

/// The largest whole number that is no more than x: that of std::floor(), but for the sign of a
/// zero. What is not a number, or beyond all numbers, stays. Bound: no loop.
constexpr float whole_below(float x) {
  constexpr float kAllWhole = 8388608;  // 2^23: from here on a float has no fraction
  if (!(x > -kAllWhole && x < kAllWhole)) return x;
  const auto towards_zero = static_cast<float>(static_cast<int>(x));
  return towards_zero > x ? towards_zero - 1 : towards_zero;
}

}  // namespace batuta::detail
