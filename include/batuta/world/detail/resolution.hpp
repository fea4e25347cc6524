// SPDX-License-Identifier: MIT
#pragma once
// What one contact does to its two bodies: which kind it is, and what the paper asks for that kind
// [Kavan §4].

#include "batuta/response/impulse.hpp"
#include "batuta/response/separation.hpp"

namespace batuta::detail {

/// One side of a contact.
template <class Scalar>
struct ContactSide {
  Body<Scalar>* body = nullptr;  ///< changed by the resolution; never null
  Twist<Scalar> twist;           ///< of its matter, at the contact
  Scalar room = 0;               ///< how far it may be shifted without reaching a neighbour, m
};

/// What an impulse needs to know of a side.
template <class Scalar>
Collider<Scalar> collider_of(const ContactSide<Scalar>& side);

/// How contacts are resolved.
template <class Scalar>
struct ResolutionOptions {
  Scalar rest_speed = 0;           ///< eps_r, m/s, > 0
  Scalar separation = 0;           ///< D, m, > 0
  Scalar min_separation_time = 0;  ///< least f(D), s, > 0
  /// Gap below which the next search might call parting bodies touching, m, > 0: by its contact
  /// tolerance or by rounding (src/world/detail/resolution.md).
  Scalar margin = 0;
  bool settles = false;  ///< resting contacts that approach get the impulse as well
};

template <class Scalar>
struct Resolution {
  ContactKind kind = ContactKind::kResting;
  Scalar v_rel = 0;               ///< before, m/s
  Scalar impulse = 0;             ///< j, N s
  bool separated = false;         ///< to D, and time is charged for it
  Separation<Scalar> separation;  ///< shifts done; duration 0 if not separated
};

/// Colliding (or resting, where that settles): both momenta get the impulse [Kavan §4.1]. Resting:
/// both positions are separated to D [Kavan §4.2]. Receding: nothing. Overlapping by more than
/// `margin`, of whatever kind: separated as well. Otherwise the gap is opened to `margin` at no
/// charge, so that the next search does not take parting bodies for touching ones.
/// @param impulse  of the pair's law at this contact: collision_impulse() or friction_impulse()
/// @returns kOk | kInvalidArgument (options or contact out of range, no impulse); then the bodies
///   are unchanged
/// Bound: no loop.
template <class Scalar>
Result<Resolution<Scalar>> resolve_contact(const ContactSide<Scalar>& A,
                                           const ContactSide<Scalar>& B,
                                           const Contact<Scalar>& contact,
                                           const Result<Impulse<Scalar>>& impulse,
                                           const ResolutionOptions<Scalar>& options);

}  // namespace batuta::detail
