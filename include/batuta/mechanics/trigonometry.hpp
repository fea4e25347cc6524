// SPDX-License-Identifier: MIT
#pragma once
// Sine, cosine and arc tangent from + - x / and sqrt alone: the same bits on every machine, and no libm in the core.
// Polynomials, range reduction and the error bounds: src/mechanics/trigonometry.md.

#include "batuta/core/types.hpp"

namespace batuta {

/// Largest |angle| that sin_cos() reduces with its stated error, rad: 1608 quarter turns, about 402 full turns.
template <class Scalar>
inline constexpr Scalar kMaxAngle = Scalar(2526);

template <class Scalar>
struct SinCos {
  Scalar sin = 0;
  Scalar cos = 1;
};

/// Sine and cosine. Error <= 1.5 ulp of the result for |angle| <= kMaxAngle, exact at 0.
/// @pre |angle| <= kMaxAngle, rad
/// Bound: no loop.
template <class Scalar>
SinCos<Scalar> sin_cos(Scalar angle);

/// The angle of (x, y) in [-pi, pi]; 0 for x = y = 0. Error <= 2 ulp.
/// @pre finite
/// Bound: no loop.
template <class Scalar>
Scalar arc_tangent(Scalar y, Scalar x);

}  // namespace batuta
