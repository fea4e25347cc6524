// SPDX-License-Identifier: MIT
#pragma once
// A whole force-feedback stick but for its board and its USB stack: the host's effects, through the
// output stage, to the motor. Without a host that is awake the motor gets zero, from the tick on
// that learns of it, whatever the stage's limits: the host cannot take a force back any more.

#include "batuta/haptics/output_stage.hpp"
#include "shared/usb_stick/descriptors.hpp"
#include "shared/usb_stick/motion.hpp"

namespace batuta::usb {

/// Whom the stick talks to.
enum class Host : std::uint8_t {
  kAway,    ///< no bus, or none that has configured the stick yet
  kAsleep,  ///< has suspended the bus: a cable without a host, too
  kAwake,
};

/// For demands that are shares of the actuator's range; one step a millisecond.
haptics::StageSettings default_stage();

struct UsbStickSettings {
  haptics::StageSettings stage = default_stage();
  pid::Scales scales;
  Identity identity;
};

/// An input report, as TinyUSB takes it.
struct InputReport {
  std::uint8_t id = 0;
  std::uint8_t size = 0;
  std::array<std::uint8_t, 8> bytes{};
};

/// From one context: that which runs the USB stack and the ticks.
class UsbStick {
 public:
  /// @param motor  outlives the stick; nobody else gives it a force
  explicit UsbStick(ForceDevice& motor, const UsbStickSettings& settings = {});

  /// Starts anew, without a host. @returns kOk | kInvalidArgument: the stage's settings
  Status start();

  /// A millisecond. What an awake host demands goes to the motor, fading in after it woke or came.
  /// @param fresh  what the stick has said since the last tick; null: nothing new
  /// Bound: the blocks. Allocates: never.
  void tick(const InputSample* fresh, Host host, Microseconds now);

  /// The host has gone, and what it had uploaded with it: force zero now, blocks free, gain full.
  void leave();
  /// The host sleeps: force zero now. Its blocks are kept, and nothing plays when it wakes before
  /// it is started again.
  void sleep();

  /// The next input report: a change of the device's state, or else where the stick is; that in
  /// every other report at least, however fast the states change.
  InputReport next_report();

  pid::DeviceBase& effects() { return effects_; }
  const haptics::OutputStage& stage() const { return stage_; }
  const Identity& identity() const { return settings_.identity; }

 private:
  void follow(Host host);
  void cut();

  UsbStickSettings settings_;
  PidDevice effects_;
  haptics::OutputStage stage_;
  Motion motion_;
  pid::Joystick joystick_;
  Microseconds now_ = 0;
  bool told_state_ = false;  ///< by the last report
};

}  // namespace batuta::usb
