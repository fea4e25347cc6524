// SPDX-License-Identifier: MIT

#include "shared/hid_pid/effect.hpp"

#include "shared/hid_pid/direction.hpp"
#include "shared/hid_pid/limits.hpp"

namespace batuta::pid {
namespace {

constexpr std::uint32_t kUsPerMs = 1000;

/// A host has longer times than the descriptor announces: hid-pidff sends what a game asks for.
std::uint16_t time_of(std::uint16_t ms) {
  constexpr auto kLongest = static_cast<std::uint16_t>(kLongestTime);
  return ms < kLongest ? ms : kLongest;
}

const Vec2<float>& metric_of(EffectType type, const Metrics& metrics) {
  if (type == EffectType::kSpring) return metrics.position;
  return type == EffectType::kInertia ? metrics.acceleration : metrics.velocity;
}

}  // namespace

// The type of the report does not count. hid-pidff before Linux 6.15 sends the type created last
// when it changes another effect; to believe it would turn a spring into a wave.
bool Effect::set(const SetEffect& report) {
  set_ = true;
  duration_ms_ = report.duration_ms == kEndless ? std::uint16_t{0} : time_of(report.duration_ms);
  delay_ms_ = time_of(report.start_delay_ms);
  gain_ = report.gain;
  axis_x_ = report.axis_x;
  axis_y_ = report.axis_y;
  has_direction_ = report.has_direction;
  direction_ = direction_of(report.direction);
  return true;
}

bool Effect::set(const SetEnvelope& report) {
  if (is_condition(type_)) return false;
  envelope_ = {report.attack_level, report.fade_level, time_of(report.attack_ms),
               time_of(report.fade_ms)};
  return true;
}

bool Effect::set(const SetCondition& report) {
  if (!is_condition(type_)) return false;
  conditions_[report.offset] = {report.centre,
                                report.positive_coefficient,
                                report.negative_coefficient,
                                report.positive_saturation,
                                report.negative_saturation,
                                report.dead_band};
  blocks_ = static_cast<std::uint8_t>(blocks_ | (1U << report.offset));
  return true;
}

bool Effect::set(const SetPeriodic& report) {
  if (!is_periodic(type_)) return false;
  first_ = static_cast<std::int16_t>(report.magnitude);
  second_ = report.offset;
  phase_ = report.phase;
  period_ms_ = time_of(report.period_ms);
  return true;
}

bool Effect::set(const SetConstant& report) {
  if (type_ != EffectType::kConstant) return false;
  first_ = report.magnitude;
  return true;
}

bool Effect::set(const SetRamp& report) {
  if (type_ != EffectType::kRamp) return false;
  first_ = report.start;
  second_ = report.end;
  return true;
}

void Effect::start(std::uint8_t loops) {
  const std::uint32_t times = loops == kEndlessLoops ? 0U : loops;
  playback_.start(delay_ms_ * kUsPerMs, loops == 0 ? 1U : times);
}

void Effect::advance(std::uint32_t step_us) {
  playback_.advance(step_us, {duration_ms_ * kUsPerMs, period_ms_ * kUsPerMs});
}

/// The level that the envelope goes to, without it.
float Effect::steady() const {
  const float from = share_of(first_);
  if (type_ != EffectType::kRamp || duration_ms_ == 0) return from;
  const float done =
      static_cast<float>(playback_.elapsed_us()) / static_cast<float>(duration_ms_ * kUsPerMs);
  return from + (share_of(second_) - from) * done;
}

float Effect::wind() const {
  const float sustain = steady();
  const float size = sustain < 0.0F ? -sustain : sustain;
  const float level = envelope_.level(size, playback_.elapsed_us(), duration_ms_);
  if (!is_periodic(type_)) return sustain < 0.0F ? -level : level;
  float turn = static_cast<float>(phase_) / static_cast<float>(kFullTurn);
  if (period_ms_ > 0) {
    turn += static_cast<float>(playback_.cycle_us()) / static_cast<float>(period_ms_ * kUsPerMs);
  }
  turn -= static_cast<float>(static_cast<int>(turn));
  return share_of(second_) + level * waveform(type_, turn);
}

/// A wind blows from its direction. Without one it blows from the positive end of each axis that is
/// enabled, in HID's sense: from the right, and from the user.
Vec2<float> Effect::along_direction(float size) const {
  if (has_direction_) return direction_ * -size;
  return {axis_x_ ? -size : 0.0F, axis_y_ ? size : 0.0F};
}

float Effect::held(const Condition& condition, float metric, float knee) const {
  return condition.force(metric, type_ == EffectType::kFriction ? knee : 1.0F);
}

/// Two parameter blocks are the two axes', and are not rotated. One alone, whichever it is, lies
/// along the direction; without a direction it is that of the axes enabled. Y is HID's, towards the
/// user.
Vec2<float> Effect::condition_force(const Metrics& metrics) const {
  const Vec2<float>& metric = metric_of(type_, metrics);
  const float knee = metrics.friction_knee;
  const Condition& first = conditions_[blocks_ == kSecondBlock ? 1 : 0];
  if (!per_axis()) {
    const float along = clamp(metric.dot(direction_), -1.0F, 1.0F);
    return along_direction(held(first, along, knee));
  }
  const Condition& second = conditions_[(blocks_ & kSecondBlock) != 0 ? 1 : 0];
  const float x = has_direction_ || axis_x_ ? -held(first, metric.x(), knee) : 0.0F;
  const float y = has_direction_ || axis_y_ ? held(second, -metric.y(), knee) : 0.0F;
  return {x, y};
}

Vec2<float> Effect::force(const Metrics& metrics) const {
  if (!set_ || !playback_.sounding()) return {0.0F, 0.0F};
  const Vec2<float> whole =
      is_condition(type_) ? condition_force(metrics) : along_direction(wind());
  return whole * (static_cast<float>(gain_) / static_cast<float>(kFullGain));
}

}  // namespace batuta::pid
