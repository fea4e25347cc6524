// SPDX-License-Identifier: MIT
// The clock: it never goes back, neither at the end of a period nor at that of 32 bits, whoever
// reads.
#include "platforms/cortex_m/systick.hpp"

#include "checks.hpp"
#include "platforms/cortex_m/vectors.hpp"
#include "platforms/mps2/board.hpp"

namespace {

using namespace batuta;
using namespace batuta::cortex_m;

constexpr TickPeriod kMillisecond = millisecond(mps2::kBoard.clock_hz);

SysTickClock clock;
volatile std::uint64_t ticks_in_interrupt = 0;

/// Reads until `periods` have gone by. Bound: 10^8 reads. @returns whether no read was less than
/// the one before, and time went on
bool is_monotone(std::uint32_t periods) {
  const std::uint32_t first_period = period_count();
  std::uint64_t last = ticks();
  Microseconds last_us = clock.now();
  for (int i = 0; i < 100'000'000; ++i) {
    const std::uint64_t now = ticks();
    const Microseconds now_us = clock.now();
    if (now < last || elapsed_us(last_us, now_us) < 0) return false;
    last = now;
    last_us = now_us;
    if (period_count() - first_period >= periods) return true;
  }
  return false;
}

/// Microseconds and ticks say the same.
bool is_consistent(Microseconds first) {
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t before = ticks() / kMillisecond.ticks_per_us;
    const Microseconds us = clock.now() - first;
    const std::uint64_t after = ticks() / kMillisecond.ticks_per_us;
    if (us < before || us > after) return false;
  }
  return true;
}

/// Interrupts are off while a period ends: the time goes on, and nothing is counted twice later.
bool holds_while_locked() {
  for (int i = 0; i < 50; ++i) {
    const std::uint32_t period = period_count();
    std::uint64_t last = ticks();
    const InterruptLock lock;
    // Bound: a period and a half, as far as is allowed.
    while (period_count() == period) {
      const std::uint64_t now = ticks();
      if (now < last) return false;
      last = now;
    }
    if (period_count() != period + 1 || ticks() < last) return false;
  }
  return true;
}

bool holds_in_interrupts() {
  constexpr std::uint32_t kSetPendSv = 1U << 28;
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t before = ticks();
    kInterruptControl.write(kSetPendSv);
    __asm volatile("dsb\n isb" ::: "memory");
    const std::uint64_t between = ticks_in_interrupt;
    if (between < before || ticks() < between) return false;
  }
  return true;
}

bool wraps_microseconds() {
  constexpr Microseconds kNearTheEnd = 0U - 2'500U;
  start_systick(kMillisecond, kNearTheEnd);
  const Microseconds before = clock.now();
  const bool monotone = is_monotone(6);
  const Microseconds after = clock.now();
  return monotone && before >= kNearTheEnd && after < 1'000'000U && is_consistent(kNearTheEnd);
}

}  // namespace

void batuta_on_pendsv() {
  ticks_in_interrupt = ticks();
}

int main() {
  Checks check;
  start_systick(kMillisecond);
  check.that(is_monotone(50), "50 periods without a step back");
  check.that(is_consistent(0), "microseconds are ticks");
  check.that(holds_while_locked(), "a period may end while interrupts are off");
  check.that(holds_in_interrupts(), "an interrupt reads the same time");
  check.that(wraps_microseconds(), "microseconds wrap at 32 bits");
  start_systick(longest_period(mps2::kBoard.clock_hz));
  check.that(is_monotone(1), "the longest period ends without a step back");
  check.end();
}
