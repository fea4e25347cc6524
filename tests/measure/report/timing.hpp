// SPDX-License-Identifier: MIT
#pragma once
// Times of this host that mean something elsewhere: as multiples of one plain segment-segment
// distance in double, measured in the same run.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

#include "batuta/geometry/segment.hpp"

namespace batuta::report {

/// Makes the compiler believe that the value is used.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

constexpr std::size_t kBatches = 5;
using Batches = std::array<double, kBatches>;

/// Times of one call in kBatches batches, ns; a batch is `calls` calls.
template <class Call>
Batches batches_ns(int calls, Call&& call) {
  using Clock = std::chrono::steady_clock;
  Batches batches{};
  for (double& batch : batches) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) call();
    batch = std::chrono::duration<double, std::nano>(Clock::now() - start).count() / calls;
  }
  return batches;
}

/// The middle one.
double median(Batches batches);

/// Median over kBatches batches of the time of one call, ns; a batch is `calls` calls.
template <class Call>
double median_ns(int calls, Call&& call) {
  return median(batches_ns(calls, call));
}

/// A time that others are measured in, and whether this thread had the host to itself meanwhile.
struct Baseline {
  double ns = 0;      ///< median of the batches
  double spread = 0;  ///< the median over the fastest batch, less 1
  double waited = 0;  ///< share of the time in which the thread did not run

  /// Batches of the same work took as long as each other, and no other program was let in.
  bool is_calm() const { return spread <= 0.1 && waited <= 0.02; }
};

/// @param spent, ran  s on the clock, and of it s in which the thread ran
Baseline baseline_of(const Batches& batches, double spent, double ran);

/// Time for which the calling thread has run, s.
double thread_seconds();

/// batches_ns() with what tells a busy host.
template <class Call>
Baseline baseline_ns(int calls, Call&& call) {
  using Clock = std::chrono::steady_clock;
  const double ran = thread_seconds();
  const auto start = Clock::now();
  const Batches batches = batches_ns(calls, call);
  const double spent = std::chrono::duration<double>(Clock::now() - start).count();
  return baseline_of(batches, spent, thread_seconds() - ran);
}

/// A measurement, repeated while it is not calm and there are tries left; the calmest one of them.
/// @param tries  to begin with, for a whole program: on a busy host no number of them is enough
template <class Measure>
Baseline calmest(int& tries, Measure&& measure) {
  Baseline best = measure();
  for (; tries > 0 && !best.is_calm(); --tries) {
    const Baseline next = measure();
    if (next.is_calm() || next.spread + next.waited < best.spread + best.waited) best = next;
  }
  return best;
}

/// Distance of two segments as collision textbooks compute it: the parameter on A for infinite
/// lines, clamped; then that on B, clamped; then A again. Not robust: a yardstick of time only.
double plain_segment_distance(const Segment<double>& A, const Segment<double>& B);

/// Median time of one plain_segment_distance(), ns, over a fixed set of pairs. Takes some
/// milliseconds: ask for it anew beside every group of measurements, for hosts change their pace.
/// Every one is counted in baselines().
double plain_ns();
/// From now on plain_ns() takes an eighth of its time and does not try again on a busy host: where
/// no time is looked at.
void measure_roughly();

/// How the plain_ns() of this program went. What is measured in one that is not calm means nothing.
struct BaselineCount {
  std::uint64_t all = 0;
  std::uint64_t disturbed = 0;  ///< not calm in any try
};
BaselineCount baselines();

}  // namespace batuta::report
