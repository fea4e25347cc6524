// SPDX-License-Identifier: MIT
#pragma once
// The length of a vector at any scale: squares neither overflow nor vanish. For set-up, not for
// inner loops.

#include "batuta/core/types.hpp"

namespace batuta {

/// |v|, relative error <= 5 u; infinite only if |v| is.
template <class Scalar>
Scalar length(const Vec3<Scalar>& v) {
  const Scalar largest = v.cwiseAbs().maxCoeff();
  if (!(largest > Scalar(0)) || !is_finite(largest)) return largest;
  return largest * (v / largest).norm();
}

/// What a sum of a few such lengths is multiplied with to be an upper bound: more than the 5 u of
/// each, 2 u of a product and 1 u of each of at most eight additions.
template <class Scalar>
inline constexpr Scalar kRoundUp = 1 + 16 * kRoundOff<Scalar>;

}  // namespace batuta
