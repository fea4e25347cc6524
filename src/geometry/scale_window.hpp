// SPDX-License-Identifier: MIT
#pragma once
// Lengths of any size, brought to where their powers neither overflow nor lose bits, without
// rounding.

#include <cstring>

#include "batuta/core/types.hpp"

namespace batuta {

/// Lengths in [kSmallest, kLargest] are worked on as they are; others are multiplied by kStep or 1
/// / kStep until they are, so that the fourth powers in the kernel neither overflow nor lose bits
/// (segment.md, "Scale").
template <class Scalar>
struct ScaleWindow;
template <>
struct ScaleWindow<float> {
  using Bits = std::uint32_t;
  static constexpr float kSmallest = 0x1p-20F;
  static constexpr float kLargest = 0x1p27F;
  static constexpr float kStep = 0x1p40F;
};
template <>
struct ScaleWindow<double> {
  using Bits = std::uint64_t;
  static constexpr double kSmallest = 0x1p-200;
  static constexpr double kLargest = 0x1p200;
  static constexpr double kStep = 0x1p300;
};
constexpr int kMaxScaleSteps = 3;

/// The bits of a number as an integer: compared in fewer instructions than the number, most of all
/// where there is no FPU. Positive numbers are in the order of their bits.
template <class Scalar>
inline typename ScaleWindow<Scalar>::Bits bits_of(Scalar x) {
  typename ScaleWindow<Scalar>::Bits bits;
  static_assert(sizeof(bits) == sizeof(x));
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

/// Whether a length lies in the window, and those up to four times smaller with it, whose square
/// this is; false for zero and for what is not finite.
/// @pre square >= 0 or NaN
template <class Scalar>
inline bool is_in_window(Scalar square) {
  using Window = ScaleWindow<Scalar>;
  const auto least = bits_of<Scalar>(16 * Window::kSmallest * Window::kSmallest);
  const auto most = bits_of<Scalar>(Window::kLargest * Window::kLargest);
  return bits_of(square) - least <= most - least;
}

/// The power of two that brings `length` into the window; 1 for zero and NaN.
template <class Scalar>
Scalar window_scale(Scalar length) {
  using Window = ScaleWindow<Scalar>;
  Scalar scale = 1;
  if (!(length > 0)) return scale;
  for (int i = 0; i < kMaxScaleSteps; ++i) {  // Bound: kMaxScaleSteps
    if (length * scale < Window::kSmallest) scale *= Window::kStep;
    if (length * scale > Window::kLargest) scale /= Window::kStep;
  }
  return scale;
}

}  // namespace batuta
