// SPDX-License-Identifier: MIT
#pragma once
// Time of contact where nothing turns, for scenes that say so: the instant is predicted in closed
// form (a point cast against a rounded parallelogram; against a ball where both capsules are
// spheres) and judged by one certificate. Derivation: src/detection/translation.md.

#include "batuta/detection/advancement.hpp"

namespace batuta {

/// As search_advancement(), for pairs that do not turn.
/// @returns as search_advancement(); kInvalid also where a capsule turns
/// Bound: options.budget evaluations; two where the closed form is not at the mercy of rounding.
template <class Scalar>
SearchResult<Scalar> search_translation(const MovingPair<Scalar>& pair,
                                        const AdvancementOptions<Scalar>& options);

}  // namespace batuta
