// SPDX-License-Identifier: MIT
#pragma once
// SysTick, the timer that every Cortex-M has: 24 bits that count down with the processor clock,
// made a clock that does not wrap by its interrupt once a period. Its interrupt keeps priority 0,
// the highest, so that every interrupt handler may read the clock.

#include <cstdint>

#include "batuta/port/clock.hpp"
#include "platforms/cortex_m/registers.hpp"

namespace batuta::cortex_m {

/// A period of SysTick for a processor clock of whole MHz.
struct TickPeriod {
  std::uint32_t us;            ///< > 0
  std::uint32_t ticks_per_us;  ///< of the processor clock, > 0
  constexpr std::uint32_t ticks() const { return us * ticks_per_us; }
};

/// What paces a loop at 1 kHz.
constexpr TickPeriod millisecond(std::uint32_t clock_hz) {
  return {1000, clock_hz / 1'000'000U};
}

/// As long as 24 bits allow: the fewest interrupts.
constexpr TickPeriod longest_period(std::uint32_t clock_hz) {
  constexpr std::uint32_t kMostTicks = 1U << 24;
  return {kMostTicks / (clock_hz / 1'000'000U), clock_hz / 1'000'000U};
}

/// Starts counting, with interrupts: ticks and periods from zero, microseconds from `first`.
/// @pre 1 < period.ticks() <= 2^24
void start_systick(TickPeriod period, Microseconds first = 0);

/// Processor clock ticks since the start; does not wrap in the life of a device. Callable wherever
/// interrupts are not off for more than a period; about 25 instructions, always the same ones but
/// where a period has just ended.
std::uint64_t ticks();

/// The same under the name that measurements want: clock cycles on hardware; in QEMU with
/// -icount shift=S, 2^S ns of the board's clock an instruction.
inline std::uint64_t cycles() {
  return ticks();
}

/// The bare counter, counting down from the period: one load. For intervals shorter than a period:
/// elapsed_ticks().
inline std::uint32_t systick_count() {
  return kSysTickCurrent.read();
}

/// Ticks between two systick_count(), the earlier first, less than a period apart.
constexpr std::uint32_t elapsed_ticks(std::uint32_t from, std::uint32_t to, TickPeriod period) {
  return from >= to ? from - to : from + period.ticks() - to;
}

/// Periods that have ended since the start, modulo 2^32.
std::uint32_t period_count();

/// Sleeps until period_count() is another number than `last`. @returns that number
/// Bound: one period; a timer that has stopped never returns, which is what a watchdog is for.
std::uint32_t next_period(std::uint32_t last);

/// Microseconds since the start, modulo 2^32.
class SysTickClock final : public Clock {
 private:
  Microseconds do_now() override;
};

}  // namespace batuta::cortex_m
