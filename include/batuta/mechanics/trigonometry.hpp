// SPDX-License-Identifier: MIT
#pragma once
// Sine, cosine and arc tangent from + - x / and sqrt alone: the same bits on every machine, and no
// libm in the core. Polynomials, range reduction and the error bounds:
// src/mechanics/trigonometry.md.

#include "batuta/core/types.hpp"

namespace batuta {

namespace detail {

/// Largest |angle| that sin_cos() reduces with its stated error, rad: 1608 quarter turns, about 402
/// full turns.
template <class Scalar>
inline constexpr Scalar kMaxAngle = Scalar(2526);

/// Sine and cosine of one angle.
template <class Scalar>
struct SinCos {
  Scalar sin = 0;  ///< of the angle
  Scalar cos = 1;  ///< of the same angle
};

/// Sine and cosine. Error <= 1.5 ulp of the result for |angle| <= kMaxAngle (measured: 0.98), exact
/// at 0.
/// @pre |angle| <= kMaxAngle, rad; what a caller's rounding adds to it does no harm
/// Bound: one polynomial each, at most 6 terms.
template <class Scalar>
SinCos<Scalar> sin_cos(Scalar angle);

/// The angle of (x, y) in [-pi, pi]; 0 for x = y = 0; the sign of a zero does not count. Error <= 2
/// ulp (measured: 1.54).
/// @pre finite
/// Bound: one polynomial, at most 12 terms.
template <class Scalar>
Scalar arc_tangent(Scalar y, Scalar x);

}  // namespace detail

}  // namespace batuta
