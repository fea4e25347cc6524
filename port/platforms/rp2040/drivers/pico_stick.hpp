// SPDX-License-Identifier: MIT
#pragma once
// Two potentiometers on the RP2040's ADC, read when asked: a read takes as long as its 32
// conversions of 2 us, 64 us in all, and waits for nothing else. At the time of the last read there
// is nothing new, and nothing is converted.

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
  Microseconds read_at_ = 0;  ///< of the last conversions
  bool has_read_ = false;
};

}  // namespace batuta::rp2040
