// SPDX-License-Identifier: MIT
#pragma once
// No point of a moving capsule is faster than this [Kavan §3.1, lemma and corollary].

#include "batuta/detection/moving_pair.hpp"

namespace batuta {

/// |v| + max over the ends of |w x r| + |w| radius, m/s: an upper bound of the speed of every point
/// of the capsule, at every time, rounded up. The paper's corollary holds for vertices; the radius
/// turns with the body and adds |w| r. Bound: two ends.
template <class Scalar>
Scalar speed_bound(const MovingCapsule<Scalar>& moving);

/// Upper bound of |d gap / dt| of a pair, m/s: |v_B - v_A| plus both turning terms of the *axes*;
/// the radius does not change the gap, and a common velocity does not either. Never above
/// speed_bound(A) + speed_bound(B).
template <class Scalar>
Scalar closing_speed_bound(const MovingPair<Scalar>& pair);

}  // namespace batuta
