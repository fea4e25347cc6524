// SPDX-License-Identifier: MIT
#pragma once
// Force on the stick, from the library to the device. Whoever holds a device may take the force
// away; a force that is not zero comes through the output stage (haptics/output_stage.hpp), and in
// no other way.

#include "batuta/core/status.hpp"
#include "batuta/port/clock.hpp"

namespace batuta::haptics {
class OutputStage;
}  // namespace batuta::haptics

namespace batuta {

/// What an actuator is told.
struct ForceCommand {
  Microseconds time = 0;  ///< when it was computed
  float x = 0;            ///< share of the actuator's range, -1 ... 1, positive: right
  float y = 0;            ///< share of the actuator's range, -1 ... 1, positive: up
  /// How much there may be of what a device adds by itself (a spring or damper of its own), 0 ...
  /// 1: what the ramps of the output stage leave, and nothing after off().
  float own = 0;
};

/// What ForceDevice::write() asks for. Only the output stage can make one.
class ForcePermit {
  friend class haptics::OutputStage;  // of a later room, known here by its name alone
  explicit ForcePermit() = default;   // explicit: no aggregate, whose ForcePermit{} all could write
};

/// A force actuator. A port implements do_write(), and keeps it private.
class ForceDevice {
 public:
  /// Tells the device zero, at once. @param time  when it was decided
  /// @returns kOk | kUnavailable: the device is gone
  Status off(Microseconds time) { return do_write({time, 0.0F, 0.0F, 0.0F}); }

  /// Hands a command over; never blocks; the latest one wins.
  /// @param command  finite, each share in [-1, 1]: the output stage has seen to it
  /// @returns as off()
  Status write(const ForceCommand& command, ForcePermit /*permit*/) { return do_write(command); }

 protected:
  ForceDevice() = default;
  ~ForceDevice() = default;
  /// Copied only with what derives from it.
  ForceDevice(const ForceDevice&) = default;
  /// Copied only with what derives from it.
  ForceDevice& operator=(const ForceDevice&) = default;

 private:
  virtual Status do_write(const ForceCommand& command) = 0;
};

}  // namespace batuta
