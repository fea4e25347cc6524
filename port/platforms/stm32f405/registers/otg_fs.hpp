// SPDX-License-Identifier: MIT
#pragma once
// The global registers of USB OTG FS: RM0090 section 34.16.2. All but one belong to the USB stack.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct OtgFs {
  volatile std::uint32_t of_the_stack[14];
  volatile std::uint32_t gccfg;

  static constexpr std::uint32_t kGccfgVbusbsen = 1U << 19;    ///< a device senses VBUS on PA9
  static constexpr std::uint32_t kGccfgNovbussens = 1U << 21;  ///< or takes it to be always there
};
static_assert(offsetof(OtgFs, gccfg) == 0x38, "RM0090 34.16.2");

}  // namespace batuta::stm32f405
