// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include <algorithm>

namespace batuta::peers {

namespace {

constexpr int kSamples = 512;
constexpr int kSamplesUntil = 128;

}  // namespace

Truth::Truth(const MovingCapsule<float>& A, const MovingCapsule<float>& B) : reference_(A, B) {
  const double S = reference_.scale();
  noise_ = 2 * reference_.rounding() / S;
  const test::March<double> march = reference_.march(noise_ * S);
  if (march.verdict == test::Verdict::kUnknown) return;
  known_ = true;
  const double least = reference_.least_gap(0, reference_.duration(), kSamples).gap;
  if (march.verdict == test::Verdict::kFree) {
    depth_ = std::min(-least / S, 0.0);
    return;
  }
  contact_time_ = march.t_free;
  const double after = reference_.least_gap_after(march.t_free, kSamples).gap;
  depth_ = -std::min(least, after) / S;
}

double Truth::depth_until(double t) const {
  if (t <= contact_time_) return 0;
  return -reference_.least_gap(contact_time_, t, kSamplesUntil).gap / reference_.scale();
}

namespace {

/// How deep the pair is when the caller stops.
void judge_lateness(Tally& tally, const Truth& truth, double t) {
  const double depth = truth.depth_until(t);
  if (depth > kDeep) ++tally.late_deep;
  if (depth > kSlight) ++tally.late_touching;
}

/// Only where there is something to be early or late for.
void judge_time(Tally& tally, const Truth& truth, double t) {
  if (truth.depth() <= kSlight) return;
  const double error = (t - truth.contact_time()) / truth.duration();
  const bool late = error > 0 && truth.depth_until(t) > truth.noise();
  (late ? tally.late : tally.early).add(late ? error : std::max(-error, 0.0));
}

}  // namespace

void judge(Tally& tally, const Truth& truth, const PeerAnswer& answer) {
  const bool deep = truth.depth() > kDeep;
  const bool touching = truth.depth() > kSlight;
  ++tally.queries;
  tally.deep += deep;
  tally.touching += touching;
  if (answer.gave_up) {
    ++tally.gave_up;
    tally.gave_up_deep += deep;
    if (answer.contact && touching) judge_lateness(tally, truth, answer.t);
    return;
  }
  if (!answer.contact) {
    tally.missed_deep += deep;
    tally.missed_touching += touching;
    return;
  }
  if (truth.depth() < -kFar) ++tally.false_far;
  if (truth.depth() < -kNear) ++tally.false_near;
  if (touching) judge_lateness(tally, truth, answer.t);
  judge_time(tally, truth, answer.t);
}

}  // namespace batuta::peers
