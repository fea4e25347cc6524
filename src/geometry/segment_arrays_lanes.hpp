// SPDX-License-Identifier: MIT
#pragma once
// Arrays of segments, W pairs at a time; what is left, and what is hard, one at a time.

#include "batuta/geometry/segment_arrays.hpp"
#include "segment_lanes.hpp"

namespace batuta::lanes {

template <class L>
BATUTA_LANE Vector<L> load(const PointArrays<const typename L::Scalar>& from, std::size_t at) {
  return {load<L>(from.x + at), load<L>(from.y + at), load<L>(from.z + at)};
}
template <class L>
BATUTA_LANE void store(const Vector<L>& p, const PointArrays<typename L::Scalar>& to,
                       std::size_t at) {
  store(p.x, to.x + at);
  store(p.y, to.y + at);
  store(p.z, to.z + at);
}

template <class Scalar>
Vec3<Scalar> point_at(const PointArrays<const Scalar>& points, std::size_t at) {
  return {points.x[at], points.y[at], points.z[at]};
}
template <class Scalar>
void set_point(const PointArrays<Scalar>& points, std::size_t at, const Vec3<Scalar>& p) {
  points.x[at] = p.x();
  points.y[at] = p.y();
  points.z[at] = p.z();
}

/// Pair `at` by itself.
template <class Scalar>
[[gnu::noinline]] void closest_points_of_one(const SegmentArrays<Scalar>& A,
                                             const SegmentArrays<Scalar>& B, std::size_t at,
                                             const ClosestPointsArrays<Scalar>& result) {
  const ClosestPoints<Scalar> x = batuta::closest_points<Scalar>(
      {point_at(A.a, at), point_at(A.b, at)}, {point_at(B.a, at), point_at(B.b, at)});
  result.s[at] = x.s;
  result.u[at] = x.u;
  set_point(result.p_A, at, x.p_A);
  set_point(result.p_B, at, x.p_B);
  set_point(result.normal_AB, at, x.normal_AB);
  result.distance[at] = x.distance;
  result.arbitrary[at] = x.arbitrary;
}

/// Pairs `at` ... `at` + W - 1. Bound: W lanes.
template <int W, class Scalar>
void closest_points_of_lanes(const SegmentArrays<Scalar>& A, const SegmentArrays<Scalar>& B,
                             std::size_t at, const ClosestPointsArrays<Scalar>& result) {
  using L = Lanes<Scalar, W>;
  const Closest<L> x =
      closest_points<L>({load<L>(A.a, at), load<L>(A.b, at)}, {load<L>(B.a, at), load<L>(B.b, at)});
  store(x.s, result.s + at);
  store(x.u, result.u + at);
  store(x.p_A, result.p_A, at);
  store(x.p_B, result.p_B, at);
  store(x.normal_AB, result.normal_AB, at);
  store(x.distance, result.distance + at);
  std::memset(result.arbitrary + at, 0, W * sizeof(bool));
  if (!any(x.hard)) return;
  for (int lane = 0; lane < W; ++lane) {  // Bound: W lanes
    if (x.hard[lane]) closest_points_of_one(A, B, at + static_cast<std::size_t>(lane), result);
  }
}

/// closest_points() of arrays, W pairs at a time. Bound: count pairs.
template <int W, class Scalar>
void closest_points(const SegmentArrays<Scalar>& A, const SegmentArrays<Scalar>& B,
                    std::size_t count, const ClosestPointsArrays<Scalar>& result) {
  constexpr auto kWide = static_cast<std::size_t>(W);
  std::size_t at = 0;
  if constexpr (W > 1) {
    for (; at + kWide <= count; at += kWide) closest_points_of_lanes<W>(A, B, at, result);
  }
  for (; at < count; ++at) closest_points_of_one(A, B, at, result);
}

}  // namespace batuta::lanes
