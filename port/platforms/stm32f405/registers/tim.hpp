// SPDX-License-Identifier: MIT
#pragma once
// Timers: RM0090 sections 17.4 (TIM8), 18.4 (TIM3) and 20.4 (TIM7). One layout; the simpler timers
// leave registers out.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct Tim {
  volatile std::uint32_t cr1;
  volatile std::uint32_t cr2;
  volatile std::uint32_t smcr;
  volatile std::uint32_t dier;
  volatile std::uint32_t sr;
  volatile std::uint32_t egr;
  volatile std::uint32_t ccmr1;
  volatile std::uint32_t ccmr2;
  volatile std::uint32_t ccer;
  volatile std::uint32_t cnt;
  volatile std::uint32_t psc;
  volatile std::uint32_t arr;
  volatile std::uint32_t rcr;
  volatile std::uint32_t ccr[4];
  volatile std::uint32_t bdtr;

  static constexpr std::uint32_t kCr1Cen = 1U << 0;
  static constexpr std::uint32_t kCr1Udis = 1U << 1;
  static constexpr std::uint32_t kCr1Arpe = 1U << 7;
  static constexpr std::uint32_t kCr2MmsUpdate = 2U << 4;  ///< TRGO at each update
  static constexpr std::uint32_t kDierUie = 1U << 0;
  static constexpr std::uint32_t kSrUif = 1U << 0;
  static constexpr std::uint32_t kSrBif = 1U << 7;
  static constexpr std::uint32_t kEgrUg = 1U << 0;
  /// Both channels of a CCMRx: PWM mode 1, compare values taken over at an update.
  static constexpr std::uint32_t kCcmrPwm1Both = (6U << 4) | (1U << 3) | (6U << 12) | (1U << 11);
  static constexpr std::uint32_t kCcerAllFour = (1U << 0) | (1U << 4) | (1U << 8) | (1U << 12);
  static constexpr std::uint32_t kBdtrLock2 = 2U
                                              << 8;  ///< break, idle levels, polarities, OSSI, OSSR
  static constexpr std::uint32_t kBdtrOssi = 1U << 10;  ///< without MOE, drive the idle level
  static constexpr std::uint32_t kBdtrOssr = 1U << 11;
  static constexpr std::uint32_t kBdtrBke = 1U << 12;
  static constexpr std::uint32_t kBdtrMoe = 1U << 15;
};
static_assert(offsetof(Tim, ccmr1) == 0x18 && offsetof(Tim, cnt) == 0x24, "RM0090 17.4");
static_assert(offsetof(Tim, rcr) == 0x30 && offsetof(Tim, bdtr) == 0x44, "RM0090 17.4");

}  // namespace batuta::stm32f405
