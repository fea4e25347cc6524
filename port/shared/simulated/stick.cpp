// SPDX-License-Identifier: MIT
#include "shared/simulated/stick.hpp"

#include "shared/simulated/encoder.hpp"

namespace batuta::port_simulated {
namespace {

constexpr double kUsPerSecond = 1e6;
constexpr double kLongestPeriod = 1;  // s

bool is_valid(const StickSettings& settings) {
  const bool axes = validate(settings.x) == Status::kOk && validate(settings.y) == Status::kOk &&
                    settings.x.period == settings.y.period && settings.x.period <= kLongestPeriod;
  const bool loop = settings.delay >= 0 && settings.delay <= kMostDelay && settings.silence > 0;
  return axes && loop && is_positive(settings.force_limit) && is_finite(settings.encoder_step) &&
         settings.encoder_step >= 0;
}

}  // namespace

SimulatedStick::SimulatedStick() : input_(*this), force_(*this) {
  for (Vec2<double>& command : commands_) command.setZero();  // Bound: kMostDelay + 1
}

Status SimulatedStick::configure(const StickSettings& settings) {
  if (!is_valid(settings)) return Status::kInvalidArgument;
  const double period_us = std::round(settings.x.period * kUsPerSecond);
  if (period_us < 1 || settings.x.period != period_us / kUsPerSecond) {
    return Status::kInvalidArgument;
  }
  settings_ = settings;
  (void)x_.configure(settings.x);
  (void)y_.configure(settings.y);
  for (Vec2<double>& command : commands_) command.setZero();  // Bound: kMostDelay + 1
  held_.setZero();
  sample_ = InputSample{};
  period_ = static_cast<Microseconds>(period_us);
  now_ = 0;
  commanded_ = 0;
  is_new_ = false;
  is_plugged_ = true;
  return Status::kOk;
}

/// The force whose time has come; the commands after it move up.
Vec2<double> SimulatedStick::due() {
  const bool is_silent = !is_plugged_ || now_ - commanded_ >= settings_.silence;
  if (is_silent) commands_[0].setZero();
  const Vec2<double> command = commands_[settings_.delay];
  for (int i = settings_.delay; i > 0; --i) commands_[i] = commands_[i - 1];  // Bound: kMostDelay
  return is_plugged_ ? command : Vec2<double>(0, 0);
}

float SimulatedStick::seen(double position) const {
  return static_cast<float>(clamp(encoded(position, settings_.encoder_step), -1.0, 1.0));
}

void SimulatedStick::advance(const Vec2<double>& hand) {
  held_ = settings_.force_limit * due();
  x_.advance(held_.x(), hand.x());
  y_.advance(held_.y(), hand.y());
  now_ += period_;
  sample_.time = now_;
  sample_.x = seen(x_.position());
  sample_.y = seen(y_.position());
  ++sample_.sequence;
  is_new_ = true;
}

void SimulatedStick::plug(bool is_plugged) {
  is_plugged_ = is_plugged;
  is_new_ = false;
}

Status SimulatedStick::Input::do_read(Microseconds now, InputSample& sample) {
  const bool is_there = stick_.is_plugged_ && stick_.is_new_;
  if (!is_there || is_later(stick_.sample_.time, now)) return Status::kUnavailable;
  sample = stick_.sample_;
  stick_.is_new_ = false;
  return Status::kOk;
}

Status SimulatedStick::Force::do_write(const ForceCommand& command) {
  if (!stick_.is_plugged_) return Status::kUnavailable;
  stick_.commands_[0] = {static_cast<double>(command.x), static_cast<double>(command.y)};
  stick_.commanded_ = stick_.now_;
  return Status::kOk;
}

}  // namespace batuta::port_simulated
