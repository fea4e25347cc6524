// SPDX-License-Identifier: MIT
#pragma once
// The part of core/arithmetic.hpp that flags of a compiler are likely to change.

#include <limits>

#include "batuta/core/config.hpp"

namespace batuta::detail {

/// Whether x y + z is rounded twice, in the code around the call. Fused, it is rounded once:
/// (1 + e)^2 = 1 + 2 e + e^2 rounds to 1 + 2 e, and a fused sum keeps the e^2.
/// Inlined even without optimisation: it tells about the flags of the file that calls it, not about
/// those of the file whose copy the linker happens to keep. Bound: no loop.
template <class Scalar>
[[gnu::always_inline]] inline bool rounds_products() {  // GCOVR_EXCL_BR_START
  constexpr Scalar e = std::numeric_limits<Scalar>::epsilon();
  const volatile Scalar operand = Scalar(1) + e;  // volatile: nothing is computed by the compiler
  const volatile Scalar rounded = Scalar(1) + 2 * e;
  const Scalar x = operand;
  const Scalar y = operand;
  const Scalar z = rounded;
  const bool difference_is_rounded = x * y - z == Scalar(0);
  const Scalar a = operand;
  const Scalar b = operand;
  const bool remainder_is_rounded = z - a * b == Scalar(0);
  return difference_is_rounded && remainder_is_rounded;
}  // GCOVR_EXCL_BR_STOP

}  // namespace batuta::detail
