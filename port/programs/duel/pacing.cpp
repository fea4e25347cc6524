// SPDX-License-Identifier: MIT

#include "programs/duel/pacing.hpp"

#include <chrono>
#include <thread>

#include "programs/duel/duel_runner.hpp"
#include "programs/duel/interrupt.hpp"

namespace batuta::host {
namespace {

constexpr std::chrono::milliseconds kLook(2);  // how often a bout that stands still looks up

}  // namespace

Pacing::Pacing(bool realtime, ViewControls* controls)
    : realtime_(realtime), controls_(controls), pace_(clock_.now(), DuelRunner::kStep_us) {}

bool Pacing::wait() {
  if (controls_ != nullptr && !wait_for_viewer()) return false;
  if (realtime_) wait_for_clock();
  return !is_interrupted();
}

bool Pacing::wait_for_viewer() {
  bool stood = false;
  while (controls_->is_paused() && !controls_->take_step()) {  // Bound: until a viewer goes on
    if (controls_->wish() != ViewWish::kNone || is_interrupted()) return false;
    std::this_thread::sleep_for(kLook);
    stood = true;
  }
  if (stood || controls_->slowness() != slowness_) {
    slowness_ = controls_->slowness();
    pace_ = Pace(clock_.now(), slowness_ * DuelRunner::kStep_us);
  }
  return controls_->wish() == ViewWish::kNone;
}

void Pacing::wait_for_clock() {
  const std::int32_t early_us = pace_.wait_us(clock_.now());
  if (early_us > 0) std::this_thread::sleep_for(std::chrono::microseconds(early_us));
}

ViewWish wait_for_wish(const ViewControls& controls) {
  while (controls.wish() == ViewWish::kNone && !is_interrupted()) {  // Bound: a viewer's patience
    std::this_thread::sleep_for(kLook);
  }
  return is_interrupted() ? ViewWish::kQuit : controls.wish();
}

}  // namespace batuta::host
