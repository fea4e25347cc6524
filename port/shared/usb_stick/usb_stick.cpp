// SPDX-License-Identifier: MIT

#include "shared/usb_stick/usb_stick.hpp"

namespace batuta::usb {
namespace {

/// A stick speaks every millisecond; so many lost in a row are no jitter.
constexpr std::int32_t kSilentAfter = 20;

template <class Report>
InputReport packed(const Report& report) {
  InputReport packet;
  packet.id = static_cast<std::uint8_t>(Report::kId);
  packet.size = static_cast<std::uint8_t>(
      pid::encode(report, packet.bytes.data(), static_cast<int>(packet.bytes.size())));
  return packet;
}

}  // namespace

haptics::StageSettings default_stage() {
  haptics::StageSettings stage;
  stage.gain = {1.0F, 1.0F};
  stage.samples.silent_after = kSilentAfter;
  return stage;
}

UsbStick::UsbStick(ForceDevice& motor, const UsbStickSettings& settings)
    : settings_(settings), effects_(settings.scales), stage_(motor) {}

Status UsbStick::start() {
  const Status status = stage_.configure(settings_.stage);
  leave();
  return status;
}

void UsbStick::tick(const InputSample* fresh, Host host, Microseconds now) {
  now_ = now;
  if (fresh != nullptr) {
    motion_.take(*fresh);
    joystick_ = pid::joystick_of(*fresh);
    effects_.tell_stick(joystick_);
  }
  follow(host);
  const pid::Stick& stick = motion_.stick();
  haptics::StageInput input;
  input.time = now;
  input.demanded = effects_.force(stick, now);
  input.position = stick.position;
  input.velocity = stick.velocity;
  input.fresh_sample = fresh != nullptr;
  input.fresh_command = true;  // the effects are here, whatever the host does
  effects_.tell_actuator(stage_.step(input) == Status::kOk);
}

/// The emergency stop is what no limit of the stage slows down.
void UsbStick::follow(Host host) {
  if (host == Host::kAwake) {
    if (!stage_.is_stopped()) return;
    stage_.reset();
    (void)stage_.enable();  // not configured: each step says so, and tells the motor nothing
  } else {
    sleep();  // also where the stack has not called back: a bus reset is not told
  }
}

void UsbStick::leave() {
  effects_.forget_host();
  cut();
}

void UsbStick::sleep() {
  effects_.silence();
  cut();
}

void UsbStick::cut() {
  if (!stage_.is_stopped()) stage_.stop(now_);
}

InputReport UsbStick::next_report() {
  pid::PidState state;
  told_state_ = !told_state_ && effects_.next_state(state);
  return told_state_ ? packed(state) : packed(joystick_);
}

}  // namespace batuta::usb
