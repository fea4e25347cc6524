// SPDX-License-Identifier: MIT
#pragma once
// When the steps of a bout in real time are due.

#include "batuta/port/clock.hpp"

namespace batuta::host {

class Pace {
 public:
  /// A bout that stood still for longer (the program was stopped, the machine was busy) goes on
  /// from there; what it missed is not made up for in a burst, with blows that nobody can see
  /// coming.
  static constexpr std::int32_t kMostBehind_us = 100000;

  /// @param now  of the first step's beginning
  Pace(Microseconds now, std::int32_t step_us) : due_(now), step_us_(step_us) {}

  /// Another step has been made. @returns how long until it is over, us; 0: it is over already
  std::int32_t wait_us(Microseconds now) {
    due_ += static_cast<Microseconds>(step_us_);
    const std::int32_t early_us = elapsed_us(now, due_);
    // Before its beginning it cannot be made: there the clock has gone half way round.
    const bool stood_still = early_us < -kMostBehind_us || early_us > step_us_;
    if (stood_still) due_ = now;
    return stood_still || early_us < 0 ? 0 : early_us;
  }

 private:
  Microseconds due_;
  std::int32_t step_us_;
};

}  // namespace batuta::host
