// SPDX-License-Identifier: MIT
#pragma once
// The template's devices for the contract's checks, on a host and on a board.

#include "template/clock.hpp"
#include "template/force.hpp"
#include "template/input.hpp"

namespace batuta::test {

struct TemplateStick {
  static constexpr bool kHasSamples = false;
  InputDevice& device() { return device_; }
  Microseconds next() { return now_ += 1000; }

 private:
  port_template::TemplateInput device_;
  Microseconds now_ = 0;
};

struct TemplateTime {
  Clock& clock() { return clock_; }

 private:
  port_template::TemplateClock clock_;
};

struct TemplateMotor {
  ForceDevice& device() { return device_; }

 private:
  port_template::TemplateForce device_;
};

}  // namespace batuta::test
