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
  bool is_lost() const override { return lost_; }

 private:
  void run();
  void draw_until_end(SDL_Renderer* renderer);
  /// Of the window's thread: its library gives the program up, and it gets no further.
  void lose_window();
  /// Reads keys until the next picture is due.
  void wait_until(std::uint64_t due);
  void take(const SDL_Event& event);
  void press(const SDL_KeyboardEvent& key);

  std::promise<std::string> opened_;
  bool is_open_ = false;  ///< of the window's thread: opened_ is fulfilled
  Latest<ViewState> latest_;
  ViewScreen screen_;  ///< of the window's thread
  std::atomic<std::uint32_t> pictures_{0};
  std::atomic<bool> ending_{false};
  std::atomic<bool> lost_{false};
  std::atomic<bool> left_{false};  ///< the window's thread touches nothing of this any more
  std::thread thread_;             // the last member: it ends before what it uses
};

}  // namespace batuta::host
