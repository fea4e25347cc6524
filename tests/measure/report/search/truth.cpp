// SPDX-License-Identifier: MIT
#include "truth.hpp"

#include <cmath>

#include "batuta/detection/swept_volume.hpp"
#include "reference.hpp"

namespace batuta::report {

namespace {

using Reference = test::Reference<double>;

constexpr int kSamples = 256;   ///< for the least gap
constexpr int kHalvings = 100;  ///< of a double interval: to neighbouring numbers

/// The instant at which the gap changes its sign. @pre gap > 0 at `free` or just after, <= 0 at
/// `hit`
double crossing(const Reference& reference, double free, double hit) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = free + (hit - free) / 2;
    if (!(free < middle && middle < hit)) break;
    (reference.gap(middle) > 0 ? free : hit) = middle;
  }
  return hit;
}

/// The first of the instants t, t + 2^-60 duration, t + 2^-59 duration, ... at which there is
/// overlap; `known` if none of them is before it.
double first_overlap(const Reference& reference, double t, double known) {
  for (double later = std::ldexp(reference.duration(), -60); t + later < known; later *= 2) {
    if (reference.gap(t + later) <= 0) return t + later;
  }
  return known;
}

}  // namespace

Truth truth_of(const test::Query& query) {
  const Reference reference(query.A, query.B);
  const double at_start = reference.gap(0);
  if (at_start <= 0) return {true, 0, at_start};
  const auto march = reference.march(2 * reference.rounding());
  if (march.verdict == test::Verdict::kFree) {
    return {false, reference.duration(),
            reference.least_gap(0, reference.duration(), kSamples).gap};
  }
  const auto least = reference.least_gap_after(march.t_free, kSamples);
  if (least.gap > 0) return {false, reference.duration(), least.gap};
  const double overlap = first_overlap(reference, march.t_free, least.t);
  return {true, crossing(reference, march.t_free, overlap), least.gap};
}

Case case_of(const test::Query& query) {
  Case made{test::cast<double>(query.A), test::cast<double>(query.B), test::cast<float>(query.A),
            test::cast<float>(query.B), truth_of(query)};
  made.meets = overlaps(swept_aabb(made.A), swept_aabb(made.B));
  return made;
}

Case make_case(test::Family family, std::uint64_t seed, std::uint64_t index) {
  return case_of(test::make_query(family, seed, index));
}

}  // namespace batuta::report
