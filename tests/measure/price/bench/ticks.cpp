// SPDX-License-Identifier: MIT
#include "ticks.hpp"

namespace batuta::price {

void start_ticks() {
  constexpr std::uint32_t kProcessorClock = 4;  // and no interrupt
  constexpr std::uint32_t kEnable = 1;
  cortex_m::kSysTickReload.write(0xFFFFFFU);
  cortex_m::kSysTickCurrent.write(0);
  cortex_m::kSysTickControl.write(kProcessorClock | kEnable);
}

std::uint32_t calibration_ticks() {
  std::uint32_t rounds = kCalibrationInstructions / 2;
  const std::uint32_t start = ticks();
  // Bound: rounds. Two instructions each, on every core.
  asm volatile(".syntax unified\n1: subs %0, #1\n bne 1b\n" : "+l"(rounds) : : "cc");
  return ticks_between(start, ticks());
}

std::uint32_t reading_ticks() {
  return ticks_of([] {});
}

}  // namespace batuta::price
