// SPDX-License-Identifier: MIT
#pragma once
// The window of --view through SDL. A thread of its own opens it, reads its keys and draws the
// latest state 60 times a second; the thread of the bout only leaves the state there.

#include <atomic>
#include <future>
#include <thread>

#include "programs/duel/view/sdl_window.hpp"
#include "programs/duel/view/view.hpp"
#include "programs/live/latest.hpp"

namespace batuta::host {

class SdlView final : public View {
 public:
  static constexpr int kPicturesPerSecond = 60;

  explicit SdlView(const ViewNames& names);
  ~SdlView() override;

  /// To be called once. Waits for the window. @returns empty | why there is none
  std::string open() { return opened_.get_future().get(); }
  void show(const ViewState& state) override { latest_.put(state); }
  std::uint32_t pictures() const override { return pictures_; }

 private:
  void run();
  /// Reads keys until the next picture is due.
  void wait_until(std::uint64_t due);
  void take(const SDL_Event& event);
  void press(const SDL_KeyboardEvent& key);

  std::promise<std::string> opened_;
  Latest<ViewState> latest_;
  ViewScreen screen_;  ///< of the window's thread
  std::atomic<std::uint32_t> pictures_{0};
  std::atomic<bool> ending_{false};
  std::thread thread_;  // the last member: it ends before what it uses
};

}  // namespace batuta::host
