// SPDX-License-Identifier: MIT
#include "platforms/zephyr/force.hpp"

#include "shared/drivers/bridge_duty.hpp"

namespace batuta::zephyr {

namespace {

bool is_valid(const Bridge& bridge) {
  const std::uint32_t period = bridge.in1.period;
  return period > 0 && period <= PwmForce::kLongestPeriod && period == bridge.in2.period;
}

bool is_ready(const Bridge& bridge) {
  return pwm_is_ready_dt(&bridge.in1) && pwm_is_ready_dt(&bridge.in2);
}

/// Lets the one input go before it pulses the other: never both. @returns whether both took it
bool drive(const Bridge& bridge, float force) {
  const drivers::BridgeDuty duty = drivers::bridge_duty(force, bridge.in1.period);
  const bool forward = duty.in1 > 0;
  const pwm_dt_spec& low = forward ? bridge.in2 : bridge.in1;
  const pwm_dt_spec& high = forward ? bridge.in1 : bridge.in2;
  if (pwm_set_pulse_dt(&low, 0) != 0) {
    (void)pwm_set_pulse_dt(&high, 0);
    return false;
  }
  return pwm_set_pulse_dt(&high, forward ? duty.in1 : duty.in2) == 0;
}

}  // namespace

Status PwmForce::start() {
  is_started_ = false;
  if (!is_valid(x_) || !is_valid(y_)) return Status::kInvalidArgument;
  if (!is_ready(x_) || !is_ready(y_)) return Status::kUnavailable;
  is_started_ = true;
  return off(0);
}

// A motor that fails takes the force of the other away as well: half a force is another one.
Status PwmForce::do_write(const ForceCommand& command) {
  if (!is_started_) return Status::kUnavailable;
  const bool x = drive(x_, command.x);
  const bool y = drive(y_, x ? command.y : 0.0F);
  if (x && y) return Status::kOk;
  (void)drive(x_, 0.0F);
  return Status::kUnavailable;
}

}  // namespace batuta::zephyr
