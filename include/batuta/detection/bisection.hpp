// SPDX-License-Identifier: MIT
#pragma once
// Time of contact between a free and a colliding instant by a fixed number of halvings [Kavan
// §3.3].

#include "batuta/detection/moving_pair.hpp"

namespace batuta {

namespace detail {

/// Halvings after which the bracket of any float step is at the rounding of time itself.
inline constexpr int kMaxHalvings = 64;

/// Two instants with the first contact between them.
template <class Scalar>
struct Bracket {
  Scalar t_free = 0;              ///< collision-free
  Scalar t_hit = 0;               ///< in collision
  CapsuleGap<Scalar> witness;     ///< at t_free
  std::uint32_t evaluations = 0;  ///< distance evaluations used
  bool valid = true;  ///< false: a gap could not be told (Proximity::kInvalid), the search stopped
};

/// Invariant [Kavan §3.3]: the gap is > 0 at t_free and <= 0 at t_hit.
/// @pre gap > 0 at start.t_free, with start.witness taken there; gap <= 0 at start.t_hit;
/// 0 <= halvings <= kMaxHalvings
/// @returns a bracket of the start width / 2^halvings, or neighbouring numbers; where a gap cannot
/// be told, the last bracket before it, and not valid
/// Bound: `halvings` evaluations.
template <class Scalar>
Bracket<Scalar> bisect(const MovingPair<Scalar>& pair, const Bracket<Scalar>& start, int halvings);

}  // namespace detail

}  // namespace batuta
