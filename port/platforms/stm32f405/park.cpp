// SPDX-License-Identifier: MIT

#include "platforms/stm32f405/park.hpp"

#include "platforms/stm32f405/board.hpp"
#include "platforms/stm32f405/drivers/watchdog.hpp"
#include "platforms/stm32f405/memory_map.hpp"

namespace batuta::stm32f405 {
namespace {

/// About 0.2 s at 16 MHz; the watchdog is fed every 2 ms of it.
void wait_for_eye() {
  constexpr int kFeeds = 100;
  constexpr int kTurns = 6000;
  for (int feed = 0; feed < kFeeds; ++feed) {  // Bound: kFeeds
    iwdg().kr = Iwdg::kKrFeed;
    for (int i = 0; i < kTurns; ++i) __asm volatile("");  // Bound: kTurns
  }
}

constexpr std::uint32_t kPin = 1U << kLightPin;
constexpr std::uint32_t kLow = kPin << 16;  // in BSRR the upper half clears

/// @param light  kLow: on for half of the time; kPin: dark
void blink(std::uint32_t light) {
  gpioc().bsrr = light;
  wait_for_eye();
  gpioc().bsrr = kPin;
  wait_for_eye();
}

}  // namespace

void park(std::uint32_t code) {
  constexpr std::uint32_t kPauseBlinks = 5;
  for (;;) {                                               // Bound: none; here is where it stays
    for (std::uint32_t i = 0; i < code; ++i) blink(kLow);  // Bound: code
    for (std::uint32_t i = 0; i < kPauseBlinks; ++i) blink(kPin);  // Bound: kPauseBlinks
  }
}

}  // namespace batuta::stm32f405
