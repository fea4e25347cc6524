// SPDX-License-Identifier: MIT
#pragma once
// Two motors behind bridges of the IN1/IN2 kind, each input a channel of Zephyr's PWM:
//   batuta::zephyr::PwmForce force({PWM_DT_SPEC_GET_BY_NAME(DT_PATH(stick), x1), ...});
// A channel holds its last pulse: where commands stop coming, the force stays until off(). Have the
// watchdog's interrupt or a timer call off(), and batuta_trap() too.

#include <zephyr/drivers/pwm.h>

#include "batuta/port/force.hpp"

namespace batuta::zephyr {

/// Channels of a bridge.
struct Bridge {
  pwm_dt_spec in1;  ///< pulsed for a positive force
  pwm_dt_spec in2;  ///< pulsed for a negative one
};

class PwmForce final : public ForceDevice {
 public:
  /// Longest period, ns: 15.3 kHz, below which a motor is heard; what drivers/bridge_duty.hpp
  /// takes.
  static constexpr std::uint32_t kLongestPeriod = 65536;

  /// Right and up are positive. Exchange in1 and in2 where a motor runs the other way.
  PwmForce(const Bridge& x, const Bridge& y) : x_(x), y_(y) {}

  /// Looks at the channels and takes the force away. Before it, commands are refused.
  /// @returns kOk | kUnavailable: a device is not ready, or refuses a pulse | kInvalidArgument: a
  ///   period is 0 or above kLongestPeriod, or those of a bridge differ; no channel was touched
  Status start();

 private:
  Status do_write(const ForceCommand& command) override;

  Bridge x_;
  Bridge y_;
  bool is_started_ = false;
};

}  // namespace batuta::zephyr
