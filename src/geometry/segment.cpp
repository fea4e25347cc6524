// SPDX-License-Identifier: MIT
#include "batuta/geometry/segment.hpp"

#include <utility>

#include "batuta/geometry/direction.hpp"
#include "scale_window.hpp"
#include "segment_limits.hpp"

// What always runs is one straight piece of code that lives in registers: its parts are inlined,
// and the others are called with copies, so that the originals need no memory. The rare parts are
// compiled for size; those apart are common enough to be compiled for speed.
#define BATUTA_HOT [[gnu::always_inline]] inline
#define BATUTA_APART [[gnu::noinline]]
#define BATUTA_RARE [[gnu::cold, gnu::noinline]]

namespace batuta {
namespace {

template <class Scalar>
BATUTA_RARE bool comes_before_by_y(const Vec3<Scalar>& p, const Vec3<Scalar>& q) {
  return p.y() != q.y() ? p.y() < q.y() : p.z() < q.z();
}

/// The order by coordinates: the same for every caller.
template <class Scalar>
BATUTA_HOT bool comes_before(const Vec3<Scalar>& p, const Vec3<Scalar>& q) {
  if (p.x() < q.x()) return true;
  if (p.x() > q.x()) return false;
  return comes_before_by_y(p, q);
}

/// The ends of a segment, in that order.
template <class Scalar>
struct Ends {
  const Vec3<Scalar>* a;
  const Vec3<Scalar>* b;
  bool flipped;

