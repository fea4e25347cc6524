// SPDX-License-Identifier: MIT
#include "platforms/zephyr/clock.hpp"

#include <zephyr/kernel.h>

namespace batuta::zephyr {

// From 64 bits of ticks: cut to 32 bits only as microseconds, where it wraps as Clock promises.
Microseconds TickClock::do_now() {
  return static_cast<Microseconds>(
      k_ticks_to_us_floor64(static_cast<std::uint64_t>(k_uptime_ticks())));
}

}  // namespace batuta::zephyr
