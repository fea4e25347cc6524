// SPDX-License-Identifier: MIT
#pragma once
// The types of random scenes, and what a run of one of them breaks.

#include <utility>

#include "random_scenes.hpp"
#include "six_laws.hpp"

namespace batuta::test {

using Rests = RestingContact;
// resting, gravity, sleep, is_led, is_tight, turns, is_small, bodies, parts
inline constexpr RandomKind kHeap = {
    Rests::kSettling, true, true, false, false, true, false, 40, 2};
inline constexpr RandomKind kDrift = {
    Rests::kSettling, false, false, false, false, true, false, 12, 3};
inline constexpr RandomKind kCramped = {
    Rests::kSettling, true, false, false, true, true, false, 40, 1};
inline constexpr RandomKind kHands = {
    Rests::kSettling, true, true, true, false, true, false, 12, 2};
inline constexpr RandomKind kPaper = {
    Rests::kSeparation, false, false, false, false, true, false, 12, 2};
inline constexpr RandomKind kPaperLed = {
    Rests::kSeparation, true, false, true, false, true, false, 8, 1};
inline constexpr RandomKind kPaperCramped = {
    Rests::kSeparation, true, false, false, true, true, false, 12, 2};
inline constexpr RandomKind kBlows = {Rests::kNone, false, false, false, false, true, false, 40, 1};
inline constexpr RandomKind kBlowsCramped = {Rests::kNone, true,  false, false, true,
                                             true,         false, 12,    2};
inline constexpr RandomKind kBlowsLed = {Rests::kNone, true,  false, true, false,
                                         true,         false, 12,    1};
inline constexpr RandomKind kStraight = {Rests::kNone, true,  false, false, false,
                                         false,        false, 12,    1};
inline constexpr RandomKind kSmallBalls = {Rests::kNone, true, false, false, false,
                                           false,        true, 8,     1};
inline constexpr RandomKind kSmallCramped = {Rests::kNone, false, false, false, true,
                                             false,        true,  8,     1};

/// A breach, and when it was.
struct Found {
  Breach breach;
  int step = 0;
};

/// What breaks in a run. Bound: steps.
template <class SceneT>
std::vector<Found> run_scene(RandomRun<SceneT>& run, int steps) {
  std::vector<Found> found;
  Seen before = run.seen();
  for (int i = 0; i < steps; ++i) {
    if (run.step() != Status::kOk) found.push_back({{"finite", "a step is refused", 0, 0}, i});
    Seen after = run.seen();
    const Told told = told_by(std::as_const(run.world()), run.dt(), run.gravity());
    for (const Breach& breach : broken_laws(before, after, told)) found.push_back({breach, i});
    before = std::move(after);
  }
  return found;
}

/// Contacts of the last step: answered, and those that began to last.
template <class SceneT>
int contacts_of(RandomRun<SceneT>& run) {
  int begun = static_cast<int>(run.world().report().collisions);
  if constexpr (SceneT::kMaxEvents > 0) begun += run.world().events().size();
  return run.world().report().complete() ? begun : 3;
}

/// Law 1: the same scene at rest and flying along. Compared until the third contact, because each
/// amplifies rounding; and only where nothing holds anybody.
/// @returns how far relative places went apart beyond what may be: at most 0
template <class SceneT>
Real frame_breach(const Choices& choices, int steps) {
  const Vec3<double> V(25, 0, 0);
  RandomRun<SceneT> rests{choices};
  RandomRun<SceneT> flies{choices, V};
  if (!rests.is_closed()) return 0;
  const Real u = kRoundOff<typename SceneT::Scalar>;
  const Real share = u > 1e-10L ? 1e-5L : 1e-10L;
  const Seen start = rests.seen();
  Real worst = 0;
  int contacts = 0;
  for (int i = 0; i < steps; ++i) {
    if (rests.step() != Status::kOk || flies.step() != Status::kOk) return 1;
    contacts += contacts_of(rests) + contacts_of(flies);
    if (contacts >= 3) break;
    const Seen one = rests.seen();
    const Seen other = flies.seen();
    const Real way = 25 * rests.dt() * (i + 1);
    for (std::size_t k = 1; k < one.size(); ++k) {
      const Real3 off = (one[k].x - one[0].x) - (other[k].x - other[0].x);
      // Each step rounds two places in each of both.
      const Real rounding = 8 * u * (one[k].x.norm() + one[0].x.norm() + way) * (i + 1);
      worst = std::max(worst, off.norm() - share * way - rounding);
    }
  }
  return worst;
}
}  // namespace batuta::test
