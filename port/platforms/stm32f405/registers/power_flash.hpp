// SPDX-License-Identifier: MIT
#pragma once
// What has to be set up before the clock may be fast: the regulator (RM0090 section 5.4) and the
// flash's wait states and caches (RM0090 section 3.9).

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct Pwr {
  volatile std::uint32_t cr;
  volatile std::uint32_t csr;

  static constexpr std::uint32_t kCrVos = 1U << 14;  ///< scale 1: above 144 MHz
};
static_assert(offsetof(Pwr, csr) == 0x04, "RM0090 5.4");

struct FlashInterface {
  volatile std::uint32_t acr;

  static constexpr std::uint32_t kAcrLatencyMask = 7U << 0;
  static constexpr std::uint32_t kAcrPrften = 1U << 8;
  static constexpr std::uint32_t kAcrIcen = 1U << 9;
  static constexpr std::uint32_t kAcrDcen = 1U << 10;
};

}  // namespace batuta::stm32f405
