// SPDX-License-Identifier: MIT
#pragma once
// Times of this host that mean something elsewhere: as multiples of one plain segment-segment
// distance in double, measured in the same run.

#include <algorithm>
#include <array>
#include <chrono>

#include "batuta/geometry/segment.hpp"

namespace batuta::report {

/// Makes the compiler believe that the value is used.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// Median over kBatches batches of the time of one call, ns; a batch is `calls` calls.
template <class Call>
double median_ns(int calls, Call&& call) {
  constexpr std::size_t kBatches = 5;
  using Clock = std::chrono::steady_clock;
  std::array<double, kBatches> batches{};
  for (double& batch : batches) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) call();
    batch = std::chrono::duration<double, std::nano>(Clock::now() - start).count() / calls;
  }
  std::sort(batches.begin(), batches.end());
  return batches[kBatches / 2];
}

/// Distance of two segments as collision textbooks compute it: the parameter on A for infinite
/// lines, clamped; then that on B, clamped; then A again. Not robust: a yardstick of time only.
double plain_segment_distance(const Segment<double>& A, const Segment<double>& B);

/// Median time of one plain_segment_distance(), ns, over a fixed set of pairs. Takes about a
/// millisecond: ask for it anew beside every group of measurements, for hosts change their pace.
double plain_ns();

}  // namespace batuta::report
