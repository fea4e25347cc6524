// SPDX-License-Identifier: MIT
#pragma once
// Independent watchdog: RM0090 section 21.4.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct Iwdg {
  volatile std::uint32_t kr;
  volatile std::uint32_t pr;
  volatile std::uint32_t rlr;
  volatile std::uint32_t sr;

  static constexpr std::uint32_t kKrFeed = 0xAAAAU;
  static constexpr std::uint32_t kKrUnlock = 0x5555U;
  static constexpr std::uint32_t kKrStart = 0xCCCCU;
  static constexpr std::uint32_t kRlrMax = 0xFFFU;
  static constexpr std::uint32_t kSrBusy = 3U;  ///< PVU or RVU: a new value is on its way
};
static_assert(offsetof(Iwdg, sr) == 0x0C, "RM0090 21.4");

}  // namespace batuta::stm32f405
