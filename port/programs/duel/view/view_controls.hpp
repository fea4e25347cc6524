// SPDX-License-Identifier: MIT
#pragma once
// What a viewer wants of the bout, from the thread of the window to that of the steps. Neither
// waits for the other.

#include <atomic>
#include <cstdint>

namespace batuta::host {

/// How a viewer ends a bout.
enum class ViewWish : std::uint8_t { kNone, kRestart, kQuit };

class ViewControls {
 public:
  static constexpr int kQuarter = 4;     ///< slowness
  static constexpr int kTwentieth = 20;  ///< slowness

  // The window's thread. A device that steps by itself waits for no viewer: nothing but a wish then
  // changes anything.
  void toggle_pause() {
    if (!device_keeps_time()) paused_ = !paused_;
  }
  /// One step more; a bout that runs is paused.
  void single_step() {
    if (device_keeps_time()) return;
    if (paused_) ++steps_;
    paused_ = true;
  }
  /// @param slowness  1: as it happens; 4: a quarter of that speed ...
  void slow_down(int slowness) {
    if (!device_keeps_time()) slowness_ = slowness;
  }
  void wish(ViewWish wish) { wish_ = wish; }

  // The bout's thread.
  /// Before the first step of a bout. @param device_keeps_time  it makes its steps by itself
  void begin(bool device_keeps_time) {
    device_keeps_time_ = device_keeps_time;
    if (device_keeps_time) {
      paused_ = false;
      slowness_ = 1;
    }
    steps_ = 0;
    ViewWish fulfilled = ViewWish::kRestart;
    wish_.compare_exchange_strong(fulfilled, ViewWish::kNone);  // no other wish gets lost
  }
  /// Whether a single step was asked for, once for each.
  bool take_step() {
    if (steps_ == 0) return false;
    --steps_;
    return true;
  }

  // Both.
  bool is_paused() const { return paused_; }
  int slowness() const { return slowness_; }
  ViewWish wish() const { return wish_; }
  bool device_keeps_time() const { return device_keeps_time_; }

 private:
  std::atomic<bool> paused_{false};
  std::atomic<bool> device_keeps_time_{false};
  std::atomic<int> slowness_{1};
  std::atomic<std::uint32_t> steps_{0};
  std::atomic<ViewWish> wish_{ViewWish::kNone};
};

}  // namespace batuta::host
