// SPDX-License-Identifier: MIT
#pragma once
// Colliding contact of two bodies that do not turn [Kavan §4.1, eq. 24-28 without the terms of
// rotation].

#include "batuta/mechanics/straight.hpp"

namespace batuta {

namespace detail {

/// What a blow of two bodies that do not turn came to.
template <class Scalar>
struct StraightHit {
  Scalar v_rel = 0;    ///< before, along the normal, m/s; negative: approaching [Kavan eq. 23]
  Scalar impulse = 0;  ///< j >= 0, N s; 0 where nothing was changed
};

/// Turns v_rel into -C v_rel by equal and opposite impulses j n on A and -j n on B. Nothing changes
/// where the two recede or rest, neither can move, or an input is not finite; a fixed body never
/// changes.
/// @param normal_BA_W  unit, from B to A
/// @param restitution  C in [0, 1] [Kavan eq. 25]
/// Bound: no loop. Momentum is kept and kinetic energy does not grow, both to rounding.
template <class Scalar>
StraightHit<Scalar> straight_impulse(StraightBody<Scalar>& A, StraightBody<Scalar>& B,
                                     const Vec3<Scalar>& normal_BA_W, Scalar restitution);

}  // namespace detail

}  // namespace batuta
