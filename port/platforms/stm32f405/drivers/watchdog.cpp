// SPDX-License-Identifier: MIT

#include "platforms/stm32f405/drivers/watchdog.hpp"

namespace batuta::stm32f405 {
namespace {

/// New values take up to 5 LSI periods (RM0090 21.4.4), 300 us; a turn takes more than 4 cycles of
/// 168 MHz.
constexpr int kReloadTurns = 100000;

}  // namespace

void Watchdog::start() {
  at_.kr = Iwdg::kKrStart;  // also starts the LSI, without which the values below never arrive
  at_.kr = Iwdg::kKrUnlock;
  at_.pr = 0;  // divided by kWatchdogDivider
  at_.rlr = kWatchdogCounts - 1U;
  for (int i = 0; i < kReloadTurns && (at_.sr & Iwdg::kSrBusy) != 0; ++i) {  // Bound: kReloadTurns
  }
  at_.kr = Iwdg::kKrFeed;  // takes the new values over
}

}  // namespace batuta::stm32f405
