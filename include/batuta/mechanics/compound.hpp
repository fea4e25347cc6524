// SPDX-License-Identifier: MIT
#pragma once
// A body of several capsules: blade, guard and pommel, or a bent limb. It is modelled in one frame
// S; its own frame B (mass.hpp) and where that lies follow from the masses. SI units.

#include <cstddef>

#include "batuta/core/fixed_list.hpp"
#include "batuta/mechanics/body.hpp"

namespace batuta {

/// A part of a compound, in the frame S in which that is modelled.
template <class Scalar>
struct CapsulePart {
  Capsule<Scalar> capsule_S;  ///< m
  Scalar density = 0;         ///< kg/m^3, > 0
};

/// A body and the capsules that move with it.
template <class Scalar, int N>
struct Compound {
  Body<Scalar> body;                         ///< at rest, its frame the settled_frame()
  FixedList<Capsule<Scalar>, N> capsules_B;  ///< in the order of the parts
};

namespace detail {

/// Mass, centre and inertia of the parts together. Where parts overlap, what they share counts once
/// for each of them: let the core of one end at the surface of the other if that matters.
/// @returns kOk | kInvalidArgument (no part, a part that solid_capsule() refuses, or sums that are
/// beyond the numbers)
/// Bound: count parts.
template <class Scalar>
Result<MassProperties<Scalar>> mass_of_parts(const CapsulePart<Scalar>* parts, int count);

/// The principal axes where rounding must not choose them: moments equal to within rounding are
/// made equal, and axes that are free then are settled by rule (src/mechanics/compound.md).
/// Otherwise principal_frame().
template <class Scalar>
PrincipalFrame<Scalar> settled_frame(const MassProperties<Scalar>& mass);

/// A body at rest with the given mass properties in its settled_frame(), its frame S at X_WS; the
/// capsules are moved from S to B in place. @pre X_WS.q_WB (here: S into W) is unit
/// @returns kOk | kInvalidArgument (count < 1, a capsule that is not valid, mass or a moment that
/// is not positive and finite, an inertia that is not symmetric or that no body has, pose not
/// finite); then the capsules may be changed
/// Bound: count capsules.
template <class Scalar>
Result<Body<Scalar>> place_compound(const MassProperties<Scalar>& mass, const Pose<Scalar>& X_WS,
                                    Capsule<Scalar>* capsules, int count);

}  // namespace detail

/// Capsules whose masses are known otherwise: from a mesh (batuta-mass) or from a balance.
/// @returns as place_compound(); also kInvalidArgument where count > N. Bound: N capsules.
template <int N, class Scalar>
Result<Compound<Scalar, N>> make_compound(const MassProperties<Scalar>& mass,
                                          const Capsule<Scalar>* capsules_S, int count,
                                          const Pose<Scalar>& X_WS) {
  Result<Compound<Scalar, N>> made;
  if (count < 1 || count > N) return made;
  auto& list = made.value.capsules_B;
  for (int i = 0; i < count; ++i) (void)list.push(capsules_S[i]);  // Bound: N
  const auto placed = detail::place_compound(mass, X_WS, &list[0], count);
  if (!placed.ok()) return failure<Compound<Scalar, N>>(placed.status);
  made.status = Status::kOk;
  made.value.body = placed.value;
  return made;
}

/// A body whose mass is that of its parts.
/// @returns as mass_of_parts() and place_compound(); also kInvalidArgument where count > N.
/// Bound: N parts.
template <int N, class Scalar>
Result<Compound<Scalar, N>> make_compound(const CapsulePart<Scalar>* parts, int count,
                                          const Pose<Scalar>& X_WS) {
  if (count > N) return failure<Compound<Scalar, N>>(Status::kInvalidArgument);
  const auto mass = detail::mass_of_parts(parts, count);
  if (!mass.ok()) return failure<Compound<Scalar, N>>(mass.status);
  FixedList<Capsule<Scalar>, N> capsules_S;
  for (int i = 0; i < count; ++i) (void)capsules_S.push(parts[i].capsule_S);  // Bound: N
  return make_compound<N>(mass.value, capsules_S.begin(), count, X_WS);
}

/// The same for a list that is written down: make_compound<float>({{blade, 7850}, ...}, X_WS).
template <class Scalar, std::size_t N>
Result<Compound<Scalar, static_cast<int>(N)>> make_compound(const CapsulePart<Scalar> (&parts)[N],
                                                            const Pose<Scalar>& X_WS) {
  return make_compound<static_cast<int>(N)>(&parts[0], static_cast<int>(N), X_WS);
}
/// The same for capsules whose mass is known otherwise, in a list that is written down.
template <class Scalar, std::size_t N>
Result<Compound<Scalar, static_cast<int>(N)>> make_compound(const MassProperties<Scalar>& mass,
                                                            const Capsule<Scalar> (&capsules_S)[N],
                                                            const Pose<Scalar>& X_WS) {
  return make_compound<static_cast<int>(N)>(mass, &capsules_S[0], static_cast<int>(N), X_WS);
}

}  // namespace batuta
