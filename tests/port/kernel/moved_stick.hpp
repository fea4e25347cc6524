// SPDX-License-Identifier: MIT
#pragma once
// The stick of the boards with a hand and a clock that obey: it is where it is told to be, no time
// passes but what it is told to let pass, and the force that its motor gets can be read.

#include "fake_tinyusb.hpp"
#include "shared/usb_stick/tinyusb_device.hpp"

namespace batuta::test {

/// How the stick moves from now on: x right, y up.
struct Movement {
  Vec2<double> from{0.0, 0.0};
  Vec2<double> velocity{0.0, 0.0};      ///< 1/s
  Vec2<double> acceleration{0.0, 0.0};  ///< 1/s^2
  std::uint32_t buttons = 0;
};

class MovedStick {
 public:
  MovedStick();
  ~MovedStick() { usb::connect(nullptr); }
  MovedStick(const MovedStick&) = delete;
  MovedStick& operator=(const MovedStick&) = delete;
  MovedStick(MovedStick&&) = delete;
  MovedStick& operator=(MovedStick&&) = delete;

  /// Lets so many milliseconds pass. @pre it stays within -1 ... 1
  void move(const Movement& movement, int milliseconds);
  /// What the motor was told last.
  const ForceCommand& force() const { return motor_.told; }
  usb::UsbStick& stick() { return stick_; }

 private:
  struct Motor final : ForceDevice {
    ForceCommand told;

   private:
    Status do_write(const ForceCommand& command) override {
      told = command;
      return Status::kOk;
    }
  };

  Motor motor_;
  usb::UsbStick stick_;
  Microseconds now_ = 0;
};

}  // namespace batuta::test
