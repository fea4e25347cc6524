// SPDX-License-Identifier: MIT

#include "shared/hid_pid/playback.hpp"

namespace batuta::pid {
namespace {

constexpr std::uint32_t kHeld = 0x80000000U;

std::uint32_t rest_of(std::uint32_t time_us, std::uint32_t period_us) {
  return period_us > 0 ? time_us % period_us : 0;
}

}  // namespace

void Playback::start(std::uint32_t delay_us, std::uint32_t loops) {
  delay_us_ = delay_us;
  elapsed_us_ = 0;
  cycle_us_ = 0;
  loops_left_ = loops;
  stage_ = Stage::kBeginning;
}

void Playback::advance(std::uint32_t step_us, const Timing& timing) {
  if (stage_ == Stage::kStopped) return;
  if (stage_ == Stage::kBeginning) {
    stage_ = Stage::kRunning;
    return;
  }
  const std::uint32_t silent_us = step_us < delay_us_ ? step_us : delay_us_;
  delay_us_ -= silent_us;
  pass(step_us - silent_us, timing);
}

/// Time in which the effect sounds. The sums stay below 2^32: a step and what is held are at most
/// 2^31, and a cycle is shorter than the longest period.
void Playback::pass(std::uint32_t step_us, const Timing& timing) {
  elapsed_us_ += step_us;
  if (timing.duration_us == 0) {
    if (elapsed_us_ > kHeld) elapsed_us_ = kHeld;
  } else if (elapsed_us_ >= timing.duration_us) {
    const std::uint32_t over = elapsed_us_ / timing.duration_us;
    if (loops_left_ != 0 && over >= loops_left_) return stop();
    if (loops_left_ != 0) loops_left_ -= over;
    elapsed_us_ %= timing.duration_us;
    cycle_us_ = rest_of(elapsed_us_, timing.period_us);  // each loop begins at its phase
    return;
  }
  cycle_us_ = rest_of(cycle_us_ + step_us, timing.period_us);
}

}  // namespace batuta::pid
