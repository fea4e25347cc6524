// SPDX-License-Identifier: MIT
#include "timing.hpp"

#include <time.h>

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

/// What a program spends on its baselines.
struct Effort {
  int passes = 8;  ///< over all pairs, in a batch
  /// Further tries for a calm one, in all: a rented host is interrupted a few times a second, and a
  /// try takes some 20 ms.
  int tries = 2048;
};

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

Effort& effort() {
  static Effort effort;
  return effort;
}

BaselineCount& counted() {
  static BaselineCount count;
  return count;
}

}  // namespace

double median(Batches batches) {
  std::sort(batches.begin(), batches.end());
  return batches[kBatches / 2];
}

Baseline baseline_of(const Batches& batches, double spent, double ran) {
  Baseline baseline;
  baseline.ns = median(batches);
  const double fastest = *std::min_element(batches.begin(), batches.end());
  baseline.spread = fastest > 0 ? baseline.ns / fastest - 1 : 0;
  baseline.waited = spent > 0 ? std::max(0.0, 1 - ran / spent) : 0;
  return baseline;
}

double thread_seconds() {
  timespec ran{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &ran) != 0) return 0;
  return static_cast<double>(ran.tv_sec) + 1e-9 * static_cast<double>(ran.tv_nsec);
}

BaselineCount baselines() {
  return counted();
}

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

void measure_roughly() {
  effort() = {1, 0};
}

double plain_ns() {
  static const std::array<SegmentPair, kPairs> pairs = make_pairs();
  const Baseline all = calmest(effort().tries, [] {
    return baseline_ns(effort().passes, [] {
      for (const SegmentPair& pair : pairs) {
        const double distance = plain_segment_distance(pair.A, pair.B);
        keep(distance);
      }
    });
  });
  ++counted().all;
  if (!all.is_calm()) ++counted().disturbed;
  return all.ns / kPairs;
}

}  // namespace batuta::report
