// SPDX-License-Identifier: MIT
#pragma once
// Closest points of a point and a segment, and of two segments: the one kernel that all detection
// stands on. Frame: any, the same for all arguments; unit m. Recipe and error bound:
// src/geometry/segment.md.

#include "batuta/core/types.hpp"

namespace batuta {

/// The points a + s (b - a), s in [0, 1]. a == b is a point, and ordinary input.
template <class Scalar>
struct Segment {
  Vec3<Scalar> a = detail::zero<Scalar>();  ///< m
  Vec3<Scalar> b = detail::zero<Scalar>();  ///< m

  /// b - a, m; of any length.
  Vec3<Scalar> direction() const { return b - a; }
  /// Measured from the nearer end, so that at(0) is a and at(1) is b, exactly.
  Vec3<Scalar> at(Scalar s) const {
    const bool nearer_b = s > Scalar(0.5);
    const Vec3<Scalar>* const end = nearer_b ? &b : &a;
    return *end + (nearer_b ? s - 1 : s) * (b - a);
  }
};

/// A point of a segment that is closest to a given point.
template <class Scalar>
struct PointOnSegment {
  Scalar s = 0;                                 ///< parameter in [0, 1]
  Vec3<Scalar> point = detail::zero<Scalar>();  ///< m
  Scalar distance = 0;                          ///< to the given point, m
};

/// A closest pair of points of segments A and B.
template <class Scalar>
struct ClosestPoints {
  Scalar s = 0;                               ///< parameter on A in [0, 1]
  Scalar u = 0;                               ///< parameter on B in [0, 1]
  Vec3<Scalar> p_A = detail::zero<Scalar>();  ///< point of A, m
  Vec3<Scalar> p_B = detail::zero<Scalar>();  ///< point of B, m
  /// Unit, from p_A to p_B. Where the points coincide (to 4 u of the root of |d_A|^2 + |d_B|^2 +
  /// |r|^2, r between two ends): perpendicular to both segments if they are not parallel, else a
  /// fixed perpendicular of the longer one, else (two points) the x axis; then `arbitrary` is set.
  Vec3<Scalar> normal_AB = detail::unit_x<Scalar>();
  Scalar distance = 0;  ///< of the two points, m, >= 0
  /// The sign or the whole direction of normal_AB is a convention, not geometry.
  bool arbitrary = false;
};

/// Coordinates up to here keep every difference and distance finite.
template <class Scalar>
inline constexpr Scalar kLargestCoordinate = std::numeric_limits<Scalar>::max() / 8;

/// The point of `segment` closest to `point`. Swapping the ends gives the same point and distance,
/// bit for bit.
/// @pre no coordinate is NaN or beyond kLargestCoordinate; any scale
/// Bound: no loop but the choice of a scale. Error of the distance <= 5 u S, S the largest length
/// in the query.
template <class Scalar>
PointOnSegment<Scalar> closest_point(const Segment<Scalar>& segment, const Vec3<Scalar>& point);

/// A closest pair of points of A and B [Kavan §5, the distance in eq. 31].
/// Where a whole range of pairs is closest (parallel, side by side; within u S counts): the middle
/// of the range. Swapping A and B, or the ends of either, gives the same points, distance and
/// normal (turned round with A and B) bit for bit; a parameter s becomes 1 - s up to u (0 on a
/// point). Identical segments have one arbitrary normal either way.
/// @pre no coordinate is NaN or beyond kLargestCoordinate; any scale; zero length allowed
/// Bound: no loop but the choice of a scale. Excess of the distance over the minimum <= 4 u S,
/// error of `distance` <= 5 u S, S the largest length in the query (src/geometry/segment.md). p_A
/// and p_B are rounded where they lie. Points and parallel segments divide by zero on the way:
/// leave the traps of the FPU off.
template <class Scalar>
ClosestPoints<Scalar> closest_points(const Segment<Scalar>& A, const Segment<Scalar>& B);

}  // namespace batuta
