// SPDX-License-Identifier: MIT

#include "shared/hid_pid/reports.hpp"

namespace batuta::pid {
namespace {

void number(Fields& fields, std::uint16_t& value, int high) {
  fields.u16(value);
  fields.require(value <= high);
}

void level(Fields& fields, std::uint16_t& value) {
  number(fields, value, kFullLevel);
}

/// A number with a sign, low ... -low.
void signed_number(Fields& fields, std::int16_t& value, int high) {
  auto bits = static_cast<std::uint16_t>(value);
  fields.u16(bits);
  value = static_cast<std::int16_t>(bits);
  fields.require(value >= -high && value <= high);
}

void signed_level(Fields& fields, std::int16_t& value) {
  signed_number(fields, value, kFullLevel);
}

/// 1 ... high. A block beyond the device's own pool is no block: the device tells.
void block(Fields& fields, std::uint8_t& value) {
  fields.u8(value);
  fields.require(value >= 1 && value <= kMostBlocks);
}

/// One of an enumeration that begins with 1.
template <class Choice>
void choice(Fields& fields, Choice& value, int high) {
  auto byte = static_cast<std::uint8_t>(value);
  fields.u8(byte);
  fields.require(byte >= 1 && byte <= high);
  value = static_cast<Choice>(byte);
}

void effect_type(Fields& fields, EffectType& type) {
  choice(fields, type, kEffectTypes);
}

}  // namespace

void exchange(Fields& fields, SetEffect& report) {
  block(fields, report.block);
  effect_type(fields, report.type);
  fields.u16(report.duration_ms);
  fields.u16(report.trigger_repeat_ms);
  fields.u16(report.sample_period_ms);
  fields.u16(report.start_delay_ms);
  fields.u8(report.gain);
  fields.u8(report.trigger_button);
  fields.flags(report.axis_x, report.axis_y, report.has_direction);
  number(fields, report.direction, kFullTurn);
  fields.u16(report.direction_2);
}

void exchange(Fields& fields, SetEnvelope& report) {
  block(fields, report.block);
  level(fields, report.attack_level);
  level(fields, report.fade_level);
  fields.u16(report.attack_ms);
  fields.u16(report.fade_ms);
}

void exchange(Fields& fields, SetCondition& report) {
  block(fields, report.block);
  fields.choice(report.offset, 2);
  signed_level(fields, report.centre);
  signed_level(fields, report.positive_coefficient);
  signed_level(fields, report.negative_coefficient);
  level(fields, report.positive_saturation);
  level(fields, report.negative_saturation);
  level(fields, report.dead_band);
}

void exchange(Fields& fields, SetPeriodic& report) {
  block(fields, report.block);
  level(fields, report.magnitude);
  signed_level(fields, report.offset);
  number(fields, report.phase, kFullTurn);
  fields.u16(report.period_ms);
}

void exchange(Fields& fields, SetConstant& report) {
  block(fields, report.block);
  signed_level(fields, report.magnitude);
}

void exchange(Fields& fields, SetRamp& report) {
  block(fields, report.block);
  signed_level(fields, report.start);
  signed_level(fields, report.end);
}

void exchange(Fields& fields, EffectOperation& report) {
  block(fields, report.block);
  choice(fields, report.operation, 3);
  fields.u8(report.loops);
}

void exchange(Fields& fields, BlockFree& report) {
  block(fields, report.block);
}

void exchange(Fields& fields, DeviceControl& report) {
  choice(fields, report.control, 6);
}

void exchange(Fields& fields, DeviceGain& report) {
  fields.u8(report.gain);
}

void exchange(Fields& fields, CreateNewEffect& report) {
  effect_type(fields, report.type);
  fields.u16(report.byte_count);
}

void exchange(Fields& fields, BlockLoad& report) {
  fields.choice(report.block, kMostBlocks + 1);
  choice(fields, report.status, 3);
  number(fields, report.available, kLongestTime);
}

void exchange(Fields& fields, Pool& report) {
  number(fields, report.size, kLongestTime);
  fields.u8(report.simultaneous);
  fields.flags(report.device_managed, report.shared_parameters);
}

void exchange(Fields& fields, PidState& report) {
  bool none = false;
  fields.flags(report.paused, report.actuators_enabled, none, report.actuator_override,
               report.actuator_power);
  fields.require(!none);
  auto byte = static_cast<std::uint8_t>(2U * report.block + (report.playing ? 1U : 0U));
  fields.u8(byte);
  report.playing = byte % 2U != 0;
  report.block = static_cast<std::uint8_t>(byte >> 1U);
  fields.require(report.block >= 1 && report.block <= kMostBlocks);
}

void exchange(Fields& fields, Joystick& report) {
  fields.u16(report.buttons);
  signed_number(fields, report.x, kFullStick);
  signed_number(fields, report.y, kFullStick);
}

}  // namespace batuta::pid