  BATUTA_HOT explicit Ends(const Segment<Scalar>& segment)
      : a(&segment.a), b(&segment.b), flipped(comes_before(segment.b, segment.a)) {
    if (flipped) std::swap(a, b);
  }
  BATUTA_HOT Ends(const Vec3<Scalar>* first, const Vec3<Scalar>* second, bool was_flipped)
      : a(first), b(second), flipped(was_flipped) {}
  BATUTA_HOT Scalar in_callers_order(Scalar s) const { return flipped ? 1 - s : s; }
};

template <class Scalar>
BATUTA_RARE bool comes_before_by_all(Ends<Scalar> A, Ends<Scalar> B) {
  if (comes_before(*A.a, *B.a)) return true;
  return !comes_before(*B.a, *A.a) && comes_before(*A.b, *B.b);
}

template <class Scalar>
BATUTA_HOT bool comes_before(const Ends<Scalar>& A, const Ends<Scalar>& B) {
  if (A.a->x() < B.a->x()) return true;
  if (A.a->x() > B.a->x()) return false;
  return comes_before_by_all(A, B);
}

/// A copy made of scalars, so that the original can stay in registers.
template <class Scalar>
BATUTA_HOT Vec3<Scalar> by_value(const Vec3<Scalar>& v) {
  return {v.x(), v.y(), v.z()};
}

/// What the kernel works on: differences of ends, so that the distance from the origin costs
/// nothing.
template <class Scalar>
struct Query {
  Vec3<Scalar> d_A, d_B, r;  ///< r: from the first end of A to that of B
  Scalar AA, BB, SS;         ///< squares: of d_A, of d_B, of all three
  Scalar scale;              ///< power of two that all of these have been multiplied by
};

template <class Scalar>
BATUTA_HOT Query<Scalar> make_query(const Ends<Scalar>& A, const Ends<Scalar>& B) {
  Query<Scalar> q;
  q.d_A = *A.b - *A.a;
  q.d_B = *B.b - *B.a;
  q.r = *B.a - *A.a;
  q.AA = q.d_A.squaredNorm();
  q.BB = q.d_B.squaredNorm();
  q.SS = q.AA + q.BB + q.r.squaredNorm();
  q.scale = 1;
  return q;
}
template <class Scalar>
BATUTA_HOT Query<Scalar> by_value(const Query<Scalar>& q) {
  return {by_value(q.d_A), by_value(q.d_B), by_value(q.r), q.AA, q.BB, q.SS, q.scale};
}

/// Differences are scaled, not ends: lengths may be tiny far from the origin.
template <class Scalar>
BATUTA_RARE void bring_into_window(Query<Scalar>& q) {
  q.scale = window_scale(
      max_of(detail::largest_component(q.r),
             max_of(detail::largest_component(q.d_A), detail::largest_component(q.d_B))));
  q.d_A *= q.scale;
  q.d_B *= q.scale;
  q.r *= q.scale;
  q.AA = q.d_A.squaredNorm();
  q.BB = q.d_B.squaredNorm();
  q.SS = q.AA + q.BB + q.r.squaredNorm();
}

/// To [0, 1]; never -0, and 0 for NaN: what a projection onto a point gives.
template <class Scalar>
BATUTA_HOT Scalar unit_clamp(Scalar x) {
  const Scalar low = x > 0 ? x : Scalar(0);
  return low < 1 ? low : Scalar(1);
}

template <class Scalar>
struct Parameters {
  Scalar s, u;
};

/// The pair around the crossing s0 of the lines: clamped, to the nearest point of B, and back to A.
template <class Scalar>
BATUTA_HOT Parameters<Scalar> around_crossing(const Query<Scalar>& q, Scalar s0) {
  const Scalar s = unit_clamp(s0);
  const Vec3<Scalar> g = s * q.d_A - q.r;
  const Scalar u = g.dot(q.d_B) / q.BB;
  const Scalar u1 = unit_clamp(u);
  return {unit_clamp(s + (u1 * q.d_B - g).dot(q.d_A) / q.AA), u1};
}

template <class Scalar>
BATUTA_HOT Scalar rough_distance(const Query<Scalar>& q, Parameters<Scalar> x) {
  const Vec3<Scalar> gap = q.r + (x.u * q.d_B - x.s * q.d_A);
  return std::sqrt(gap.squaredNorm());
}

/// Of nearly parallel segments: the middle of the part where they run side by side, if it is as
/// good as x.
template <class Scalar>
BATUTA_APART Parameters<Scalar> prefer_middle(Query<Scalar> q, Scalar s, Scalar u) {
  const Scalar s_a = unit_clamp(q.r.dot(q.d_A) / q.AA);
  const Scalar s_b = unit_clamp((q.r + q.d_B).dot(q.d_A) / q.AA);
  Parameters<Scalar> middle;
  middle.s = (s_a + s_b) / 2;
  middle.u = unit_clamp((middle.s * q.d_A - q.r).dot(q.d_B) / q.BB);
  const Parameters<Scalar> x = {s, u};
  const Scalar slack = kMiddleSlack<Scalar> * std::sqrt(q.SS);
  return rough_distance(q, middle) <= rough_distance(q, x) + slack ? middle : x;
}

/// The normal of points that coincide, as the header promises; of the sign of `gap`.
template <class Scalar>
BATUTA_APART Vec3<Scalar> conventional_normal(Query<Scalar> q, Vec3<Scalar> gap) {
  const Vec3<Scalar> n = q.d_A.cross(q.d_B);
  Vec3<Scalar> normal = Vec3<Scalar>::UnitX();
  if (n.squaredNorm() > kParallel2<Scalar> * q.AA * q.BB) {
    normal = unit(n);
  } else if (q.AA > 0 || q.BB > 0) {
    normal = detail::perpendicular(q.AA < q.BB ? q.d_B : q.d_A);
  }
  if (normal.dot(gap) < 0) normal = -normal;
  return normal;
}

/// A point of a segment, measured from the nearer end: exact at the ends, and half the rounding
/// error elsewhere.
template <class Scalar>
struct PointOnAxis {
  const Vec3<Scalar>* end;
  Scalar from_end;
};
template <class Scalar>
BATUTA_HOT PointOnAxis<Scalar> place(const Ends<Scalar>& A, Scalar s) {
  if (s > Scalar(0.5)) return {A.b, s - 1};
  return {A.a, s};
}

template <class Scalar>
BATUTA_HOT Parameters<Scalar> closest_pair(const Query<Scalar>& q) {
  const Vec3<Scalar> n = q.d_A.cross(q.d_B);
  const Scalar nn = n.squaredNorm();
  const Parameters<Scalar> x = around_crossing(q, q.r.cross(q.d_B).dot(n) / nn);
  if (nn > kClearAngle2<Scalar> * q.AA * q.BB) return x;
  return prefer_middle<Scalar>(by_value(q), x.s, x.u);
}

/// The pair x in the caller's order of segments and ends.
template <class Scalar>
BATUTA_HOT ClosestPoints<Scalar> result_of(const Query<Scalar>& q, const Ends<Scalar>& A,
                                           const Ends<Scalar>& B, const Parameters<Scalar>& x,
                                           bool swapped) {
  const PointOnAxis<Scalar> at_A = place(A, x.s);
  const PointOnAxis<Scalar> at_B = place(B, x.u);
  Vec3<Scalar> to_A = at_A.from_end * q.d_A;
  Vec3<Scalar> to_B = at_B.from_end * q.d_B;
  Vec3<Scalar> between_ends = *at_B.end - *at_A.end;
  const bool is_scaled = q.scale != Scalar(1);
  if (is_scaled) between_ends *= q.scale;
  const Vec3<Scalar> gap = between_ends + (to_B - to_A);
  if (is_scaled) {
    to_A /= q.scale;
    to_B /= q.scale;
  }
  const Vec3<Scalar> p_A = *at_A.end + to_A;
  const Vec3<Scalar> p_B = *at_B.end + to_B;
  const Scalar gap2 = gap.squaredNorm();
  ClosestPoints<Scalar> out;
  out.s = A.in_callers_order(x.s);
  out.u = B.in_callers_order(x.u);
  out.p_A = by_value(p_A);
  out.p_B = by_value(p_B);
  out.distance = std::sqrt(gap2);
  out.normal_AB = by_value<Scalar>(gap / (swapped ? -out.distance : out.distance));
  if (swapped) {
    std::swap(out.s, out.u);
    out.p_A = by_value(p_B);
    out.p_B = by_value(p_A);
  }
  if (!(gap2 > kNoise<Scalar> * kNoise<Scalar> * q.SS)) {
    out.arbitrary = true;
    out.normal_AB = conventional_normal<Scalar>(by_value(q), by_value(gap));
    if (swapped) out.normal_AB = -out.normal_AB;
  }
  if (is_scaled) out.distance /= q.scale;
  return out;
}

}  // namespace

template <class Scalar>
PointOnSegment<Scalar> closest_point(const Segment<Scalar>& segment, const Vec3<Scalar>& point) {
  const ClosestPoints<Scalar> x = closest_points<Scalar>(segment, {point, point});
  return {x.s, x.p_A, x.distance};
}

template <class Scalar>
ClosestPoints<Scalar> closest_points(const Segment<Scalar>& A_in, const Segment<Scalar>& B_in) {
  Ends<Scalar> A(A_in);
  Ends<Scalar> B(B_in);
  const bool swapped = comes_before(B, A);
  if (swapped) std::swap(A, B);
  Query<Scalar> q = make_query(A, B);
  if (!is_in_window(q.SS)) bring_into_window(q);
  return result_of(q, A, B, closest_pair(q), swapped);
}

#define BATUTA_INSTANTIATE(S)                                                  \
  template PointOnSegment<S> closest_point(const Segment<S>&, const Vec3<S>&); \
  template ClosestPoints<S> closest_points(const Segment<S>&, const Segment<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE
#undef BATUTA_HOT
#undef BATUTA_APART
#undef BATUTA_RARE

}  // namespace batuta
