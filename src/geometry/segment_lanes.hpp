// SPDX-License-Identifier: MIT
#pragma once
// The kernel of segment.cpp, a pair in each lane: the same operations in the same order, with a
// choice where that one branches. Why the bits are equal: segment_arrays.md.

#include "batuta/geometry/segment.hpp"
#include "lanes.hpp"
#include "scale_window.hpp"
#include "segment_limits.hpp"

namespace batuta::lanes {

/// Two ends of a segment in each lane.
template <class L>
struct SegmentEnds {
  Vector<L> a, b;
};

/// Closest points in each lane. Those of a lane that is hard mean nothing: ask closest_points().
template <class L>
struct Closest {
  L s, u;
  Vector<L> p_A, p_B, normal_AB;
  L distance;
  typename L::Truth hard;
};

/// The order by coordinates.
template <class L>
BATUTA_LANE typename L::Truth comes_before(const Vector<L>& p, const Vector<L>& q) {
  typename L::Truth before = p.x < q.x;
  const typename L::Truth tie = p.x == q.x;
  if (any(tie)) before = before | (tie & ((p.y < q.y) | ((p.y == q.y) & (p.z < q.z))));
  return before;
}
template <class L>
BATUTA_LANE typename L::Truth comes_before(const SegmentEnds<L>& A, const SegmentEnds<L>& B) {
  typename L::Truth before = A.a.x < B.a.x;
  const typename L::Truth tie = A.a.x == B.a.x;
  if (any(tie)) {
    before = before |
             (tie & (comes_before(A.a, B.a) | (~comes_before(B.a, A.a) & comes_before(A.b, B.b))));
  }
  return before;
}

template <class L>
struct SegmentQuery {
  Vector<L> d_A, d_B, r;
  L AA, BB, SS;
};

template <class L>
BATUTA_LANE L rough_distance(const SegmentQuery<L>& q, const L& s, const L& u) {
  const Vector<L> gap = q.r + (u * q.d_B - s * q.d_A);
  return root(dot(gap, gap));
}

template <class L>
struct PairParameters {
  L s, u;
};

/// The middle pair in the lanes of nearly parallel segments where it is as good as x, else x. A
/// call, with copies: what is rare must not cost the others their registers.
template <class L>
[[gnu::noinline]] void prefer_middle(const SegmentQuery<L>& q, const typename L::Truth& parallel,
                                     PairParameters<L>& x) {
  using Scalar = typename L::Scalar;
  const L s_a = unit_clamp(dot(q.r, q.d_A) / q.AA);
  const L s_b = unit_clamp(dot(q.r + q.d_B, q.d_A) / q.AA);
  const L s = (s_a + s_b) / L(2);
  const L u = unit_clamp(dot(s * q.d_A - q.r, q.d_B) / q.BB);
  const L slack = L(kMiddleSlack<Scalar>) * root(q.SS);
  const typename L::Truth better =
      parallel & (rough_distance(q, s, u) <= rough_distance(q, x.s, x.u) + slack);
  x.s = select(better, s, x.s);
  x.u = select(better, u, x.u);
}

/// The pair around the crossing of the lines, or the middle one.
template <class L>
BATUTA_LANE PairParameters<L> closest_pair(const SegmentQuery<L>& q) {
  using Scalar = typename L::Scalar;
  const Vector<L> n = cross(q.d_A, q.d_B);
  const L nn = dot(n, n);
  const L s0 = unit_clamp(dot(cross(q.r, q.d_B), n) / nn);
  const Vector<L> g = s0 * q.d_A - q.r;
  const L u = unit_clamp(dot(g, q.d_B) / q.BB);
  const L s = unit_clamp(s0 + dot(u * q.d_B - g, q.d_A) / q.AA);
  const typename L::Truth parallel = ~(nn > L(kClearAngle2<Scalar>) * q.AA * q.BB);
  if (!any(parallel)) return {s, u};
  const SegmentQuery<L> copy = q;
  PairParameters<L> x = {s, u};
  prefer_middle<L>(copy, parallel, x);
  return x;
}

/// @pre no lane needs to be a number: one that is not is hard
template <class L>
BATUTA_LANE Closest<L> closest_points(const SegmentEnds<L>& A_in, const SegmentEnds<L>& B_in) {
  SegmentEnds<L> A = A_in;
  SegmentEnds<L> B = B_in;
  using Scalar = typename L::Scalar;
  using Truth = typename L::Truth;
  using Window = ScaleWindow<Scalar>;
  const Truth flips_A = comes_before(A.b, A.a);
  const Truth flips_B = comes_before(B.b, B.a);
  swap_where(flips_A, A.a, A.b);
  swap_where(flips_B, B.a, B.b);
  const Truth swapped = comes_before(B, A);
  swap_where(swapped, A.a, B.a);
  swap_where(swapped, A.b, B.b);

  SegmentQuery<L> q;
  q.d_A = A.b - A.a;
  q.d_B = B.b - B.a;
  q.r = B.a - A.a;
  q.AA = dot(q.d_A, q.d_A);
  q.BB = dot(q.d_B, q.d_B);
  q.SS = q.AA + q.BB + dot(q.r, q.r);
  PairParameters<L> x = closest_pair(q);

  const Truth late_A = x.s > L(Scalar(0.5));
  const Truth late_B = x.u > L(Scalar(0.5));
  const Vector<L> end_A = select(late_A, A.b, A.a);
  const Vector<L> end_B = select(late_B, B.b, B.a);
  const Vector<L> to_A = (x.s - select(late_A, L(1), L(0))) * q.d_A;
  const Vector<L> to_B = (x.u - select(late_B, L(1), L(0))) * q.d_B;
  const Vector<L> gap = (end_B - end_A) + (to_B - to_A);
  const L gap2 = dot(gap, gap);

  Closest<L> out;
  out.p_A = end_A + to_A;
  out.p_B = end_B + to_B;
  swap_where(swapped, out.p_A, out.p_B);
  swap_where(swapped, x.s, x.u);
  out.s = select(flips_A, L(1) - x.s, x.s);
  out.u = select(flips_B, L(1) - x.u, x.u);
  out.distance = root(gap2);
  out.normal_AB = gap / negated_where(swapped, out.distance);
  const Truth in_window = (q.SS >= L(16 * Window::kSmallest * Window::kSmallest)) &
                          (q.SS <= L(Window::kLargest * Window::kLargest));
  out.hard = ~(in_window & (gap2 > L(kNoise<Scalar> * kNoise<Scalar>) * q.SS));
  return out;
}

}  // namespace batuta::lanes
