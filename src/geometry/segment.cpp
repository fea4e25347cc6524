// SPDX-License-Identifier: MIT
#include "batuta/geometry/segment.hpp"

#include <array>
#include <cstddef>

#include "batuta/geometry/direction.hpp"
#include "scale_window.hpp"

namespace batuta {
namespace {

/// sin^2 of the angle above which the crossing is computed well enough to need no look at the ends
/// (segment.md).
template <class Scalar>
constexpr Scalar kClearAngle2 = Scalar(1) / 256;

/// A distance below this times the largest component is rounding error, its direction means nothing
/// (segment.md).
template <class Scalar>
constexpr Scalar kNoise = 4 * kRoundOff<Scalar>;

/// How much longer than the shortest one, over the largest component, the middle pair of a range
/// may be.
template <class Scalar>
constexpr Scalar kMiddleSlack = kRoundOff<Scalar>;

/// sin^2 of the angle below which the cross product is rounding error.
template <class Scalar>
constexpr Scalar kParallel2 = 64 * kRoundOff<Scalar>* kRoundOff<Scalar>;

template <class Scalar>
bool comes_before(const Vec3<Scalar>& p, const Vec3<Scalar>& q) {
  if (p.x() != q.x()) return p.x() < q.x();
  if (p.y() != q.y()) return p.y() < q.y();
  return p.z() < q.z();
}

/// The two in the other order if `swapped`. Chosen by index: which order it is cannot be foreseen,
/// and a branch would be guessed wrong half the time.
template <class T>
std::array<T, 2> in_order(const T& first, const T& second, bool swapped) {
  const std::array<const T*, 2> both = {&first, &second};
  const std::size_t i = swapped ? 1 : 0;
  return {*both[i], *both[1 - i]};
}

template <class Scalar>
bool is_flipped(const Segment<Scalar>& segment) {
  return comes_before(segment.b, segment.a);
}

template <class Scalar>
Segment<Scalar> ordered(const Segment<Scalar>& segment, bool flipped) {
  const std::array<Vec3<Scalar>, 2> ends = in_order(segment.a, segment.b, flipped);
  return {ends[0], ends[1]};
}

/// The two segments in an order that their caller cannot influence: what makes the answer
/// symmetric.
template <class Scalar>
struct Ordered {
  Segment<Scalar> A, B;
  bool flipped_A, flipped_B, swapped;

