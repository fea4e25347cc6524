// SPDX-License-Identifier: MIT

#include "batuta/haptics/output_stage.hpp"

namespace batuta::haptics {
namespace {

/// The fade is a ramp whose life is being enabled: it goes the same way back.
RampSettings fade_ramp(const StageSettings& settings) {
  return {0, settings.fade};
}

bool is_good(const StageSettings& settings) {
  return is_positive(settings.dt) && is_positive(settings.gain.x()) &&
         is_positive(settings.gain.y()) && is_positive(settings.slew_rate) &&
         is_positive(settings.slew_rate * settings.dt) &&
         is_finite(settings.speed_limit.integral * settings.dt);
}

/// Only what can be computed with: whatever is demanded has to be a number as a share, too.
bool is_usable(const StageInput& input, const Vec2<float>& gain) {
  return is_finite(scaled(input.demanded, gain)) && is_finite(input.position) &&
         is_finite(input.velocity) && input.allowed >= 0.0F && input.allowed <= 1.0F &&
         is_finite(input.excess) && input.excess >= 0.0F;
}

StageInput without_demand(Microseconds time) {
  StageInput input;
  input.time = time;
  return input;
}

}  // namespace

Status validate(const StageSettings& settings) {
  const bool good =
      is_good(settings) && validate(settings.end_stop) == Status::kOk &&
      validate(settings.speed_limit) == Status::kOk && validate(settings.samples) == Status::kOk &&
      validate(settings.commands) == Status::kOk && validate(fade_ramp(settings)) == Status::kOk;
  return good ? Status::kOk : Status::kInvalidArgument;
}

Status OutputStage::configure(const StageSettings& settings) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  gain_ = settings.gain;
  end_stop_ = settings.end_stop;
  for (Axis& axis : axes_) {  // Bound: 2; all valid
    (void)axis.speed.configure(settings.speed_limit, settings.dt);
    (void)axis.slew.configure(settings.slew_rate * settings.dt);
  }
  (void)samples_.configure(settings.samples);
  (void)commands_.configure(settings.commands);
  (void)fade_.configure(fade_ramp(settings));
  limits_ = {};
  report_ = {};
  allowed_ = 1;
  enabled_ = false;
  configured_ = true;
  (void)cut(last_command_.time);  // a device that is gone says so in the first step
  return Status::kOk;
}

Status OutputStage::enable() {
  if (!configured_) return Status::kInvalidArgument;
  if (is_stopped()) return Status::kUnavailable;
  enabled_ = true;
  return Status::kOk;
}

void OutputStage::stop(Microseconds time) {
  stopped_.store(true);  // first: a step that goes on behind this call sees it
  (void)device_.off(time);
}

void OutputStage::reset() {
  stopped_.store(false);  // first: a stop() that comes in behind it is another one, and stays
  drop_force();
}

Status OutputStage::step(const StageInput& input) {
  if (!configured_) return Status::kInvalidArgument;
  const bool usable = is_usable(input, gain_);
  if (usable) allowed_ = input.allowed;
  const StageInput used = usable ? input : without_demand(input.time);
  ++report_.steps;
  if (!usable) ++report_.invalid;
  limits_ = {};
  const Vec2<float> share = shaped(used);
  const float left = ramped(used);
  const Status status = hand_over({used.time, left * share.x(), left * share.y(), left});
  return status == Status::kOk && !usable ? Status::kInvalidArgument : status;
}

/// Shares of the range, from the demand to the slew limit.
Vec2<float> OutputStage::shaped(const StageInput& input) {
  const ForceShare force = clipped(scaled(input.demanded, gain_));
  limits_.clipped = force.is_clipped() || input.clipped;
  if (limits_.clipped) ++report_.clipped;
  report_.worst_excess = max_of(report_.worst_excess, max_of(force.excess, input.excess));
  return {limited(axes_[0], force.share.x(), input.position.x(), input.velocity.x()),
          limited(axes_[1], force.share.y(), input.position.y(), input.velocity.y())};
}

float OutputStage::limited(Axis& axis, float share, float position, float velocity) {
  const float push = end_stop_push(end_stop_, position, velocity);
  const float stopped = with_end_stop(share, push, position);
  const float slower = axis.speed.limited(stopped, velocity);
  const float slewed = axis.slew.towards(slower);
  if (push > 0.0F) limits_.end_stop = true;
  if (slower != stopped) limits_.speed = true;
  if (slewed != slower) limits_.slew = true;
  return slewed;
}

/// What is left when each ramp has had its say: the least. Two that fall for the same reason fall
/// no faster than one.
float OutputStage::ramped(const StageInput& input) {
  samples_.advance(input.fresh_sample);
  commands_.advance(input.fresh_command);
  fade_.advance(enabled_);
  report_.sample_silences = samples_.silences();
  report_.command_silences = commands_.silences();
  const float alive = min_of(samples_.share(), commands_.share());
  const float left = min_of(min_of(fade_.share(), allowed_), alive);
  limits_.ramped = left < 1.0F;
  return left;
}

Status OutputStage::hand_over(const ForceCommand& command) {
  if (!is_stopped()) {
    last_command_ = command;
    const Status status = device_.write(command, ForcePermit());
    if (status != Status::kOk) {
      ++report_.refused;
      fade_.drop();
    }
    if (!is_stopped()) return status;
  }
  // Also where stop() came in between and the device was told zero before the command.
  ++report_.stops;
  drop_force();
  (void)cut(command.time);
  return Status::kUnavailable;
}

/// Zero at once. @returns of the device
Status OutputStage::cut(Microseconds time) {
  last_command_ = {time, 0.0F, 0.0F, 0.0F};
  return device_.off(time);
}

/// As after configure(): disabled, with nothing left.
void OutputStage::drop_force() {
  enabled_ = false;
  fade_.drop();
  for (Axis& axis : axes_) axis.slew.drop();  // Bound: 2
}

}  // namespace batuta::haptics
