// SPDX-License-Identifier: MIT
// Properties over many made queries: the error bound against a search in long double, symmetry,
// continuity.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "batuta/geometry/segment.hpp"
#include "exact_distance.hpp"

namespace batuta {
namespace {

/// Uniform numbers that are the same on every platform.
class Source {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3<double> point(double size) {
    return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
  }
  double power_of_ten(double low, double high) { return std::pow(10.0, (*this)(low, high)); }

 private:
  std::mt19937 engine_{20060131};
};

struct Pair {
  Segment<double> A, B;
};

/// B turned by about `angle` from A, crossing it near the middle at a distance of about `gap`, of
/// length `ratio`.
Pair nearly_parallel(Source& random, double angle, double gap, double ratio) {
  const Vec3<double> d = random.point(1);
  const Vec3<double> side = d.cross(random.point(1)).normalized();
  const Vec3<double> up = d.cross(side).normalized();
  const Vec3<double> middle = random(-0.4, 0.4) * d + gap * up;
  const Vec3<double> e = ratio * (d + angle * d.norm() * side) * (random(0, 1) < 0.5 ? 1 : -1);
  const double share = random(-0.1, 1.1);
  return {{-0.5 * d, 0.5 * d}, {middle - share * e, middle + (1 - share) * e}};
}

Pair any(Source& random) {
  return {{random.point(1), random.point(1)}, {random.point(1), random.point(1)}};
}

template <class Scalar>
Segment<Scalar> cast(const Segment<double>& segment, double scale, const Vec3<double>& offset) {
  return {(scale * (segment.a + offset)).template cast<Scalar>(),
          (scale * (segment.b + offset)).template cast<Scalar>()};
}

/// Excess and error of the distance in u S.
template <class Scalar>
double worst_error(const Segment<Scalar>& A, const Segment<Scalar>& B) {
  const exact::Real unit = kRoundOff<Scalar> * exact::visible_length(A, B);
  const ClosestPoints<Scalar> x = closest_points(A, B);
  const exact::Real truth = exact::least_distance(A, B);
  const exact::Real excess = exact::distance_at(A, B, x.s, x.u) - truth;
  EXPECT_TRUE(x.s >= 0 && x.s <= 1 && x.u >= 0 && x.u <= 1);
  EXPECT_NEAR(x.normal_AB.norm(), 1, 4 * kRoundOff<Scalar>);
  return unit > 0 ? static_cast<double>(std::max(excess, std::abs(x.distance - truth)) / unit) : 0;
}

TEST(SegmentProperty, NearlyParallelAtEveryAngle_WithinFourRoundOffs) {
  Source random;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double gap = random(0, 1) < 0.2 ? 0 : random.power_of_ten(-7, 1);
    const Pair pair =
        nearly_parallel(random, random.power_of_ten(-9, 0), gap, random.power_of_ten(-3, 1));
    const Vec3<double> offset = random(0, 1) < 0.5 ? Vec3<double>(0, 0, 0) : random.point(10);
    worst = std::max(worst,
                     worst_error(cast<float>(pair.A, 1, offset), cast<float>(pair.B, 1, offset)));
  }
  EXPECT_LE(worst, 4);
  EXPECT_GT(worst, 0.1) << "the made queries are too easy";
  RecordProperty("worst_uS", std::to_string(worst));
}

TEST(SegmentProperty, LengthRatiosAndScales_WithinFourRoundOffs) {
  Source random;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    Pair pair = any(random);
    const double ratio = random.power_of_ten(-8, 0);
    pair.B = {pair.B.a, pair.B.a + ratio * (pair.B.b - pair.B.a)};
    if (i % 3 == 0) pair.B.a = pair.A.a + random(0, 1) * (pair.A.b - pair.A.a);
    const double scale = random.power_of_ten(-30, 30);
    worst = std::max(worst, worst_error(cast<float>(pair.A, scale, {0, 0, 0}),
                                        cast<float>(pair.B, scale, {0, 0, 0})));
  }
  EXPECT_LE(worst, 4);
}

