// SPDX-License-Identifier: MIT
#pragma once
// Two potentiometers on the RP2040's ADC, read when asked: 32 conversions of 2 us.

#include "batuta/port/clock.hpp"
#include "batuta/port/sample_builder.hpp"
#include "shared/drivers/stick_window.hpp"

namespace batuta::rp2040 {

class PicoStick final : public InputDevice {
 public:
  /// Sets the ADC up. @returns kOk | kInvalidArgument: the calibration is not valid
  Status start(const AxisCalibration& axis);

  /// False: no stick is wired, or its wires are off.
  bool is_connected() const { return connection_.connected(); }

 private:
  Status do_read(Microseconds now, InputSample& sample) override;

  SampleBuilder builder_;
  drivers::Connection connection_;
};

}  // namespace batuta::rp2040
