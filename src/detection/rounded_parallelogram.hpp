// SPDX-License-Identifier: MIT
#pragma once
// When two segments that do not turn come as close as rho: the difference of the two is a
// parallelogram, and a point is cast against what lies within rho of it: two faces, four edges,
// four corners. A prediction, judged elsewhere; rounding may lose a hit between two features.
// Derivation: translation.md.

#include <array>

#include "batuta/geometry/segment.hpp"

namespace batuta {

/// Two segments at time 0; B moves by `travel` in the unit of time, A stands.
template <class Scalar>
struct Cast {
  Segment<Scalar> A;
  Segment<Scalar> B;
  Vec3<Scalar> travel;
  Scalar rho = 0;
};

/// No entry.
template <class Scalar>
inline constexpr Scalar kNever = std::numeric_limits<Scalar>::max();

/// First time >= 0 at which |x + travel t| falls to rho; kNever if it does not, or began below.
template <class Scalar>
Scalar enter_ball(const Vec3<Scalar>& x, const Vec3<Scalar>& travel, Scalar rho) {
  const Scalar approach = -x.dot(travel);
  const Scalar square = rho * rho * travel.squaredNorm() - x.cross(travel).squaredNorm();
  if (!(approach > Scalar(0)) || !(square >= Scalar(0))) return kNever<Scalar>;
  const Scalar distance = std::sqrt(x.squaredNorm());
  const Scalar outside = (distance - rho) * (distance + rho);
  return outside > Scalar(0) ? outside / (approach + std::sqrt(square)) : kNever<Scalar>;
}

namespace detail {

/// An edge of the parallelogram, and the travel across it.
template <class Scalar>
struct Side {
  Vec3<Scalar> d;
  Scalar inverse_square = 0;  ///< 1 / |d|^2; 0: a point
  Vec3<Scalar> travel;

  Side(const Vec3<Scalar>& edge, const Vec3<Scalar>& whole_travel) : d(edge) {
    const Scalar square = d.squaredNorm();
    if (square > std::numeric_limits<Scalar>::min()) inverse_square = 1 / square;
    travel = across(whole_travel);
  }
  Vec3<Scalar> across(const Vec3<Scalar>& x) const { return x - d * (x.dot(d) * inverse_square); }
};

}  // namespace detail

/// The same against the tube about the side from 0 to d.
template <class Scalar>
Scalar enter_tube(const Vec3<Scalar>& x, const Vec3<Scalar>& travel,
                  const detail::Side<Scalar>& side, Scalar rho) {
  if (!(side.inverse_square > Scalar(0))) return kNever<Scalar>;
  const Scalar t = enter_ball<Scalar>(side.across(x), side.travel, rho);
  if (!(t < kNever<Scalar>)) return kNever<Scalar>;
  const Scalar place = (x + travel * t).dot(side.d) * side.inverse_square;
  return place >= Scalar(0) && place <= Scalar(1) ? t : kNever<Scalar>;
}

/// The same against the two faces.
template <class Scalar>
Scalar enter_face(const Cast<Scalar>& cast) {
  const Vec3<Scalar> a = cast.A.direction();
  const Vec3<Scalar> b = cast.B.direction();
  const Vec3<Scalar> cross = a.cross(b);
  const Scalar square = cross.squaredNorm();
  if (!(square > std::numeric_limits<Scalar>::min())) return kNever<Scalar>;
  const Vec3<Scalar> x = cast.B.a - cast.A.a;
  const Scalar side = x.dot(cross) < Scalar(0) ? Scalar(-1) : Scalar(1);
  const Vec3<Scalar> n = cross * (side / std::sqrt(square));
  const Scalar above = n.dot(x) - cast.rho;
  const Scalar approach = -n.dot(cast.travel);
  if (!(above > Scalar(0)) || !(approach > Scalar(0))) return kNever<Scalar>;
  const Scalar t = above / approach;
  const Vec3<Scalar> at = x + cast.travel * t;
  const Scalar s = at.cross(b).dot(cross);
  const Scalar u = at.cross(a).dot(cross);
  const bool inside = s >= Scalar(0) && s <= square && u >= Scalar(0) && u <= square;
  return inside ? t : kNever<Scalar>;
}

/// First time at which the segments come as close as rho; kNever if they do not, or were.
/// Bound: four corners, four edges, one face.
template <class Scalar>
Scalar first_entry(const Cast<Scalar>& cast) {
  const Vec3<Scalar> a = cast.A.direction();
  const Vec3<Scalar> b = cast.B.direction();
  const bool balls = a == Vec3<Scalar>::Zero() && b == Vec3<Scalar>::Zero();
  Scalar first = enter_ball<Scalar>(cast.B.a - cast.A.a, cast.travel, cast.rho);
  if (balls) return first;
  const detail::Side<Scalar> along_A(a, cast.travel);
  const detail::Side<Scalar> along_B(b, -cast.travel);
  const std::array<Vec3<Scalar>, 2> p = {cast.A.a, cast.A.b};
  const std::array<Vec3<Scalar>, 2> q = {cast.B.a, cast.B.b};
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends of each
    first = min_of(first, enter_tube<Scalar>(q[i] - p[0], cast.travel, along_A, cast.rho));
    first = min_of(first, enter_tube<Scalar>(p[i] - q[0], -cast.travel, along_B, cast.rho));
    for (std::size_t k = 0; k < 2; ++k) {  // Bound: two ends of each
      if (i + k > 0) {
        first = min_of(first, enter_ball<Scalar>(q[k] - p[i], cast.travel, cast.rho));
      }
    }
  }
  return min_of(first, enter_face(cast));
}

}  // namespace batuta
