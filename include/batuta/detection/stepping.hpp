// SPDX-License-Identifier: MIT
#pragma once
// The paper's search [Kavan §3.2, eq. 16-18]: steps so small that a missed touch is shallower than
// epsilon, then bisection. Easy to trust; the reference for every other search.

#include "batuta/detection/bisection.hpp"
#include "batuta/detection/moving_pair.hpp"

namespace batuta {

/// What epsilon is measured in.
enum class EpsilonIn : std::uint8_t {
  kThinnerRadius,  ///< times the smaller of the two radii
  kMetres,         ///< epsilon is a length, m
};

/// How finely search_stepping() looks.
template <class Scalar>
struct SteppingOptions {
  Scalar epsilon = Scalar(0.5);                ///< deepest touch that may be missed, > 0
  EpsilonIn unit = EpsilonIn::kThinnerRadius;  ///< what `epsilon` is given in
  std::uint32_t max_steps = 4096;  ///< >= 1; where they do not suffice the answer is kBudget
  int halvings = 24;               ///< 0 ... kMaxHalvings
};

/// @returns kOk | kInvalidArgument: an option out of the range stated beside it
template <class Scalar>
Status validate(const SteppingOptions<Scalar>& options);

/// First contact in [0, duration], up to touches shallower than epsilon: n = ceil(duration V /
/// epsilon) equal steps [Kavan eq. 17], V = closing_speed_bound(), then bisection. Contact means
/// gap <= 0.
/// @returns SearchResult:
///   kFree: no overlap deeper than epsilon / 2 (src/detection/stepping.md);
///   kContact: t_hit - t_free <= step / 2^halvings, or neighbouring numbers;
///   kTouching: gap <= 0 at t = 0;
///   kBudget: n > max_steps, and no contact at the end of any of the first max_steps steps; t_free
///     is the last of these;
///   kInvalid: options out of range, an epsilon of 0 (relative to a thinner radius of 0: give it in
///     metres), or a distance that cannot be told (Proximity::kInvalid).
///   `t_free` is always an instant at which the gap was evaluated and positive, or 0; for kFree it
///   is duration.
/// Bound: max_steps + halvings + 1 evaluations; one if nothing moves.
template <class Scalar>
SearchResult<Scalar> search_stepping(const MovingPair<Scalar>& pair,
                                     const SteppingOptions<Scalar>& options);

}  // namespace batuta
