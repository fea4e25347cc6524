// SPDX-License-Identifier: MIT
#pragma once
// Force on the stick, from the library to the device.

#include "batuta/core/status.hpp"
#include "batuta/port/clock.hpp"

namespace batuta {

struct ForceCommand {
  Microseconds time = 0;  ///< when it was computed
  float x = 0;            ///< share of the actuator's range, -1 ... 1, positive: right
  float y = 0;            ///< share of the actuator's range, -1 ... 1, positive: up
};

/// A force actuator. Validation is done once, here; a port implements do_write() only.
class ForceDevice {
 public:
  /// Hands a command over; never blocks; the latest one wins.
  /// @returns kOk | kInvalidArgument: not finite or outside [-1, 1], and the device was told zero
  /// instead |
  ///   kUnavailable: the device is gone
  Status write(const ForceCommand& command);

 protected:
  ForceDevice() = default;
  ~ForceDevice() = default;
  ForceDevice(const ForceDevice&) = default;
  ForceDevice& operator=(const ForceDevice&) = default;

 private:
  virtual Status do_write(const ForceCommand& command) = 0;
};

}  // namespace batuta
