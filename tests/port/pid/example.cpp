// SPDX-License-Identifier: MIT
// The example of pid.md, which a test compares line by line.

// begin
#include "batuta/haptics/output_stage.hpp"
#include "shared/hid_pid/tinyusb.hpp"
#include "tusb.h"

namespace pid = batuta::pid;

pid::Device<16> effects;  // at most 16 effects at the same time

// The three callbacks of the HID class, and the two that tell that the host has gone or sleeps.
uint8_t const* tud_hid_descriptor_report_cb(uint8_t) {
  return effects.report_descriptor().data();
}

uint16_t tud_hid_get_report_cb(uint8_t, uint8_t id, hid_report_type_t type, uint8_t* bytes,
                               uint16_t room) {
  return pid::tinyusb::get_report(effects, id, type, bytes, room);
}

void tud_hid_set_report_cb(uint8_t, uint8_t id, hid_report_type_t type, uint8_t const* bytes,
                           uint16_t size) {
  // What is refused is counted: effects.counters().
  (void)pid::tinyusb::set_report(effects, id, type, bytes, size);
}

void tud_umount_cb(void) {
  effects.forget_host();
}
void tud_suspend_cb(bool) {
  effects.silence();  // the host wakes with its effects where they were
}

// A state that has changed, or else where the stick is; that in every other report at least.
static void tell_host(const batuta::InputSample& sample) {
  static bool told_state = false;
  uint8_t bytes[8];
  pid::PidState state;
  const pid::Joystick stick = pid::joystick_of(sample);
  effects.tell_stick(stick);
  if (!tud_hid_ready()) return;
  told_state = !told_state && effects.next_state(state);
  if (told_state) {
    const int size = pid::encode(state, bytes, sizeof bytes);
    tud_hid_report(static_cast<uint8_t>(pid::PidState::kId), bytes, static_cast<uint16_t>(size));
  } else {
    const int size = pid::encode(stick, bytes, sizeof bytes);
    tud_hid_report(static_cast<uint8_t>(pid::Joystick::kId), bytes, static_cast<uint16_t>(size));
  }
}

// Once a millisecond, in the context that also runs tud_task(). The stage is configured with a gain
// of 1, 1: what is demanded are shares of the actuator's range.
void tick(batuta::haptics::OutputStage& stage, const batuta::InputSample& sample,
          const batuta::Vec2<float>& velocity, batuta::Microseconds now) {
  static batuta::Vec2<float> before(0.0F, 0.0F);
  pid::Stick stick;
  stick.position = {sample.x, sample.y};
  stick.velocity = velocity;
  stick.acceleration = (velocity - before) * 1000.0F;  // in a millisecond
  before = velocity;
  batuta::haptics::StageInput input;
  input.time = now;
  input.demanded = effects.force(stick, now);
  input.position = stick.position;
  input.velocity = velocity;
  input.fresh_sample = true;
  input.fresh_command = true;
  (void)stage.step(input);  // the stage tells the motor, and reports what it refused
  tell_host(sample);
}
// end
