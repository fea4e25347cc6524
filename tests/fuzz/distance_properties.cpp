// SPDX-License-Identifier: MIT
// What must hold of distances and bounds of capsules for any numbers whatever, as a libFuzzer
// target. Every bound is the one that the headers of geometry/ promise.

#include <algorithm>

#include "batuta/geometry/kdop.hpp"
#include "bytes.hpp"
#include "oracle.hpp"

namespace batuta::fuzz {
namespace {

using Points = ClosestPoints<float>;

Segment<float> reversed(const Segment<float>& s) {
  return {s.b, s.a};
}
Segment<float> turned(const Segment<float>& s) {
  return {cube_turned(s.a), cube_turned(s.b)};
}
Segment<float> times(float factor, const Segment<float>& s) {
  return {factor * s.a, factor * s.b};
}
bool is_same_segment(const Segment<float>& A, const Segment<float>& B) {
  return (A.a == B.a && A.b == B.b) || (A.a == B.b && A.b == B.a);
}

void check_against_truth(const Segment<float>& A, const Segment<float>& B, const Points& found) {
  const RealAxis a = real(A);
  const RealAxis b = real(B);
  const double slack = kU * visible_length(a, b);
  const double least = least_distance(a, b);
  const auto distance = static_cast<double>(found.distance);
  require(found.s >= 0 && found.s <= 1 && found.u >= 0 && found.u <= 1, "parameters are places");
  require(std::abs(distance - least) <= 5 * slack + kLeast, "the distance is right to 5 u S");
  const Real3 on_A = point_at(a, static_cast<double>(found.s));
  const Real3 on_B = point_at(b, static_cast<double>(found.u));
  require((on_B - on_A).norm() <= least + 4 * slack + kLeast,
          "no pair is closer by more than 4 u S");
  const double length = found.normal_AB.cast<double>().norm();
  require(std::abs(length - 1) <= 5 * kU, "the normal is unit");  // to 4 u, and second order
}

/// @param turned_round  the two segments changed places
void require_same(const Points& found, const Points& other, bool turned_round, bool has_normal) {
  require(found.distance == other.distance, "the same distance");
  require(found.p_A == (turned_round ? other.p_B : other.p_A), "the same point on A");
  require(found.p_B == (turned_round ? other.p_A : other.p_B), "the same point on B");
  if (!has_normal) return;
  const Vec3<float> normal = turned_round ? Vec3<float>(-other.normal_AB) : other.normal_AB;
  require(found.normal_AB == normal, "the same normal");
}

void check_symmetry(const Segment<float>& A, const Segment<float>& B, const Points& found) {
  const bool has_normal = !is_same_segment(A, B);
  require_same(found, closest_points(B, A), true, has_normal);
  const Points other = closest_points(reversed(A), B);
  require_same(found, other, false, has_normal);
  const float back = A.a == A.b ? other.s : 1 - other.s;
  require(std::abs(static_cast<double>(found.s) - static_cast<double>(back)) <= 2 * kU,
          "a place is counted from the other end");  // one rounding of 1 - s each way
  require_same(found, closest_points(A, reversed(B)), false, has_normal);
}

/// Turned, each distance is right to 5 u S; scaled by a power of two it is the same to the last
/// bit as long as nothing underflows, and on the grid nothing does: no product of four lengths is
/// below (kGridStep / 64)^4.
void check_frames(const Segment<float>& A, const Segment<float>& B, const Points& found,
                  Numbers from) {
  const double S = visible_length(real(A), real(B));
  const Points other = closest_points(turned(A), turned(B));
  require(std::abs(static_cast<double>(found.distance) - static_cast<double>(other.distance)) <=
              10 * kU * S + 2 * kLeast,
          "a turned pair is as far apart");
  if (from != Numbers::kGrid) return;
  for (const float factor : {0x1p-6F, 0x1p6F}) {
    const Points scaled = closest_points(times(factor, A), times(factor, B));
    require(scaled.distance == factor * found.distance && scaled.s == found.s &&
                scaled.u == found.u && scaled.normal_AB == found.normal_AB,
            "a pair of twice the size is twice as far apart");
  }
}

void check_radii(const Capsule<float>& A, const Capsule<float>& B, float more) {
  const CapsuleGap<float> gap = capsule_gap(A, B);
  require(gap.proximity != Proximity::kInvalid, "what is valid can be told");
  require(overlaps(A, B) == (gap.gap <= 0), "overlap is a gap that is not there");
  require(penetration_depth(A, B) == max_of(0.0F, -gap.gap), "depth is a gap below zero");
  require(capsule_gap(B, A).gap == gap.gap, "the same gap from B");
  Capsule<float> thicker = B;
  thicker.radius += more;
  if (is_valid(thicker)) {
    require(capsule_gap(A, thicker).gap <= gap.gap, "thicker is not further apart");
  }
}

/// The nearest point of A to an end of B.
void check_point(const Capsule<float>& A, const Vec3<float>& point) {
  const RealAxis axis = real(A.axis);
  const Real3 p = point.cast<double>();
  const double S = std::max({(axis.b - axis.a).norm(), (p - axis.a).norm(), (p - axis.b).norm()});
  const PointOnSegment<float> found = closest_point(A.axis, point);
  require(found.s >= 0 && found.s <= 1, "a place is on the axis");
  require(
      std::abs(static_cast<double>(found.distance) - distance_to(axis, p)) <= 5 * kU * S + kLeast,
      "a point's distance is right to 5 u S");
  const PointOnSegment<float> other = closest_point(reversed(A.axis), point);
  require(other.distance == found.distance && other.point == found.point, "from either end");
  const Result<Vec3<float>> normal = surface_normal(A, point);
  require(normal.status != Status::kInvalidArgument, "every place has a normal");
  require(std::abs(normal.value.cast<double>().norm() - 1) <= 5 * kU, "which is unit");
}

/// Holds every point of the capsule: exactly, since it is rounded outward.
template <int K>
void check_bounds(const Capsule<float>& A, const Capsule<float>& B, double least) {
  const Kdop<float, K> dop_A = detail::kdop_of<float, K>(A);
  const Kdop<float, K> dop_B = detail::kdop_of<float, K>(B);
  const Kdop<float, K> both = merge(dop_A, dop_B);
  const RealAxis axis = real(A.axis);
  for (int i = 0; i < K / 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Real3 d = detail::kdop_direction<float, K>(i).template cast<double>();
    const double radius = static_cast<double>(A.radius) * d.norm();
    const double high = std::max(axis.a.dot(d), axis.b.dot(d)) + radius;
    const double low = std::min(axis.a.dot(d), axis.b.dot(d)) - radius;
    const double real_slack = 16 * kRoundOff<double> * (std::abs(high) + std::abs(low)) + kLeast;
    require(static_cast<double>(dop_A.high[k]) >= high - real_slack,
            "a bound holds its capsule above");
    require(static_cast<double>(dop_A.low[k]) <= low + real_slack,
            "a bound holds its capsule below");
    require(both.high[k] >= dop_A.high[k] && both.low[k] <= dop_A.low[k], "what is merged is held");
  }
  const double radii = static_cast<double>(A.radius) + static_cast<double>(B.radius);
  require(overlaps(dop_A, dop_B) || least > radii * (1 - kRoundOff<double>),
          "bounds of capsules that touch touch");
  require(overlaps(dop_A, dop_B) == overlaps(dop_B, dop_A), "bounds meet both ways");
}

void check_ball(const Capsule<float>& A) {
  const Sphere<float> ball = bounding_sphere(A);
  const Real3 center = ball.center.cast<double>();
  const RealAxis axis = real(A.axis);
  const double reach =
      std::max((axis.a - center).norm(), (axis.b - center).norm()) + static_cast<double>(A.radius);
  require(static_cast<double>(ball.radius) >= reach * (1 - 8 * kRoundOff<double>)-kLeast,
          "the ball holds the capsule");
}

void check_invalid(const Capsule<float>& A, const Capsule<float>& B) {
  require(capsule_gap(A, B).proximity == Proximity::kInvalid, "what is not valid is told");
  require(!overlaps(A, B), "what is not valid does not overlap");
  require(penetration_depth(A, B) == 0, "nor is it deep");
  if (is_valid(A)) return;
  require(surface_normal(A, B.axis.a).status == Status::kInvalidArgument, "nor has it a normal");
}

void check(Bytes bytes) {
  const Numbers from = bytes.numbers();
  const Segment<float> axis_A = bytes.segment(from);
  const Segment<float> axis_B = bytes.segment(from);
  const float radius_A = bytes.radius(from);
  const Capsule<float> A{axis_A, radius_A};
  const Capsule<float> B{axis_B, bytes.radius(from)};
  if (!is_valid(A) || !is_valid(B)) return check_invalid(A, B);

  const Points found = closest_points(A.axis, B.axis);
  check_against_truth(A.axis, B.axis, found);
  check_symmetry(A.axis, B.axis, found);
  check_frames(A.axis, B.axis, found, from);
  check_radii(A, B, bytes.share());
  check_point(A, B.axis.a);
  const double least = least_distance(real(A.axis), real(B.axis));
  check_bounds<6>(A, B, least);
  check_bounds<26>(A, B, least);
  check_ball(A);
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
