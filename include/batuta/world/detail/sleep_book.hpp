// SPDX-License-Identifier: MIT
#pragma once
// Who sleeps (SceneOptions::sleep; src/world/world.md, "Sleep"): a body in contact that has stayed
// within a distance of one place for a number of steps. Speed is not asked for: a body that rests
// on a gap falls and is stopped again and again, within that gap.

#include <array>

#include "batuta/mechanics/body.hpp"
#include "batuta/world/scene.hpp"

namespace batuta::detail {

template <class SceneT>
class SleepBook {
  using Scalar = typename SceneT::Scalar;

 protected:
  bool sleeps(std::size_t slot) const { return rests_[slot].asleep; }
  void fall_asleep(std::size_t slot) { rests_[slot].asleep = true; }
  /// It goes on from its place: if it stays there, it sleeps again at the end of the step.
  void wake(std::size_t slot) {
    rests_[slot].woken = rests_[slot].woken || rests_[slot].asleep;
    rests_[slot].asleep = false;
  }
  /// Whether it woke since this was asked last.
  bool has_woken(std::size_t slot) {
    const bool woken = rests_[slot].woken;
    rests_[slot].woken = false;
    return woken;
  }
  /// It is some time before it may sleep again.
  void rouse(std::size_t slot) {
    rests_[slot].quiet_steps = 0;
    rests_[slot].asleep = false;
  }
  /// Awake, and from here.
  void start_over(std::size_t slot, const Pose<Scalar>& X_WB) {
    rests_[slot] = {X_WB, 0, false, false};
  }
  const Pose<Scalar>& anchor(std::size_t slot) const { return rests_[slot].anchor; }
  /// One more step at the anchor. @returns whether there were enough of them
  bool is_quiet_for_long(std::size_t slot) {
    std::uint16_t& quiet = rests_[slot].quiet_steps;
    if (quiet < SceneT::kSleepSteps) ++quiet;
    return quiet >= SceneT::kSleepSteps;
  }
  void copy_sleep(const SleepBook& other) { *this = other; }
  template <class Archive>
  void archive_sleep(Archive& ar) {
    for (Rest& rest : rests_) ar(rest.anchor, rest.quiet_steps, rest.asleep);  // Bound: kMaxBodies
  }

 private:
  struct Rest {
    Pose<Scalar> anchor;
    std::uint16_t quiet_steps = 0;
    bool asleep = false;
    bool woken = false;  ///< in this step
  };
  std::array<Rest, static_cast<std::size_t>(SceneT::kMaxBodies)> rests_{};
};

template <class SceneT>
struct NoSleep {
  static constexpr bool sleeps(std::size_t /*slot*/) { return false; }
  void rouse(std::size_t /*slot*/) {}
  void copy_sleep(const NoSleep& /*other*/) {}
  template <class Archive>
  void archive_sleep(Archive& /*ar*/) {}
};

template <class SceneT>
using SleepOf = std::conditional_t<SceneT::kSleep, SleepBook<SceneT>, NoSleep<SceneT>>;

}  // namespace batuta::detail
