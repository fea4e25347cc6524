// SPDX-License-Identifier: MIT
#pragma once
// A probe for the arithmetic that the library's promises stand on. The user owns the flags and the
// registers: -ffp-contract=fast, a start-up that sets flush-to-zero, a library that leaves another
// rounding mode behind would change answers without a word. What a compiler tells by macros,
// types.hpp refuses when it compiles; this is for the rest. All of it is + - x and comparisons.

#include <limits>

#include "batuta/core/config.hpp"  // forbids contraction where no flag does
#include "batuta/core/detail/rounds_products.hpp"

namespace batuta {

namespace detail {

/// Whether sums round to the nearest number, and to the even one of two: half a spacing above 1
/// falls back to 1, half a spacing above its odd neighbour goes up. Any directed mode, and ties
/// away from zero, fail one of the two. Bound: no loop.
template <class Scalar>
[[gnu::always_inline]] inline bool rounds_to_nearest_even() {  // GCOVR_EXCL_BR_START
  constexpr Scalar e = std::numeric_limits<Scalar>::epsilon();
  const volatile Scalar one = 1;
  const volatile Scalar odd = Scalar(1) + e;
  const volatile Scalar half = e / 2;
  const Scalar h = half;
  return one + h == Scalar(1) && odd + h == Scalar(1) + 2 * e;
}

/// Whether numbers below the least normal one are kept, as results and as operands. Bound: no loop.
template <class Scalar>
[[gnu::always_inline]] inline bool keeps_denormals() {
  const volatile Scalar least = std::numeric_limits<Scalar>::min();
  const volatile Scalar share = Scalar(0.5);
  const volatile Scalar denormal = least * share;
  const Scalar d = denormal;
  return d + d == std::numeric_limits<Scalar>::min();
}  // GCOVR_EXCL_BR_STOP

}  // namespace detail

/// Whether the calling file, and the thread or context that it runs in, computes as the library
/// needs it for the same bits everywhere and for its error bounds. A few tens of instructions, no
/// library call (in soft float, those of the compiler's own). Meant for a start-up check:
///   `if (!rounds_each_operation<float>()) enter_safe_state(...);`
/// What it does not see: flags of other files, and registers of other threads or interrupt contexts
/// (on a Cortex-M: FPDSCR gives an interrupt handler its own flush-to-zero and rounding mode).
/// @tparam Scalar  float, or double where it is used
/// Bound: no loop. ISR-safe: yes, and worth it where the library runs in a handler.
template <class Scalar>
[[gnu::always_inline]] inline bool rounds_each_operation() {  // GCOVR_EXCL_BR_START
  return detail::rounds_products<Scalar>() && detail::rounds_to_nearest_even<Scalar>() &&
         detail::keeps_denormals<Scalar>();
}  // GCOVR_EXCL_BR_STOP

}  // namespace batuta
