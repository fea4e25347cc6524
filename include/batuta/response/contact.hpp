// SPDX-License-Identifier: MIT
#pragma once
// A contact of two bodies at one instant, and what kind it is [Kavan §4, eq. 21-23]. Frame W, SI
// units.

#include "batuta/detection/moving_pair.hpp"

namespace batuta {

/// Where two bodies meet. One point serves both bodies (midway between the surfaces), so that equal
/// and opposite impulses conserve angular momentum exactly.
template <class Scalar>
struct Contact {
  Vec3<Scalar> point_W = detail::zero<Scalar>();  ///< midway between the surfaces, m
  Vec3<Scalar> normal_BA_W =
      detail::unit_x<Scalar>();  ///< the paper's n_B: unit, out of B, towards A
  Scalar gap = 0;                ///< m, at this instant; may be slightly positive
};

/// What a contact does along its normal [Kavan §4]; eps_r is the speed up to which it rests.
enum class ContactKind : std::uint8_t {
  kColliding,  ///< v_rel < -eps_r
  kResting,    ///< |v_rel| <= eps_r
  kReceding,   ///< v_rel > eps_r
};

/// The contact that a search found, moved from its local origin to W.
template <class Scalar>
Contact<Scalar> contact_from(const CapsuleGap<Scalar>& witness, const Vec3<Scalar>& origin_W);

/// v_rel = n_B . (r'_A - r'_B) [Kavan eq. 21-23], m/s; negative: approaching.
template <class Scalar>
Scalar relative_velocity(const Contact<Scalar>& contact, const Pose<Scalar>& X_WA,
                         const Twist<Scalar>& twist_A, const Pose<Scalar>& X_WB,
                         const Twist<Scalar>& twist_B);

/// Which kind of contact a relative velocity makes. @pre eps_r >= 0, m/s
template <class Scalar>
ContactKind classify(Scalar v_rel, Scalar eps_r);

}  // namespace batuta
