// SPDX-License-Identifier: MIT
#pragma once
// Resting contact: push the bodies apart along the normal until the gap is D, and charge time for
// it [Kavan §4.2].

#include "batuta/response/contact.hpp"

namespace batuta {

/// How far a resting contact is moved apart, and for how long.
template <class Scalar>
struct SeparationOptions {
  Scalar distance = 0;      ///< D, m, > 0: the gap after separation
  Scalar rest_speed = 0;    ///< eps_r, m/s, > 0: the largest |v_rel| that still counts as resting
  Scalar min_duration = 0;  ///< s, > 0: f(D) is never less, so separations per step are bounded
  /// Longest shift that each body may make without reaching a neighbour, m, >= 0.
  Scalar limit_A = std::numeric_limits<Scalar>::max();
  Scalar limit_B = std::numeric_limits<Scalar>::max();  ///< of B, as limit_A
};

/// The paper's separation by D, made safe: the gap is restored *to* D, because adding D each time
/// would lift a resting body step by step (src/response/separation.md).
template <class Scalar>
struct Separation {
  Vec3<Scalar> shift_A_W = detail::zero<Scalar>();  ///< m, along +n_B, share m_B / (m_A + m_B)
  Vec3<Scalar> shift_B_W = detail::zero<Scalar>();  ///< m, along -n_B
  Scalar duration = 0;                              ///< f(D), s
};

/// Shares by inverse masses, which is the paper's rule and also serves a fixed body (share 0); both
/// fixed: no shift. Where a limit cuts one share short, the other one is cut by as much, and the
/// common centre of mass stays. f(D) = max(min_duration, D / (2 max(|v_rel|, rest_speed))): the
/// time in which a resting contact uses up half of D. A gap that is already D or more: no shift.
/// @returns kOk | kInvalidArgument (an option out of range; normal, gap or v_rel not finite, or
/// shifts or f(D) beyond the numbers; negative inverse mass). Bound: no loop.
template <class Scalar>
Result<Separation<Scalar>> separate(const Contact<Scalar>& contact, Scalar v_rel,
                                    Scalar inverse_mass_A, Scalar inverse_mass_B,
                                    const SeparationOptions<Scalar>& options);

}  // namespace batuta
