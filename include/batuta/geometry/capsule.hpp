// SPDX-License-Identifier: MIT
#pragma once
// The one shape of batuta: all points within a radius of a segment [Kavan eq. 30]. A sphere is the
// capsule whose segment has no length. Frame: any, the same for all arguments; unit m.

#include "batuta/core/status.hpp"
#include "batuta/geometry/segment.hpp"

namespace batuta {

/// All points within `radius` of a segment.
template <class Scalar>
struct Capsule {
  Segment<Scalar> axis;  ///< may be a point: a sphere
  Scalar radius = 0;     ///< >= 0

  /// A capsule whose segment has no length.
  static Capsule sphere(const Vec3<Scalar>& center, Scalar radius) {
    return {{center, center}, radius};
  }
};

/// A ball.
template <class Scalar>
struct Sphere {
  Vec3<Scalar> center = detail::zero<Scalar>();  ///< m
  Scalar radius = 0;                             ///< m, >= 0
};

/// How two capsules stand to each other; "I cannot tell" does not occur for finite input.
enum class Proximity : std::uint8_t {
  kSeparated,    ///< gap > 0
  kTouching,     ///< gap == 0
  kOverlapping,  ///< gap < 0
  kInvalid,      ///< is_valid() is false for one of the two
};

/// How far two capsules are apart, and where.
template <class Scalar>
struct CapsuleGap {
  Proximity proximity = Proximity::kInvalid;  ///< the sign of the gap, or that there is none
  Scalar gap = 0;  ///< distance of the surfaces, m; negative: depth of the overlap along normal_AB
  ClosestPoints<Scalar> axes;  ///< closest points of the two axes, with normal_AB
  Vec3<Scalar> surface_A = detail::zero<Scalar>();  ///< point of A's surface furthest towards B
  Vec3<Scalar> surface_B = detail::zero<Scalar>();  ///< point of B's surface furthest towards A
};

/// Finite coordinates and a finite radius >= 0, none beyond kLargestCoordinate.
template <class Scalar>
bool is_valid(const Capsule<Scalar>& capsule);

/// Whether numbers are dense enough around a place for something of that size: the size is not lost
/// when it is added. Beyond that the ends would fall together with the place, and what is there
/// could neither be beside another one nor move. A point is a point anywhere.
/// @param size  m, >= 0
template <class Scalar>
bool can_hold(const Vec3<Scalar>& place, Scalar size) {
  bool holds = true;
  for (int i = 0; i < 3; ++i) {  // Bound: 3; by component: expressions double the code
    if (place[i] + size == place[i]) holds = size == Scalar(0);
  }
  return holds;
}

/// The same for a capsule that is carried there: for its furthest point.
/// @param capsule_B  relative to the place, valid
template <class Scalar>
bool can_hold(const Vec3<Scalar>& place, const Capsule<Scalar>& capsule_B);

/// Signed distance of two capsules with the witnesses [Kavan eq. 31].
/// @returns proximity kInvalid for invalid input, never anything else for it
/// Bound: one closest_points(). Full depth is reported also where the axes cross.
template <class Scalar>
CapsuleGap<Scalar> capsule_gap(const Capsule<Scalar>& A, const Capsule<Scalar>& B);

/// The same from the closest points of the axes. @pre finite, radii >= 0. Bound: no loop.
template <class Scalar>
CapsuleGap<Scalar> capsule_gap(const ClosestPoints<Scalar>& axes, Scalar radius_A, Scalar radius_B);

/// dist(axis A, axis B) <= r_A + r_B [Kavan eq. 31]. False for invalid input (ask is_valid()
/// first).
template <class Scalar>
bool overlaps(const Capsule<Scalar>& A, const Capsule<Scalar>& B);

/// max(0, -gap), m: how far to move A along -normal_AB until the surfaces touch.
template <class Scalar>
Scalar penetration_depth(const Capsule<Scalar>& A, const Capsule<Scalar>& B);

/// Outward unit normal at the point of the surface nearest to `point` [Kavan §5]. On the axis: a
/// fixed perpendicular of the axis (x for a sphere), status kDegenerate. kInvalidArgument for an
/// invalid capsule or point.
template <class Scalar>
Result<Vec3<Scalar>> surface_normal(const Capsule<Scalar>& capsule, const Vec3<Scalar>& point);

/// max over the capsule of direction . x; `direction` need not be unit, and may be zero.
template <class Scalar>
Scalar support(const Capsule<Scalar>& capsule, const Vec3<Scalar>& direction);

/// The smallest ball that holds the capsule, rounded outward so that it holds every point of it,
/// but for what is lost of coordinates below the normal numbers (1e-38 m in float).
template <class Scalar>
Sphere<Scalar> bounding_sphere(const Capsule<Scalar>& capsule);

}  // namespace batuta
