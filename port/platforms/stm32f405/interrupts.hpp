// SPDX-License-Identifier: MIT
#pragma once
// The part's interrupts that this port uses: RM0090 section 12.2.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

enum class Interrupt : std::uint32_t {
  kAdc = 18,
  kUsart1 = 37,
  kTim7 = 55,
  kDma2Stream0 = 56,
  kOtgFs = 67,
};
inline constexpr std::size_t kInterrupts = 82;

/// @param priority  0 (first) ... 15
void enable(Interrupt interrupt, std::uint32_t priority);

}  // namespace batuta::stm32f405

// Handlers that a program may define; one that is not is a fault.
extern "C" void batuta_on_adc();
extern "C" void batuta_on_usart1();
extern "C" void batuta_on_tim7();
extern "C" void batuta_on_dma2_stream0();
extern "C" void batuta_on_otg_fs();
