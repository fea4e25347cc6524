// SPDX-License-Identifier: MIT
#pragma once
// Zephyr's up-time. It steps by a tick (CONFIG_SYS_CLOCK_TICKS_PER_SEC: 100 us unless the
// application says otherwise); samples and commands are stamped no finer than that.

#include "batuta/port/clock.hpp"

namespace batuta::zephyr {

/// Any thread and any interrupt handler may ask.
class TickClock final : public Clock {
 private:
  Microseconds do_now() override;
};

}  // namespace batuta::zephyr
