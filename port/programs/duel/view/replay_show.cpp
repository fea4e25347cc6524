// SPDX-License-Identifier: MIT

#include "programs/duel/view/replay_show.hpp"

#include "programs/duel/pacing.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

/// A recording holds no forces: they are computed anew, as a device would.
class ReplayShow final : public ReplayWatcher {
 public:
  ReplayShow(View& view, ViewFeed& feed)
      : view_(view), feed_(feed), pacing_(true, &view.controls()) {}

  void on_start(const DuelRunner::DuelType& duel) override {
    (void)forces_.configure({});  // kOk: they are the library's own
    note_life(duel);
    feed_.begin(duel, forces_);
    view_.show(feed_.state());
  }
  bool on_step(const DuelRunner::DuelType& duel) override {
    duel.feel(forces_, note_life(duel));
    feed_.add_step(duel, forces_);
    view_.show(feed_.state());
    return pacing_.wait();
  }

 private:
  /// @returns whose stick gave a sign of life, as SteppedBout finds it
  std::array<bool, 2> note_life(const DuelRunner::DuelType& duel) {
    std::array<bool, 2> alive{};
    for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
      const std::uint32_t used = duel.stick(side).report().used;
      alive[index_of(side)] = used != used_[index_of(side)];
      used_[index_of(side)] = used;
    }
    return alive;
  }

  View& view_;
  ViewFeed& feed_;
  Pacing pacing_;
  haptics::StickForces forces_;
  std::array<std::uint32_t, 2> used_{};
};

}  // namespace

Replay show_replay(const std::string& path, View& view, ViewFeed& feed) {
  Replay result;
  ViewWish wish = ViewWish::kRestart;
  while (wish == ViewWish::kRestart) {  // Bound: the patience of who watches
    view.controls().begin(false);
    ReplayShow show(view, feed);
    result = replay(path, &show);
    feed.end();
    view.show(feed.state());
    const bool seen = feed.state().bout > 0;
    wish = seen ? wait_for_wish(view.controls()) : ViewWish::kQuit;
  }
  return result;
}

}  // namespace batuta::host
