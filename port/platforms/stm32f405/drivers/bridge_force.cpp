// SPDX-License-Identifier: MIT

#include "platforms/stm32f405/drivers/bridge_force.hpp"

#include "shared/drivers/bridge_duty.hpp"

namespace batuta::stm32f405 {
using namespace drivers;  // what boards share

void BridgeForce::configure(std::uint32_t period) {
  period_ = period;
  timer_.bdtr = kSafe;
  timer_.psc = 0;
  timer_.arr = period - 1U;
  timer_.ccmr1 = Tim::kCcmrPwm1Both;
  timer_.ccmr2 = Tim::kCcmrPwm1Both;
  silence();
  timer_.ccer = Tim::kCcerAllFour;
  timer_.egr = Tim::kEgrUg;  // the preloaded values become the active ones
  timer_.cr1 = Tim::kCr1Arpe | Tim::kCr1Cen;
}

Status BridgeForce::arm() {
  silence();
  left_.store(0, std::memory_order_relaxed);
  timer_.sr = ~Tim::kSrBif;
  timer_.bdtr = kSafe | Tim::kBdtrMoe;  // an active break input takes it away again at once
  return is_armed() ? Status::kOk : Status::kUnavailable;
}

Status BridgeForce::do_write(const ForceCommand& command) {
  if (!is_armed()) {
    silence();
    return Status::kUnavailable;
  }
  const BridgeDuty x = bridge_duty(command.x, period_);
  const BridgeDuty y = bridge_duty(command.y, period_);
  // The guard first: it cannot act between the stores below, which would leave half a command.
  left_.store(kGuardTicks, std::memory_order_relaxed);
  timer_.cr1 |= Tim::kCr1Udis;  // all four from the same period on, or none
  timer_.ccr[0] = x.in1;
  timer_.ccr[1] = x.in2;
  timer_.ccr[2] = y.in1;
  timer_.ccr[3] = y.in2;
  timer_.cr1 &= ~Tim::kCr1Udis;
  return Status::kOk;
}

void BridgeForce::guard_tick() {
  ticks_.store(ticks_.load(std::memory_order_relaxed) + 1U, std::memory_order_relaxed);
  const std::uint32_t left = left_.load(std::memory_order_relaxed);
  if (left == 0) return;
  left_.store(left - 1U, std::memory_order_relaxed);
  if (left > 1U) return;
  silence();
  timer_.cr1 &= ~Tim::kCr1Udis;  // a command that hangs between its stores has left it set
  expiries_.store(expiries_.load(std::memory_order_relaxed) + 1U, std::memory_order_relaxed);
}

void BridgeForce::silence() {
  for (volatile std::uint32_t& compare : timer_.ccr) compare = 0;  // Bound: 4
}

}  // namespace batuta::stm32f405
