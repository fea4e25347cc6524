// SPDX-License-Identifier: MIT
#pragma once
// When a loop with a fixed period runs next.

#include <cstdint>

namespace batuta::rp2040 {

/// The first time after `now` that is a whole number of periods after `last`: what is over by then
/// is dropped, never made up. Times wrap. @pre period > 0; `last` is less than 2^32 us ago
constexpr std::uint32_t next_tick_us(std::uint32_t last_us, std::uint32_t now_us,
                                     std::uint32_t period_us) {
  return last_us + ((now_us - last_us) / period_us + 1) * period_us;
}

}  // namespace batuta::rp2040
