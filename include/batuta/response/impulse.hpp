// SPDX-License-Identifier: MIT
#pragma once
// Colliding contact: the impulse along the normal that turns v_rel into -C v_rel [Kavan §4.1, eq.
// 24-29].

#include "batuta/response/contact.hpp"

namespace batuta {

/// What the impulse needs to know of one body. The twist is given apart from the body's momenta
/// because a body that a hand moves has a velocity although nothing can push it (inverse mass 0).
template <class Scalar>
struct Collider {
  Pose<Scalar> X_WB;        ///< where the body's frame B is
  Twist<Scalar> twist;      ///< how it moves before the blow, W
  Scalar inverse_mass = 0;  ///< 1/kg, >= 0; 0: nothing can push it
  /// 1/(kg m^2), >= 0, along the axes of B; 0: nothing can turn it
  Vec3<Scalar> inverse_moments = detail::zero<Scalar>();
};

/// What the impulse needs to know of a body that moves by its momenta.
template <class Scalar>
Collider<Scalar> collider_of(const Body<Scalar>& body);

/// What a blow does to the two bodies.
template <class Scalar>
struct Impulse {
  Scalar magnitude = 0;   ///< j >= 0, N s [Kavan eq. 24]
  Scalar v_rel = 0;       ///< before, m/s [Kavan eq. 23]
  Momentum<Scalar> on_A;  ///< J and r_A x J; B gets exactly the opposite J at the same point
  Momentum<Scalar> on_B;  ///< of B, about its own centre of mass
  Twist<Scalar> twist_A;  ///< after [Kavan eq. 26, 27]
  Twist<Scalar> twist_B;  ///< after, as twist_A
};

/// The impulse of a blow without friction [Kavan eq. 24-27].
/// @pre contact.normal_BA_W unit; restitution C in [0, 1] [Kavan eq. 25]
/// @returns kOk (also where nothing can move or v_rel >= 0: magnitude 0, twists unchanged) |
///   kInvalidArgument (not finite, also in its result; C outside [0, 1]; negative inverse mass or
///   moment)
/// Bound: no loop. Kinetic energy does not grow beyond rounding (src/response/impulse.md).
template <class Scalar>
Result<Impulse<Scalar>> collision_impulse(const Collider<Scalar>& A, const Collider<Scalar>& B,
                                          const Contact<Scalar>& contact, Scalar restitution);

}  // namespace batuta
