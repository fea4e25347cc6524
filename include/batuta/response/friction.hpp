// SPDX-License-Identifier: MIT
#pragma once
// Colliding contact with dry friction: the paper's impulse [Kavan eq. 24-29] and beside it a
// tangential one, sticking or sliding, in closed form (the two-parameter law of Chatterjee and
// Ruina; src/response/friction.md). No iteration. Frame W, SI units.

#include "batuta/response/impulse.hpp"

namespace batuta {

/// What two surfaces do to each other in a blow.
template <class Scalar>
struct FrictionLaw {
  Scalar restitution = 0;  ///< C [Kavan eq. 25], in [0, 1]: n.v after = -C n.v before
  Scalar friction = 0;     ///< mu >= 0, finite: |tangential impulse| <= mu times the normal one
  Scalar tangential = 0;   ///< e_t in [-1, 1]: 0 stops the slip, 1 turns it round (a rubber ball)
};

/// The impulse of a blow with friction; `magnitude` is its part along n, `on_A` and `on_B` hold all
/// of it. At mu = 0 it is collision_impulse() to the last bit; the normal velocity after is the
/// same at every mu. Directions in which nothing gives way (a hinge, a fixed body) take no
/// tangential impulse. A moving body of infinite mass drags the other along, and does work.
/// @pre contact.normal_BA_W unit
/// @returns kOk (also where nothing can move or v_rel >= 0: magnitude 0, twists unchanged) |
///   kInvalidArgument (not finite, also in its result; a law out of range; negative inverse mass or
///   moment)
/// Bound: no loop; two square roots. Kinetic energy does not grow beyond rounding
/// (src/response/friction.md).
template <class Scalar>
Result<Impulse<Scalar>> friction_impulse(const Collider<Scalar>& A, const Collider<Scalar>& B,
                                         const Contact<Scalar>& contact,
                                         const FrictionLaw<Scalar>& law);

}  // namespace batuta
