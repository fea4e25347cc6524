// SPDX-License-Identifier: MIT
#pragma once
// Instructions, counted by SysTick under QEMU's -icount, where every instruction takes the same
// time. These are instructions, not cycles: an emulator knows nothing of pipelines, buses and
// flash.

#include "platforms/cortex_m/registers.hpp"

namespace batuta::price {

/// Starts the counter. The program must not use SysTick for anything else.
void start_ticks();

/// Counts down, modulo 2^24.
inline std::uint32_t ticks() {
  return cortex_m::kSysTickCurrent.read();
}

constexpr std::uint32_t ticks_between(std::uint32_t start, std::uint32_t end) {
  return (start - end) & 0xFFFFFFU;
}

/// Ticks of a loop of kCalibrationInstructions, and of nothing at all: what tells ticks from
/// instructions.
inline constexpr std::uint32_t kCalibrationInstructions = 200000;
std::uint32_t calibration_ticks();
std::uint32_t reading_ticks();

/// A hint that does nothing on a part, and that the plugin which counts cycles (cycles/cycles.c)
/// knows: a measurement begins or ends.
__attribute__((always_inline)) inline void mark() {
#if __ARM_ARCH >= 7
  asm volatile("dbg #5" ::: "memory");
#endif
}

/// Runs `work` and tells its ticks. @pre fewer than 2^24
template <class Work>
__attribute__((always_inline)) inline std::uint32_t ticks_of(const Work& work) {
  mark();
  const std::uint32_t start = ticks();
  asm volatile("" ::: "memory");
  work();
  asm volatile("" ::: "memory");
  const std::uint32_t end = ticks();
  mark();
  return ticks_between(start, end);
}

}  // namespace batuta::price
