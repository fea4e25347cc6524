// SPDX-License-Identifier: MIT
#pragma once
// From a force to the two inputs of an H-bridge of the IN1/IN2 kind (DRV8871 and its like): one is
// pulsed, the other low. Both low: the bridge is off and the motor coasts.

#include <cstdint>

namespace batuta::drivers {

/// Compare values of the timer: 0 is low for good, `period` is high for good.
struct BridgeDuty {
  std::uint32_t in1 = 0;  ///< pulsed for a positive force
  std::uint32_t in2 = 0;  ///< pulsed for a negative one
};

/// The share of `period` nearest to the force, away from zero at a half. Never both inputs at once;
/// anything beyond the ends is an end, and a force that is none is none.
/// @param force  share of the actuator's range, -1 ... 1
/// @param period steps of the timer, at most 2^16
/// |error| <= 1/2 + 2^-8 steps: the product's own rounding. Symmetric, monotone, exact for k /
/// period.
constexpr BridgeDuty bridge_duty(float force, std::uint32_t period) {
  BridgeDuty duty;
  const bool forward = force > 0.0F;
  const float size = forward ? force : -force;
  if (!(size > 0.0F)) return duty;  // zero, and what is no number
  const float exact = size < 1.0F ? size * static_cast<float>(period) : static_cast<float>(period);
  const auto below = static_cast<std::uint32_t>(exact);
  const std::uint32_t steps = exact - static_cast<float>(below) < 0.5F ? below : below + 1;
  (forward ? duty.in1 : duty.in2) = steps;
  return duty;
}

}  // namespace batuta::drivers