template <class Scalar>
void expect_symmetric(const Segment<Scalar>& A, const Segment<Scalar>& B) {
  const ClosestPoints<Scalar> x = closest_points(A, B);
  for (int k = 1; k < 8; ++k) {  // bits: turn A, turn B, swap
    Segment<Scalar> P = k & 1 ? Segment<Scalar>{A.b, A.a} : A;
    Segment<Scalar> Q = k & 2 ? Segment<Scalar>{B.b, B.a} : B;
    if (k & 4) std::swap(P, Q);
    ClosestPoints<Scalar> y = closest_points(P, Q);
    if (k & 4) {
      std::swap(y.s, y.u);
      std::swap(y.p_A, y.p_B);
      y.normal_AB = -y.normal_AB;
    }
    EXPECT_EQ(x.p_A, y.p_A);
    EXPECT_EQ(x.p_B, y.p_B);
    EXPECT_EQ(x.distance, y.distance);
    EXPECT_EQ(x.normal_AB, y.normal_AB);
    EXPECT_NEAR(x.s, k & 1 && A.a != A.b ? 1 - y.s : y.s, kRoundOff<Scalar>);
    EXPECT_NEAR(x.u, k & 2 && B.a != B.b ? 1 - y.u : y.u, kRoundOff<Scalar>);
  }
}

TEST(SegmentProperty, SwappingSegmentsOrEnds_GivesTheSameBits) {
  Source random;
  for (int i = 0; i < 3000; ++i) {
    const Pair pair =
        i % 2 == 0 ? any(random) : nearly_parallel(random, i % 3 == 0 ? 0 : 1e-4, 0.1, 0.7);
    expect_symmetric(cast<float>(pair.A, 1, {0, 0, 0}), cast<float>(pair.B, 1, {0, 0, 0}));
    expect_symmetric(pair.A, pair.B);
  }
}

TEST(SegmentProperty, SwappingOnAGrid_GivesTheSameBits) {
  std::mt19937 engine(7);
  const auto point = [&] {
    return Vec3<float>(float(engine() % 3), float(engine() % 3), float(engine() % 2));
  };
  for (int i = 0; i < 3000; ++i) {
    const Segment<float> A{point(), point()};
    const Segment<float> B{point(), point()};
    const bool identical = (A.a == B.a && A.b == B.b) || (A.a == B.b && A.b == B.a);
    if (!identical) expect_symmetric(A, B);
    EXPECT_LE(worst_error(A, B), 4);
  }
}

TEST(SegmentProperty, Nudge_ChangesTheDistanceByNoMoreThanItself) {
  Source random;
  for (int i = 0; i < 20000; ++i) {
    const Pair pair =
        i % 2 == 0 ? any(random) : nearly_parallel(random, random.power_of_ten(-6, 0), 0.1, 1);
    const Vec3<double> nudge = random.point(1e-6);
    const Segment<float> A = cast<float>(pair.A, 1, {0, 0, 0});
    const Segment<float> B = cast<float>(pair.B, 1, {0, 0, 0});
    const Segment<float> C{(pair.B.a + nudge).cast<float>(), B.b};
    const double moved = (C.a - B.a).cast<double>().norm();
    const double allowed =
        moved + 8 * kRoundOff<float> * static_cast<double>(exact::visible_length(A, B));
    EXPECT_LE(std::abs(closest_points(A, B).distance - closest_points(A, C).distance), allowed);
  }
}

TEST(SegmentProperty, PointOnSegment_WithinFourRoundOffsAndSymmetric) {
  Source random;
  for (int i = 0; i < 20000; ++i) {
    const double scale = random.power_of_ten(-30, 30);
    const Segment<float> A = cast<float>({random.point(1), random.point(1)}, scale, {0, 0, 0});
    const Vec3<float> p = cast<float>({random.point(1), {0, 0, 0}}, scale, {0, 0, 0}).a;
    const PointOnSegment<float> x = closest_point(A, p);
    const PointOnSegment<float> y = closest_point({A.b, A.a}, p);
    const Segment<float> point{p, p};
    const exact::Real bound = 4 * kRoundOff<float> * exact::visible_length(A, point);
    const exact::Real truth = exact::least_distance(A, point);
    EXPECT_LE(std::abs(x.distance - truth), bound);
    EXPECT_LE(exact::distance_at(A, point, x.s, 0) - truth, bound);
    EXPECT_EQ(x.point, y.point);
    EXPECT_EQ(x.distance, y.distance);
  }
}

}  // namespace
}  // namespace batuta
