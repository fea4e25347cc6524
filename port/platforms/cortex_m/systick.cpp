// SPDX-License-Identifier: MIT
#include "platforms/cortex_m/systick.hpp"

#include "batuta/core/assert.hpp"
#include "platforms/cortex_m/vectors.hpp"

namespace batuta::cortex_m {
namespace {

/// What the interrupt advances, once a period.
struct Past {
  std::uint64_t ticks;
  Microseconds us;
  std::uint32_t periods;
};

TickPeriod period{1, 1};
volatile Past past;

void end_period() {
  past.ticks = past.ticks + period.ticks();
  past.us = past.us + period.us;
  past.periods = past.periods + 1;
}

/// The present: what is past, and how far the current period is.
struct Present {
  Past past;
  std::uint32_t elapsed;  ///< ticks, less than a period
};

/// The counter goes period - 1 ... 1, 0, period - 1 ...; the period ends, and the interrupt is
/// pending, where it becomes 0. A 0 without a pending interrupt is a counter that is ahead of its
/// interrupt (emulators): the period's last tick.
Present present() {
  constexpr std::uint32_t kPending = 1U << 26;
  const InterruptLock lock;
  std::uint32_t count = kSysTickCurrent.read();
  const bool ended = kInterruptControl.is_set(kPending);
  if (ended) count = kSysTickCurrent.read();  // the first may have been read before the end
  Present now{{past.ticks, past.us, past.periods}, 0};
  const std::uint32_t length = period.ticks();
  if (ended) {
    now.past.ticks += length;
    now.past.us += period.us;
    ++now.past.periods;
    now.elapsed = count == 0 ? 0 : length - count;
  } else {
    now.elapsed = count == 0 ? length - 1 : length - count;
  }
  return now;
}

}  // namespace

void start_systick(TickPeriod new_period, Microseconds first) {
  constexpr std::uint32_t kMostTicks = 1U << 24;
  BATUTA_ASSERT(new_period.ticks() > 1 && new_period.ticks() <= kMostTicks);
  constexpr std::uint32_t kProcessorClockInterruptEnable = 7;
  constexpr std::uint32_t kClearPending = 1U << 25;
  const InterruptLock lock;
  kSysTickControl.write(0);
  kInterruptControl.write(kClearPending);  // of an earlier start
  period = new_period;
  past.ticks = 0;
  past.us = first;
  past.periods = 0;
  kSysTickReload.write(period.ticks() - 1);
  kSysTickCurrent.write(0);
  kSysTickControl.write(kProcessorClockInterruptEnable);
  // Until the counter has been loaded it shows 0, which means something else later. Bound: 10^6
  // reads; a clock or two of a processor, longer in an emulator whose timer runs in another thread.
  for (int i = 0; i < 1'000'000 && kSysTickCurrent.read() == 0; ++i) {
  }
}

std::uint64_t ticks() {
  const Present now = present();
  return now.past.ticks + now.elapsed;
}

std::uint32_t period_count() {
  return present().past.periods;
}

std::uint32_t next_period(std::uint32_t last) {
  // Bound: the interrupts of one period; a timer that has stopped never returns.
  for (;;) {
    const InterruptLock lock;  // else the tick could come between the look and the sleep
    const std::uint32_t count = period_count();
    if (count != last) return count;
    __asm volatile("dsb\n wfi" ::: "memory");  // wakes up with interrupts off, too
  }
}

Microseconds SysTickClock::do_now() {
  const Present now = present();
  return now.past.us + now.elapsed / period.ticks_per_us;
}

}  // namespace batuta::cortex_m

void batuta_on_systick() {
  batuta::cortex_m::end_period();
}
