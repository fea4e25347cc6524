// SPDX-License-Identifier: MIT
#include "platforms/cortex_m/stack_guard.hpp"

#include "platforms/cortex_m/registers.hpp"

extern "C" std::uint32_t batuta_stack_bottom[];  // of the linker script

namespace batuta::cortex_m {

#if __ARM_ARCH >= 8

void guard_stack() {}

#else

void guard_stack() {
  constexpr Register kType{0xE000ED90U};
  constexpr Register kControl{0xE000ED94U};
  constexpr Register kNumber{0xE000ED98U};
  constexpr Register kBase{0xE000ED9CU};
  constexpr Register kAttributes{0xE000EDA0U};
  constexpr std::uint32_t kGuardBytes = 0x10000U;
  constexpr std::uint32_t kNoAccess64K = (1U << 28) | (15U << 1) | 1U;  // not executed, 2^(15 + 1)
  constexpr std::uint32_t kEnableOverDefaultMap = 5;

  const std::uint32_t regions = (kType.read() >> 8) & 0xFFU;
  if (regions == 0) return;
  kNumber.write(regions - 1);
  kBase.write(reinterpret_cast<std::uintptr_t>(batuta_stack_bottom) - kGuardBytes);
  kAttributes.write(kNoAccess64K);
  kControl.write(kEnableOverDefaultMap);  // not in fault handlers, which have to get on
  __asm volatile("dsb\n isb" ::: "memory");
}

#endif

}  // namespace batuta::cortex_m
