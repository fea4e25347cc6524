// SPDX-License-Identifier: MIT
#pragma once
// The independent watchdog, and who may feed it: the 1 kHz loop, when a tick's work is done and the
// force guard's interrupt has run since the last time. A loop that hangs, a loop that idles, and a
// guard that is dead each end in a reset, and a reset takes the force away.

#include "platforms/stm32f405/registers/iwdg.hpp"

namespace batuta::stm32f405 {

/// LSI, Hz: what the part is sold with (data sheet, LSI).
inline constexpr std::uint32_t kLsiSlowestHz = 17000;
inline constexpr std::uint32_t kLsiFastestHz = 47000;

/// The watchdog counts LSI / 4; this many counts to a reset.
inline constexpr std::uint32_t kWatchdogDivider = 4;
inline constexpr std::uint32_t kWatchdogCounts = 80;

constexpr std::uint32_t watchdog_us(std::uint32_t lsi_hz) {
  return kWatchdogCounts * kWatchdogDivider * 1000000U / lsi_hz;
}
static_assert(watchdog_us(kLsiFastestHz) >= 6000, "the loop may lose five ticks, not six");
static_assert(watchdog_us(kLsiSlowestHz) <= 20000, "force lives 20 ms at most after a hang");

/// Decides; knows no register.
class WatchdogPolicy {
 public:
  /// A tick's work is done, with or without a step. @param guard_ticks  of the force guard, since
  /// the start
  /// @returns true: feed
  bool on_tick(std::uint32_t guard_ticks) {
    const bool guard_alive = guard_ticks != last_ticks_;
    last_ticks_ = guard_ticks;
    starved_ += guard_alive ? 0U : 1U;
    return guard_alive;
  }

  /// Ticks that did not feed.
  std::uint32_t starved() const { return starved_; }

 private:
  std::uint32_t last_ticks_ = 0;
  std::uint32_t starved_ = 0;
};

class Watchdog {
 public:
  explicit Watchdog(Iwdg& registers) : at_(registers) {}

  /// Cannot be undone but by a reset. Bound: kReloadTurns.
  void start();
  /// A tick's work is done: feeds, or lets starve.
  void on_tick(std::uint32_t guard_ticks) {
    if (policy_.on_tick(guard_ticks)) at_.kr = Iwdg::kKrFeed;
  }

  const WatchdogPolicy& policy() const { return policy_; }

 private:
  Iwdg& at_;
  WatchdogPolicy policy_;
};

}  // namespace batuta::stm32f405
