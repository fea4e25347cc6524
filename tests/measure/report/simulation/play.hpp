// SPDX-License-Identifier: MIT
#pragma once
// A duel of the library's two fencers in steps of one length, with what it costs.

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "batuta/fencing/duel.hpp"
#include "section.hpp"

namespace batuta::report {
using namespace fencing;

/// All step lengths of this section divide the longest one: places are compared whenever it is
/// over.
constexpr std::int32_t kLongestStepUs = 20000;

/// The lengths of steps, us, the shortest first.
inline std::vector<std::int32_t> step_lengths(Mode mode) {
  if (mode == Mode::kTiny) return {2000, 4000, 10000, kLongestStepUs};
  return {100, 200, 400, 1000, 2000, 4000, 10000, kLongestStepUs};
}

/// Tips of the left and the right blade in W, m.
using Tips = std::array<Vec3<double>, 2>;

/// The larger distance of the two tips from where they should be, m.
inline double tip_error(const Tips& tips, const Tips& truth) {
  return std::max((tips[0] - truth[0]).norm(), (tips[1] - truth[1]).norm());
}

/// An impulse between the blades.
struct Blow {
  double time = 0;     ///< since the start, s
  double impulse = 0;  ///< N s
};

template <class ScalarT, class SearchT>
class Play {
 public:
  using Scalar = ScalarT;
  using Search = SearchT;
  using Scene = DuelScene<two_fencers, Search>;

  explicit Play(std::int32_t step_us) : step_us_(step_us) {
    auto settings = duel_settings<Scene>();
    settings.step_us = step_us;
    const Status status =
        duel_->configure(settings, first_fencer<Scalar>(), second_fencer<Scalar>());
    BATUTA_ASSERT(status == Status::kOk);
  }

  /// @param left, right  fresh samples, or null
  void step(const InputSample* left, const InputSample* right) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const Status status = duel_->step(left, right);
    ns_ += std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    if (status == Status::kOk) note_blows();
  }

  std::int32_t step_us() const { return step_us_; }
  std::int64_t now_us() const { return std::int64_t{step_us_} * duel_->steps(); }
  /// The longest step is over: time to compare places.
  bool at_mark() const { return now_us() % kLongestStepUs == 0; }
  const Duel<Scene>& duel() const { return *duel_; }
  const std::vector<Blow>& blows() const { return blows_; }
  /// Host time of all steps, ns.
  double ns() const { return ns_; }

  Tips tips() const {
    return {duel_->blade_W(Side::kLeft).axis.b.template cast<double>(),
            duel_->blade_W(Side::kRight).axis.b.template cast<double>()};
  }

 private:
  void note_blows() {
    const double start = 1e-6 * static_cast<double>(now_us() - step_us_);
    for (const auto& event : duel_->world().events()) {
      if (!(event.impulse > Scalar(0))) continue;
      blows_.push_back(
          {start + static_cast<double>(event.time), static_cast<double>(event.impulse)});
    }
  }

  std::int32_t step_us_;
  std::unique_ptr<Duel<Scene>> duel_ = std::make_unique<Duel<Scene>>();
  std::vector<Blow> blows_;
  double ns_ = 0;
};

template <class Scalar>
constexpr const char* scalar_name() {
  return std::is_same_v<Scalar, float> ? "float" : "double";
}
template <class Search>
constexpr const char* search_name() {
  return Search::kHasContactTolerance ? "advancement" : "stepping";
}

/// Names a Play as an argument.
template <class PlayT>
struct Kind {
  using Type = PlayT;
};

/// Calls `use` with the Kind of each Play: both scalars, both searches that a duel is built with.
template <class Use>
void for_each_play(Use&& use) {
  use(Kind<Play<float, Advancement<float>>>{});
  use(Kind<Play<double, Advancement<double>>>{});
  use(Kind<Play<float, Stepping<float>>>{});
  use(Kind<Play<double, Stepping<double>>>{});
}

}  // namespace batuta::report
