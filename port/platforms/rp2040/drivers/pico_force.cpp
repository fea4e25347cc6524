// SPDX-License-Identifier: MIT

#include "platforms/rp2040/drivers/pico_force.hpp"

#include "hardware/gpio.h"
#include "hardware/pwm.h"
#include "platforms/rp2040/board.hpp"
#include "platforms/rp2040/drivers/force_off.hpp"
#include "shared/drivers/bridge_duty.hpp"

namespace batuta::rp2040 {
namespace {

void set_bridge(unsigned first_pin, const drivers::BridgeDuty& duty) {
  pwm_set_gpio_level(first_pin, static_cast<std::uint16_t>(duty.in1));
  pwm_set_gpio_level(first_pin + 1, static_cast<std::uint16_t>(duty.in2));
}

}  // namespace

void force_off() {
  set_bridge(kFirstForcePin, {});
  set_bridge(kFirstForcePin + 2, {});
}

void PicoForce::configure() {
  gpio_init(kBreakPin);
  gpio_pull_down(kBreakPin);  // an open wire is a stop
  for (unsigned pin = kFirstForcePin; pin < kFirstForcePin + kForcePins; ++pin) {  // Bound: 4
    const unsigned slice = pwm_gpio_to_slice_num(pin);
    pwm_set_wrap(slice, kPulsePeriod - 1U);
    pwm_set_gpio_level(pin, 0);
    pwm_set_enabled(slice, true);
    gpio_set_function(pin, GPIO_FUNC_PWM);
  }
}

Status PicoForce::arm() {
  force_off();
  left_.store(0, std::memory_order_relaxed);
  armed_.store(gpio_get(kBreakPin), std::memory_order_relaxed);
  return is_armed() ? Status::kOk : Status::kUnavailable;
}

/// The guard first, then the bridges, then a look whether the guard has acted in between.
Status PicoForce::do_write(const ForceCommand& command) {
  left_.store(kGuardTicks, std::memory_order_relaxed);
  const auto set_bridges = [this, &command] {
    set_bridge(kFirstForcePin, drivers::bridge_duty(command.x, kPulsePeriod));
    set_bridge(kFirstForcePin + 2, drivers::bridge_duty(command.y, kPulsePeriod));
    return is_armed();
  };
  if (is_armed() && set_bridges()) return Status::kOk;
  force_off();
  return Status::kUnavailable;
}

void PicoForce::guard_tick() {
  ticks_.store(ticks_.load(std::memory_order_relaxed) + 1U, std::memory_order_relaxed);
  if (!gpio_get(kBreakPin)) {
    armed_.store(false, std::memory_order_relaxed);  // until the next arm()
    force_off();
  }
  const std::uint32_t left = left_.load(std::memory_order_relaxed);
  if (left == 0) return;
  left_.store(left - 1U, std::memory_order_relaxed);
  if (left == 1U) force_off();
}

}  // namespace batuta::rp2040
