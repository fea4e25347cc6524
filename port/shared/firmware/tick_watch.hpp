// SPDX-License-Identifier: MIT
#pragma once
// Whether a loop keeps its rate: which ticks of the board's timer went by unused, and how long a
// tick's work took. What was missed is counted, never made up for.

#include "batuta/port/clock.hpp"

namespace batuta::firmware {

/// Counts since the start.
struct TickReport {
  std::uint32_t used = 0;
  std::uint32_t skipped = 0;    ///< that went by unused
  std::uint32_t overruns = 0;   ///< whose work took longer than a period
  std::int32_t longest_us = 0;  ///< the longest work, us
};

/// Allocates: never. begin() and end() take turns.
class TickWatch {
 public:
  /// Starts anew; the next begin() is the first tick. @pre period_us > 0
  void start(std::int32_t period_us);

  /// The work of a tick begins.
  /// @param tick  number of the timer's tick, modulo 2^32: those between the last one and this are
  ///   skipped. @pre another one than the last one's: a tick is begun once
  void begin(std::uint32_t tick, Microseconds now);
  /// It ends.
  void end(Microseconds now);

  /// When the work of the current tick began.
  Microseconds begun() const { return begun_; }
  const TickReport& report() const { return report_; }

 private:
  TickReport report_;
  std::uint32_t last_tick_ = 0;
  Microseconds begun_ = 0;
  std::int32_t period_us_ = 1000;
};

}  // namespace batuta::firmware
