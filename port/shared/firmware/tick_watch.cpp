// SPDX-License-Identifier: MIT

#include "shared/firmware/tick_watch.hpp"

#include "batuta/core/assert.hpp"

namespace batuta::firmware {

void TickWatch::start(std::int32_t period_us) {
  BATUTA_ASSERT(period_us > 0);
  *this = {};
  period_us_ = period_us;
}

void TickWatch::begin(std::uint32_t tick, Microseconds now) {
  BATUTA_ASSERT(report_.used == 0 || tick != last_tick_);
  if (report_.used > 0) report_.skipped += tick - last_tick_ - 1;
  last_tick_ = tick;
  begun_ = now;
  ++report_.used;
}

void TickWatch::end(Microseconds now) {
  const std::int32_t spent_us = elapsed_us(begun_, now);
  if (spent_us > period_us_) ++report_.overruns;
  if (spent_us > report_.longest_us) report_.longest_us = spent_us;
}

}  // namespace batuta::firmware
