// SPDX-License-Identifier: MIT
#pragma once
// The window of --view, as the bout sees it: it is handed the latest state and never waited for.

#include <chrono>
#include <cstdio>
#include <memory>

#include "programs/duel/observer.hpp"
#include "programs/duel/view/view_screen.hpp"

namespace batuta::host {

class View {
 public:
  View() = default;
  View(const View&) = delete;
  View& operator=(const View&) = delete;
  virtual ~View() = default;

  /// Returns at once: what was shown before and not drawn yet is replaced. Allocates nothing.
  virtual void show(const ViewState& state) = 0;
  /// Drawn so far.
  virtual std::uint32_t pictures() const { return 0; }
  /// Whether its window went with the display: nobody sees or presses anything, and the viewer's
  /// wish is to quit.
  virtual bool is_lost() const { return false; }
  ViewControls& controls() { return controls_; }
  const ViewControls& controls() const { return controls_; }

 private:
  ViewControls controls_;
};

struct OpenedView {
  std::unique_ptr<View> view;  ///< null if there is no window
  std::string error;           ///< why not, in one line
};

/// Where the program is built without SDL, an error that says so.
OpenedView open_view(const ViewNames& names);

/// Shows a bout step by step, and tells at its end how often it was drawn.
class ViewObserver final : public Observer {
 public:
  /// @param feed  counts the bouts; both outlive this
  /// @param out  for people, or null
  ViewObserver(View& view, ViewFeed& feed, std::FILE* out) : view_(view), feed_(feed), out_(out) {}

  void on_start(const DuelRunner& runner) override {
    start_ = std::chrono::steady_clock::now();
    first_picture_ = view_.pictures();
    feed_.begin(runner.duel(), runner.bout().forces());
    view_.show(feed_.state());
  }
  void on_step(const DuelRunner& runner) override {
    feed_.add_step(runner.duel(), runner.bout().forces());
    view_.show(feed_.state());
  }
  void on_end(const DuelRunner& /*runner*/) override {
    feed_.end();
    view_.show(feed_.state());
    if (out_ == nullptr) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    std::fprintf(out_, "view   pictures %u in %.2f s\n", view_.pictures() - first_picture_,
                 spent.count());
  }

 private:
  View& view_;
  ViewFeed& feed_;
  std::FILE* out_;
  std::uint32_t first_picture_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace batuta::host
