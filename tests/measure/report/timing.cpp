// SPDX-License-Identifier: MIT
#include "timing.hpp"

#include <cmath>
#include <cstdint>

namespace batuta::report {

namespace {

struct SegmentPair {
  Segment<double> A;
  Segment<double> B;
};

/// So many that no branch predictor learns them by heart: a query meets fresh numbers, too.
constexpr int kPairs = 16384;

/// Segments of general position in the unit cube, the same on every host.
std::array<SegmentPair, kPairs> make_pairs() {
  std::uint32_t state = 1;
  const auto next = [&state] {
    state = 1664525U * state + 1013904223U;
    return static_cast<double>(state >> 8U) / 16777216.0;
  };
  const auto point = [&next] {
    const double x = next();
    const double y = next();
    return Vec3<double>(x, y, next());
  };
  std::array<SegmentPair, kPairs> pairs;
  for (SegmentPair& pair : pairs) {
    for (Vec3<double>* end : {&pair.A.a, &pair.A.b, &pair.B.a, &pair.B.b}) *end = point();
  }
  return pairs;
}

double clamped(double x) {
  return x < 0 ? 0 : (x > 1 ? 1 : x);
}

}  // namespace

double plain_segment_distance(const Segment<double>& A, const Segment<double>& B) {
  const Vec3<double> d = A.b - A.a;
  const Vec3<double> e = B.b - B.a;
  const Vec3<double> r = A.a - B.a;
  const double dd = d.dot(d);
  const double de = d.dot(e);
  const double ee = e.dot(e);
  const double dr = d.dot(r);
  const double er = e.dot(r);
  const double determinant = dd * ee - de * de;
  double s = determinant > 0 ? clamped((de * er - dr * ee) / determinant) : 0;
  double u = ee > 0 ? (de * s + er) / ee : 0;
  if (u < 0 || u > 1) {
    u = clamped(u);
    s = dd > 0 ? clamped((de * u - dr) / dd) : 0;
  }
  return (r + s * d - u * e).norm();
}

double plain_ns() {
  static const std::array<SegmentPair, kPairs> pairs = make_pairs();
  const double all = median_ns(8, [] {
    for (const SegmentPair& pair : pairs) {
      const double distance = plain_segment_distance(pair.A, pair.B);
      keep(distance);
    }
  });
  return all / kPairs;
}

}  // namespace batuta::report
