// SPDX-License-Identifier: MIT

#include "moved_stick.hpp"

#include <cstdlib>

namespace batuta::test {
namespace {

constexpr Microseconds kTickUs = 1000;

/// The stage hands on what is demanded as it is: what the host asks for is to be compared, and the
/// stage has tests of its own. Its ramps stay, as short as they can be.
usb::UsbStickSettings settings() {
  usb::UsbStickSettings settings;
  settings.stage.end_stop.stiffness = 0;
  settings.stage.end_stop.damping = 0;
  settings.stage.speed_limit.proportional = 0;
  settings.stage.speed_limit.integral = 0;
  settings.stage.slew_rate = 1e4F;
  settings.stage.samples.length = 1;
  settings.stage.commands.length = 1;
  settings.stage.fade = 1;
  return settings;
}

}  // namespace

MovedStick::MovedStick() : stick_(motor_, settings()) {
  usb::connect(&stick_);
  if (stick_.start() != Status::kOk) std::abort();
}

void MovedStick::move(const Movement& movement, int milliseconds) {
  for (int i = 1; i <= milliseconds; ++i) {
    const double t = 0.001 * i;
    const Vec2<double> at =
        movement.from + movement.velocity * t + movement.acceleration * (0.5 * t * t);
    now_ += kTickUs;
    InputSample sample;
    sample.time = now_;
    sample.x = static_cast<float>(at.x());
    sample.y = static_cast<float>(at.y());
    sample.buttons = movement.buttons;
    usb::run(stick_, &sample, now_);
  }
}

}  // namespace batuta::test
