// SPDX-License-Identifier: MIT
#include "shared/simulated/axis.hpp"

#include "shared/simulated/transition.hpp"

namespace batuta::port_simulated {
namespace {

constexpr double kMostTurn = 0.25;  ///< rad of the hand's oscillation within a substep
constexpr int kMostEvents = 16;     ///< stick or slip within a substep
constexpr int kHalvings = 52;       ///< to the last bit of the time of an event

bool is_not_negative(double x) {
  return is_finite(x) && x >= 0;
}

Oscillator oscillator_of(const AxisSettings& settings) {
  return {settings.mass + settings.hand_mass, settings.hand_stiffness,
          settings.damping + settings.hand_damping};
}

int substeps_of(const AxisSettings& settings) {
  if (settings.friction == 0) return 1;  // no events
  const Oscillator oscillator = oscillator_of(settings);
  const double turn = std::sqrt(oscillator.stiffness / oscillator.mass) * settings.period;
  if (turn > kMostSubsteps * kMostTurn) return kMostSubsteps + 1;
  return static_cast<int>(turn / kMostTurn) + 1;
}

/// The series of a period's transition ends where it should. Not (x > y): NaN is beyond.
bool is_soft_enough(const AxisSettings& settings) {
  const Oscillator oscillator = oscillator_of(settings);
  const double span = settings.period;
  return (oscillator.stiffness * span + oscillator.damping) * span / oscillator.mass <=
         kStiffestSpan;
}

}  // namespace

Status validate(const AxisSettings& settings) {
  const bool mechanism = is_positive(settings.period) && is_positive(settings.mass) &&
                         is_not_negative(settings.damping) && is_not_negative(settings.friction) &&
                         settings.travel > 0;
  const bool hand = is_not_negative(settings.hand_mass) &&
                    is_not_negative(settings.hand_stiffness) &&
                    is_not_negative(settings.hand_damping);
  const bool good =
      mechanism && hand && is_soft_enough(settings) && substeps_of(settings) <= kMostSubsteps;
  return good ? Status::kOk : Status::kInvalidArgument;
}

Status SimulatedAxis::configure(const AxisSettings& settings) {
  const Status status = validate(settings);
  if (status != Status::kOk) return status;
  *this = SimulatedAxis();
  settings_ = settings;
  substeps_ = substeps_of(settings);
  whole_ = transition_of(oscillator_of(settings), settings.period / substeps_);
  return status;
}

void SimulatedAxis::place(double position, double velocity, double hand) {
  position_ = position;
  velocity_ = velocity;
  hand_ = hand;
}

double SimulatedAxis::energy() const {
  const double bent = position_ - hand_;
  return 0.5 * (mass() * velocity_ * velocity_ + settings_.hand_stiffness * bent * bent);
}

void SimulatedAxis::advance(double force, double hand_end) {
  const double hand_speed = (hand_end - hand_) / settings_.period;
  Push push;
  push.growth = settings_.hand_stiffness * hand_speed;
  push.length = settings_.period / substeps_;
  const double dragged = settings_.hand_damping * hand_speed;
  for (int i = 0; i < substeps_; ++i) {  // Bound: kMostSubsteps
    push.start = force + settings_.hand_stiffness * hand_ + dragged + push.growth * push.length * i;
    pass(push);
    stop();
  }
  hand_ = hand_end;
}

/// Through sticking and sliding. What is left after kMostEvents, it stands.
void SimulatedAxis::pass(const Push& push) {
  double t = 0;
  for (int i = 0; i < kMostEvents && t < push.length; ++i) {  // Bound: kMostEvents
    if (velocity_ == 0 && settings_.friction > 0) t = stay(push, t);
    if (t < push.length) t = slide(push, t);
  }
}

/// Until when friction holds a stick that stands.
double SimulatedAxis::stay(const Push& push, double from) const {
  const double held = settings_.hand_stiffness * position_;
  const double now = push.start + push.growth * from - held;
  const double last = push.start + push.growth * push.length - held;
  if (std::abs(now) > settings_.friction) return from;
  if (std::abs(last) <= settings_.friction) return push.length;
  const double needed = push.growth > 0 ? settings_.friction : -settings_.friction;
  return clamp(from + (needed - now) / push.growth, from, push.length);
}

Eigen::Vector2d SimulatedAxis::after(const Eigen::Vector4d& state, double span) const {
  if (span == settings_.period / substeps_) return whole_ * state;
  return transition_of(oscillator_of(settings_), span) * state;
}

/// Slides one way to the end, or until it stands. @returns when
double SimulatedAxis::slide(const Push& push, double from) {
  const double start = push.start + push.growth * from;
  const double driving = start - settings_.hand_stiffness * position_;
  const double way = (velocity_ != 0 ? velocity_ : driving) < 0 ? -1 : 1;
  const Eigen::Vector4d before(position_, velocity_, start - way * settings_.friction, push.growth);
  double length = push.length - from;
  Eigen::Vector2d reached = after(before, length);
  const bool turns = settings_.friction > 0 && way * reached[1] < 0;
  double sliding = 0;
  for (int i = 0; turns && i < kHalvings; ++i) {  // Bound: kHalvings
    const double middle = 0.5 * (sliding + length);
    reached = after(before, middle);
    if (way * reached[1] < 0) {
      length = middle;
    } else {
      sliding = middle;
    }
  }
  if (turns) reached[1] = 0;
  rubbed_ += settings_.friction * std::abs(reached[0] - position_);
  position_ = reached[0];
  velocity_ = reached[1];
  return turns ? from + length : push.length;
}

void SimulatedAxis::stop() {
  if (std::abs(position_) <= settings_.travel) return;
  position_ = clamp(position_, -settings_.travel, settings_.travel);
  if (position_ * velocity_ > 0) velocity_ = 0;
}

}  // namespace batuta::port_simulated