  Ordered(const Segment<Scalar>& A_in, const Segment<Scalar>& B_in)
      : flipped_A(is_flipped(A_in)), flipped_B(is_flipped(B_in)) {
    const Segment<Scalar> P = ordered(A_in, flipped_A);
    const Segment<Scalar> Q = ordered(B_in, flipped_B);
    swapped = comes_before(Q.a, P.a) || (Q.a == P.a && comes_before(Q.b, P.b));
    const std::array<Segment<Scalar>, 2> both = in_order(P, Q, swapped);
    A = both[0];
    B = both[1];
  }
};

/// What the kernel works on: differences of ends (so that the distance from the origin costs
/// nothing), scaled.
template <class Scalar>
struct Query {
  Vec3<Scalar> d_A, d_B;
  std::array<Vec3<Scalar>, 4> corner;  ///< [2 i + j]: from end i of A to end j of B
  Scalar length, scale;                ///< largest component (scaled), power of two
  Scalar inv_AA, inv_BB;               ///< 1 / |d|^2; 0 for a point
};

template <class Scalar>
Scalar inverse_square(const Vec3<Scalar>& d) {
  const Scalar dd = d.squaredNorm();
  return dd < std::numeric_limits<Scalar>::min() ? Scalar(0) : 1 / dd;
}

template <class Scalar>
Query<Scalar> make_query(const Segment<Scalar>& A, const Segment<Scalar>& B) {
  Query<Scalar> q;
  q.d_A = A.direction();
  q.d_B = B.direction();
  q.corner = {B.a - A.a, B.b - A.a, B.a - A.b, B.b - A.b};
  const Scalar length =
      max_of(max_of(largest_component(q.d_A), largest_component(q.d_B)),
             max_of(largest_component(q.corner[0]), largest_component(q.corner[3])));
  q.scale = window_scale(length);
  q.length = length * q.scale;
  if (q.scale != 1) {
    q.d_A *= q.scale;
    q.d_B *= q.scale;
    for (Vec3<Scalar>& c : q.corner) c *= q.scale;  // Bound: 4
  }
  q.inv_AA = inverse_square(q.d_A);
  q.inv_BB = inverse_square(q.d_B);
  return q;
}

/// A pair of points, and from the one on A to the one on B.
template <class Scalar>
struct Candidate {
  Scalar s, u;
  Vec3<Scalar> gap;
  Scalar gap2;
};

/// From A(s) to B(u). Measured from the nearest ends: exact at an end, and half the rounding error
/// elsewhere.
template <class Scalar>
inline Vec3<Scalar> between(const Query<Scalar>& q, Scalar s, Scalar u) {
  const std::size_t i = s > Scalar(0.5) ? 1 : 0;
  const std::size_t j = u > Scalar(0.5) ? 1 : 0;
  const Scalar from_i = s - static_cast<Scalar>(i);
  const Scalar from_j = u - static_cast<Scalar>(j);
  return q.corner[2 * i + j] + (from_j * q.d_B - from_i * q.d_A);
}

template <class Scalar>
Candidate<Scalar> candidate(const Query<Scalar>& q, Scalar s, Scalar u) {
  const Vec3<Scalar> gap = between(q, s, u);
  return {s, u, gap, gap.squaredNorm()};
}

/// To [0, 1]; never -0, and 0 for NaN.
template <class Scalar>
Scalar unit_clamp(Scalar x) {
  const Scalar low = x > 0 ? x : Scalar(0);
  return low < 1 ? low : Scalar(1);
}

template <class Scalar>
void keep_shorter(Candidate<Scalar>& best, const Candidate<Scalar>& other) {
  if (other.gap2 < best.gap2) best = other;
}

/// The point of A where the lines are closest, from the cross product n; not clamped.
template <class Scalar>
Scalar crossing(const Query<Scalar>& q, const Vec3<Scalar>& n, Scalar nn) {
  return q.corner[0].cross(q.d_B).dot(n) / nn;
}

/// The pair around the crossing s0: clamped, projected onto B, and back onto A.
template <class Scalar>
Candidate<Scalar> around_crossing(const Query<Scalar>& q, Scalar s0) {
  const Scalar s1 = unit_clamp(s0);
  const Scalar u = unit_clamp(-between(q, s1, Scalar(0)).dot(q.d_B) * q.inv_BB);
  const Scalar s2 = unit_clamp(s1 + between(q, s1, u).dot(q.d_A) * q.inv_AA);
  return candidate(q, s2, u);
}

/// The ends of each segment projected onto the other one.
template <class Scalar>
struct EndProjections {
  Scalar s_a, s_b;  ///< on A, of the ends of B
  Scalar u_a, u_b;  ///< on B, of the ends of A

  explicit EndProjections(const Query<Scalar>& q)
      : s_a(unit_clamp(q.corner[0].dot(q.d_A) * q.inv_AA)),
        s_b(unit_clamp(q.corner[1].dot(q.d_A) * q.inv_AA)),
        u_a(unit_clamp(-q.corner[0].dot(q.d_B) * q.inv_BB)),
        u_b(unit_clamp(-q.corner[2].dot(q.d_B) * q.inv_BB)) {}

