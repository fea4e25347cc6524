// SPDX-License-Identifier: MIT
#pragma once
// Capsules on bodies that do not turn, as search_translation() wants them, and the boxes that they
// sweep. Nothing of rotation is linked.

#include "batuta/detection/moving_pair.hpp"
#include "batuta/geometry/kdop.hpp"
#include "batuta/mechanics/straight.hpp"

namespace batuta {

namespace detail {

/// As make_moving_pair(), for bodies that do not turn.
/// @param A_B, B_B  capsules relative to their body's point, axes of W
/// @returns kOk | kInvalidArgument: not finite, negative radius or duration, unequal durations, or
///   S beyond kLargestCoordinate
template <class Scalar>
Result<MovingPair<Scalar>> make_straight_pair(const Capsule<Scalar>& A_B,
                                              const StraightMotion<Scalar>& A,
                                              const Capsule<Scalar>& B_B,
                                              const StraightMotion<Scalar>& B);

/// The tightest box of a capsule over the duration of its motion, rounded outward so that it holds
/// every point of it at every instant (src/detection/straight_pair.md).
/// @param capsule_B  relative to the body's point, axes of W
/// @pre is_valid(capsule_B), is_valid(motion)
/// Bound: three axes.
template <class Scalar>
Aabb<Scalar> straight_aabb(const Capsule<Scalar>& capsule_B, const StraightMotion<Scalar>& motion);

}  // namespace detail

}  // namespace batuta
