// SPDX-License-Identifier: MIT
#pragma once
// How random scenes run: what random_kinds.hpp promises. Included by the files that compile it, one
// for each rule of resting contact.

#include <utility>

#include "batuta/core/config.hpp"
#include "random_kinds.hpp"
#include "random_scenes.hpp"

namespace batuta::test {

/// Adds a step to what a scene did.
template <class SceneT>
void count_step(Happened& happened, const World<SceneT>& world) {
  const auto& report = world.report();
  happened.collisions += static_cast<int>(report.collisions);
  happened.separations += static_cast<int>(report.separations);
  happened.overlaps += static_cast<int>(report.overlaps_at_start);
  happened.frozen += static_cast<int>(report.frozen);
  happened.held += report.time_held > 0 ? 1 : 0;
  happened.cut += report.complete() ? 0 : 1;
  happened.asleep += static_cast<int>(report.asleep);
}

/// What breaks in a run. Bound: steps.
template <class SceneT>
Ran run_scene(RandomRun<SceneT>& run, int steps) {
  Ran ran;
  Seen before = run.seen();
  for (int i = 0; i < steps; ++i) {
    const Status status = run.step();
    Seen after = run.seen();
    const Told told = told_by(std::as_const(run.world()), run.dt(), run.gravity());
    if (status != Status::kOk)
      ran.found.push_back({{"finite", "a step is refused", 0, 0}, i, told, {}});
    const std::vector<Breach> broken = broken_laws(before, after, told);
    const Terms terms = broken.empty() ? Terms{} : terms_of(before, after, told);
    // Bound: the laws, and pairs.
    for (const Breach& breach : broken) ran.found.push_back({breach, i, told, terms});
    count_step(ran.happened, std::as_const(run.world()));
    before = std::move(after);
  }
  return ran;
}

/// Contacts of the last step: answered, and those that began to last.
template <class SceneT>
int contacts_of(RandomRun<SceneT>& run) {
  int begun = static_cast<int>(run.world().report().collisions);
  if constexpr (SceneT::kMaxEvents > 0) begun += run.world().events().size();
  return run.world().report().complete() ? begun : 3;
}

template <class S, const RandomKind& kKind>
Ran RandomLaws<S, kKind>::run(const Choices& choices, int steps) {
  RandomRun<RandomScene<S, kKind>> scene{choices};
  return run_scene(scene, steps);
}

/// The same scene twice, at rest and flying along.
template <class SceneT>
class FramePair {
 public:
  explicit FramePair(const Choices& choices) : rests_{choices}, flies_{choices, {kSpeed, 0, 0}} {}

  bool is_closed() const { return rests_.is_closed(); }
  /// Contacts so far, of both.
  int contacts() const { return contacts_; }

  /// Makes a step of both.
  bool step() {
    const Seen one = rests_.seen();
    const Seen other = flies_.seen();
    if (rests_.step() != Status::kOk || flies_.step() != Status::kOk) return false;
    contacts_ += contacts_of(rests_) + contacts_of(flies_);
    add_gaps(rests_, one);
    add_gaps(flies_, other);
    opened_ += closing_;
    ++steps_;
    return true;
  }

  OffFrame breach() const {
    const Real u = kRoundOff<typename SceneT::Scalar>;
    const Real share = u > 1e-10L ? 1e-5L : 1e-10L;
    const Seen one = rests_.seen();
    const Seen other = flies_.seen();
    const Real way = kSpeed * rests_.dt() * steps_;
    Real worst = 0;
    for (std::size_t k = 1; k < one.size(); ++k) {
      const Real3 off = (one[k].x - one[0].x) - (other[k].x - other[0].x);
      // Each step rounds two places in each of both.
      const Real rounding = 8 * u * (one[k].x.norm() + one[0].x.norm() + way) * steps_;
      worst = std::max(worst, off.norm() - share * way - rounding);
    }
    return {worst, worst - opened_};
  }

 private:
  static constexpr double kSpeed = 25;

  void add_gaps(RandomRun<SceneT>& run, const Seen& before) {
    const Told told = told_by(std::as_const(run.world()), run.dt(), run.gravity());
    const Terms terms = terms_of(before, run.seen(), told);
    opened_ += terms.opening;
    closing_ += terms.closing;
  }

  RandomRun<SceneT> rests_;
  RandomRun<SceneT> flies_;
  int contacts_ = 0;
  int steps_ = 0;
  Real opened_ = 0;
  Real closing_ = 0;  ///< in a step
};

template <class S, const RandomKind& kKind>
OffFrame RandomLaws<S, kKind>::frame_breach(const Choices& choices, int steps) {
  FramePair<RandomScene<S, kKind>> pair{choices};
  if (!pair.is_closed()) return {};
  OffFrame worst;
  // Bound: steps.
  for (int i = 0; i < steps; ++i) {
    if (!pair.step()) return {1, 1};
    if (pair.contacts() >= 3) break;
    const OffFrame now = pair.breach();
    worst.by = std::max(worst.by, now.by);
    worst.besides_gaps = std::max(worst.besides_gaps, now.besides_gaps);
  }
  return worst;
}

}  // namespace batuta::test

/// Compiles the scenes of a kind with each type of numbers that the library is built for.
#if BATUTA_WITH_DOUBLE
#define BATUTA_RANDOM_LAWS(kind)           \
  template struct RandomLaws<float, kind>; \
  template struct RandomLaws<double, kind>
#else
#define BATUTA_RANDOM_LAWS(kind) template struct RandomLaws<float, kind>
#endif
