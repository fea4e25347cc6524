// SPDX-License-Identifier: MIT
#pragma once
// Where a playing effect is in its time. Counted on from step to step, so that neither the clock's
// wrap after 71 minutes nor an effect without end matters.

#include <cstdint>

namespace batuta::pid {

/// The times of an effect as they stand; a host may change them while it plays.
struct Timing {
  std::uint32_t duration_us = 0;  ///< 0: no end
  std::uint32_t period_us = 0;    ///< 0: no period
};

class Playback {
 public:
  /// From the beginning: silent for `delay_us`, once, then `loops` times. The next advance() only
  /// begins: the first force of an effect is that at its time 0.
  /// @param loops  0: no end
  void start(std::uint32_t delay_us, std::uint32_t loops);
  void stop() { stage_ = Stage::kStopped; }
  /// Lets time go by. @param step_us  < 2^31
  /// Bound: no loop.
  void advance(std::uint32_t step_us, const Timing& timing);

  /// Started, and not over: also while it is delayed.
  bool playing() const { return stage_ != Stage::kStopped; }
  /// Past its delay.
  bool sounding() const { return stage_ == Stage::kRunning && delay_us_ == 0; }
  /// Since this loop began, us: less than the duration, or held at 2^31 where there is none.
  std::uint32_t elapsed_us() const { return elapsed_us_; }
  /// Since this period began, us.
  std::uint32_t cycle_us() const { return cycle_us_; }

 private:
  enum class Stage : std::uint8_t { kStopped, kBeginning, kRunning };

  void pass(std::uint32_t step_us, const Timing& timing);

  std::uint32_t delay_us_ = 0;
  std::uint32_t elapsed_us_ = 0;
  std::uint32_t cycle_us_ = 0;
  std::uint32_t loops_left_ = 1;  ///< with the one that plays; 0: no end
  Stage stage_ = Stage::kStopped;
};

}  // namespace batuta::pid
