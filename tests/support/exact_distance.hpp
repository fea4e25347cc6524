// SPDX-License-Identifier: MIT
#pragma once
// Truth about two segments, for tests: everything in long double from the exact inputs, and by
// means that share nothing with the library.

#include <algorithm>
#include <array>
#include <cmath>

#include "batuta/geometry/segment.hpp"

namespace batuta::exact {

using Real = long double;
using Point = std::array<Real, 3>;

template <class Scalar>
Point point(const Vec3<Scalar>& p) {
  return {Real(p.x()), Real(p.y()), Real(p.z())};
}
inline Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Real dot(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline Real norm(const Point& p) {
  return std::sqrt(dot(p, p));
}

/// The distance of the points at parameters s and u. Differences come first: they are exact.
template <class Scalar>
Real distance_at(const Segment<Scalar>& A, const Segment<Scalar>& B, Real s, Real u) {
  const Point r = minus(point(B.a), point(A.a));
  const Point d_A = minus(point(A.b), point(A.a));
  const Point d_B = minus(point(B.b), point(B.a));
  Point gap{};
  for (std::size_t i = 0; i < 3; ++i) gap[i] = r[i] + u * d_B[i] - s * d_A[i];
  return norm(gap);
}

/// S of the error bounds: the largest of |A|, |B|, |B.a - A.a|, |B.b - A.b|.
template <class Scalar>
Real visible_length(const Segment<Scalar>& A, const Segment<Scalar>& B) {
  return std::max({norm(minus(point(A.b), point(A.a))), norm(minus(point(B.b), point(B.a))),
                   norm(minus(point(B.a), point(A.a))), norm(minus(point(B.b), point(A.b)))});
}

/// The least distance by search: for a fixed point of A the nearest of B is a clamped projection,
/// and that distance is a convex function of the point of A, so thirds that cannot hold the minimum
/// are dropped.
template <class Scalar>
Real least_distance(const Segment<Scalar>& A, const Segment<Scalar>& B) {
  const Point r = minus(point(A.a), point(B.a));
  const Point d_A = minus(point(A.b), point(A.a));
  const Point d_B = minus(point(B.b), point(B.a));
  const Real BB = dot(d_B, d_B);
  const auto distance_from = [&](Real s) {
    const Point w = {r[0] + s * d_A[0], r[1] + s * d_A[1], r[2] + s * d_A[2]};
    const Real u = BB == 0 ? Real(0) : std::clamp(dot(w, d_B) / BB, Real(0), Real(1));
    return norm({w[0] - u * d_B[0], w[1] - u * d_B[1], w[2] - u * d_B[2]});
  };
  Real low = 0;
  Real high = 1;
  for (int i = 0; i < 200; ++i) {  // Bound: (2/3)^200 is far below the rounding error
    const Real left = low + (high - low) / 3;
    const Real right = high - (high - low) / 3;
    (distance_from(left) <= distance_from(right) ? high : low) =
        distance_from(left) <= distance_from(right) ? right : left;
  }
  return std::min({distance_from(low), distance_from(0), distance_from(1)});
}

}  // namespace batuta::exact
