// SPDX-License-Identifier: MIT
#pragma once
// Reset and clock control: RM0090 section 7.3. Only the bits this port uses have a name.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct Rcc {
  volatile std::uint32_t cr;
  volatile std::uint32_t pllcfgr;
  volatile std::uint32_t cfgr;
  volatile std::uint32_t cir;
  volatile std::uint32_t reset[8];
  volatile std::uint32_t ahb1enr;
  volatile std::uint32_t ahb2enr;
  volatile std::uint32_t ahb3enr;
  volatile std::uint32_t reserved_3c;
  volatile std::uint32_t apb1enr;
  volatile std::uint32_t apb2enr;
  volatile std::uint32_t reserved_48[2];
  volatile std::uint32_t lpenr[6];
  volatile std::uint32_t reserved_68[2];
  volatile std::uint32_t bdcr;
  volatile std::uint32_t csr;

  static constexpr std::uint32_t kCrHsirdy = 1U << 1;
  static constexpr std::uint32_t kCrHseon = 1U << 16;
  static constexpr std::uint32_t kCrHserdy = 1U << 17;
  static constexpr std::uint32_t kCrCsson = 1U << 19;
  static constexpr std::uint32_t kCrPllon = 1U << 24;
  static constexpr std::uint32_t kCrPllrdy = 1U << 25;

  static constexpr std::uint32_t kPllcfgrSrcHse = 1U << 22;

  static constexpr std::uint32_t kCfgrSwMask = 3U << 0;
  static constexpr std::uint32_t kCfgrSwPll = 2U << 0;
  static constexpr std::uint32_t kCfgrSwsMask = 3U << 2;
  static constexpr std::uint32_t kCfgrSwsPll = 2U << 2;

  static constexpr std::uint32_t kAhb1enrGpioa = 1U << 0;
  static constexpr std::uint32_t kAhb1enrGpiob = 1U << 1;
  static constexpr std::uint32_t kAhb1enrGpioc = 1U << 2;
  static constexpr std::uint32_t kAhb1enrDma2 = 1U << 22;
  static constexpr std::uint32_t kAhb2enrOtgfs = 1U << 7;
  static constexpr std::uint32_t kApb1enrTim3 = 1U << 1;
  static constexpr std::uint32_t kApb1enrTim7 = 1U << 5;
  static constexpr std::uint32_t kApb1enrPwr = 1U << 28;
  static constexpr std::uint32_t kApb2enrTim8 = 1U << 1;
  static constexpr std::uint32_t kApb2enrUsart1 = 1U << 4;
  static constexpr std::uint32_t kApb2enrAdc1 = 1U << 8;

  static constexpr std::uint32_t kCsrRmvf = 1U << 24;
  static constexpr std::uint32_t kCsrBorrstf = 1U << 25;
  static constexpr std::uint32_t kCsrPinrstf = 1U << 26;
  static constexpr std::uint32_t kCsrPorrstf = 1U << 27;
  static constexpr std::uint32_t kCsrSftrstf = 1U << 28;
  static constexpr std::uint32_t kCsrIwdgrstf = 1U << 29;
  static constexpr std::uint32_t kCsrWwdgrstf = 1U << 30;
  static constexpr std::uint32_t kCsrLpwrrstf = 1U << 31;
};
static_assert(offsetof(Rcc, cfgr) == 0x08 && offsetof(Rcc, ahb1enr) == 0x30, "RM0090 7.3");
static_assert(offsetof(Rcc, ahb2enr) == 0x34, "RM0090 7.3");
static_assert(offsetof(Rcc, apb1enr) == 0x40 && offsetof(Rcc, apb2enr) == 0x44, "RM0090 7.3");
static_assert(offsetof(Rcc, bdcr) == 0x70 && offsetof(Rcc, csr) == 0x74, "RM0090 7.3");

}  // namespace batuta::stm32f405
