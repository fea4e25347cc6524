// SPDX-License-Identifier: MIT
#pragma once
// One beat: the left fencer's stick goes up the middle and back, the right fencer keeps the guard,
// and the blades meet once. The sticks report every 20 ms, a whole number of steps of each
// length in play.hpp, so that the hands are told to do the same whatever the step.

#include "play.hpp"

namespace batuta::report {

constexpr std::int32_t kReportUs = kLongestStepUs;  ///< from one report of a stick to the next
/// What the left stick reports, one report after the other, as shares of its reach. A
/// stick arrives at each report when the next one comes. The beat ends while both grips regain
/// control.
constexpr std::array<double, 5> kLeftReports = {0, 0, 0.06, 0.25, 0.06};
constexpr int kBeatReports = static_cast<int>(kLeftReports.size());

/// One of the beats: they differ in how far the stick goes, hence in the instant within a step at
/// which the blades meet.
struct BeatPlan {
  float reach = 0.5F;
};

/// @param number  0 <= number < count
inline BeatPlan beat_plan(std::uint64_t number, std::uint64_t count) {
  const double share = (static_cast<double>(number) + 0.5) / static_cast<double>(count);
  return {static_cast<float>(1.0 + 0.2 * share)};
}

/// The k-th report of the left stick, at k kReportUs.
inline InputSample left_report(const BeatPlan& plan, int k) {
  InputSample sample;
  sample.time = static_cast<Microseconds>(k) * static_cast<Microseconds>(kReportUs);
  sample.sequence = static_cast<std::uint32_t>(k);
  sample.y = plan.reach * static_cast<float>(kLeftReports[static_cast<std::size_t>(k)]);
  return sample;
}

/// Plays the beat; calls `after_step` after each step.
template <class PlayT, class AfterStep>
void play_beat(PlayT& duel, const BeatPlan& plan, AfterStep&& after_step) {
  const int steps = kReportUs / duel.step_us();  // from one report to the next
  for (int i = 0; i < kBeatReports * steps; ++i) {
    const InputSample left = left_report(plan, i / steps);
    InputSample right = left;
    right.y = 0;
    const bool fresh = i % steps == 0;
    duel.step(fresh ? &left : nullptr, fresh ? &right : nullptr);
    after_step();
  }
}

}  // namespace batuta::report