  Candidate<Scalar> shortest(const Query<Scalar>& q) const {
    Candidate<Scalar> best = candidate(q, s_a, Scalar(0));
    keep_shorter(best, candidate(q, s_b, Scalar(1)));
    keep_shorter(best, candidate(q, Scalar(0), u_a));
    keep_shorter(best, candidate(q, Scalar(1), u_b));
    return best;
  }
  /// Of parallel segments: the middle of the part where they run side by side.
  Candidate<Scalar> middle(const Query<Scalar>& q) const {
    return candidate(q, (s_a + s_b) / 2, (u_a + u_b) / 2);
  }
};

/// Of nearly parallel segments: everything is tried, and the middle wins if it is as good as any.
template <class Scalar>
Candidate<Scalar> closest_near_parallel(const Query<Scalar>& q, Scalar s0) {
  const EndProjections<Scalar> ends(q);
  Candidate<Scalar> best = ends.shortest(q);
  keep_shorter(best, around_crossing(q, s0));
  const Candidate<Scalar> middle = ends.middle(q);
  const Scalar limit = std::sqrt(best.gap2) + kMiddleSlack<Scalar> * q.length;
  return middle.gap2 <= limit * limit ? middle : best;
}

template <class Scalar>
Candidate<Scalar> closest_pair(const Query<Scalar>& q) {
  const Vec3<Scalar> n = q.d_A.cross(q.d_B);
  const Scalar nn = n.squaredNorm();
  const Scalar s0 = nn > 0 ? crossing(q, n, nn) : Scalar(0);
  const Scalar sine2 = nn * q.inv_AA * q.inv_BB;
  if (sine2 > kClearAngle2<Scalar>) return around_crossing(q, s0);
  return closest_near_parallel(q, s0);
}

/// The normal of points that coincide, as the header promises.
template <class Scalar>
Vec3<Scalar> conventional_normal(const Query<Scalar>& q) {
  const Vec3<Scalar> n = q.d_A.cross(q.d_B);
  const Scalar AA = q.d_A.squaredNorm();
  const Scalar BB = q.d_B.squaredNorm();
  if (n.squaredNorm() > kParallel2<Scalar> * AA * BB) return unit(n);
  if (AA == 0 && BB == 0) return Vec3<Scalar>::UnitX();
  return perpendicular(AA < BB ? q.d_B : q.d_A);
}

template <class Scalar>
ClosestPoints<Scalar> answer(const Ordered<Scalar>& in, const Query<Scalar>& q,
                             const Candidate<Scalar>& pair) {
  ClosestPoints<Scalar> out;
  const Scalar distance = std::sqrt(pair.gap2);
  out.s = pair.s;
  out.u = pair.u;
  out.p_A = in.A.at(pair.s);
  out.p_B = in.B.at(pair.u);
  out.distance = distance / q.scale;
  out.arbitrary = !(distance > kNoise<Scalar> * q.length);
  if (!out.arbitrary) {
    out.normal_AB = pair.gap / distance;
  } else {
    out.normal_AB = conventional_normal(q);
    if (out.normal_AB.dot(pair.gap) < 0) out.normal_AB = -out.normal_AB;
  }
  return out;
}

/// Back to the caller's order of segments and ends.
template <class Scalar>
void restore_order(const Ordered<Scalar>& in, ClosestPoints<Scalar>& out) {
  const std::array<Scalar, 2> parameters = in_order(out.s, out.u, in.swapped);
  const std::array<Vec3<Scalar>, 2> points = in_order(out.p_A, out.p_B, in.swapped);
  const Scalar turn = in.swapped ? Scalar(-1) : Scalar(1);
  out.s = in.flipped_A ? 1 - parameters[0] : parameters[0];
  out.u = in.flipped_B ? 1 - parameters[1] : parameters[1];
  out.p_A = points[0];
  out.p_B = points[1];
  out.normal_AB *= turn;
}

}  // namespace

template <class Scalar>
PointOnSegment<Scalar> closest_point(const Segment<Scalar>& segment, const Vec3<Scalar>& point) {
  const bool flipped = is_flipped(segment);
  const Segment<Scalar> A = ordered(segment, flipped);
  const Query<Scalar> q = make_query(A, {point, point});
  const Scalar s = unit_clamp(q.corner[0].dot(q.d_A) * q.inv_AA);
  const Scalar distance = std::sqrt(candidate(q, s, Scalar(0)).gap2) / q.scale;
  return {flipped ? 1 - s : s, A.at(s), distance};
}

template <class Scalar>
ClosestPoints<Scalar> closest_points(const Segment<Scalar>& A, const Segment<Scalar>& B) {
  const Ordered<Scalar> in(A, B);
  const Query<Scalar> q = make_query(in.A, in.B);
  ClosestPoints<Scalar> out = answer(in, q, closest_pair(q));
  restore_order(in, out);
  return out;
}

#define BATUTA_INSTANTIATE(S)                                                  \
  template PointOnSegment<S> closest_point(const Segment<S>&, const Vec3<S>&); \
  template ClosestPoints<S> closest_points(const Segment<S>&, const Segment<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
