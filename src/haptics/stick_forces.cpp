// SPDX-License-Identifier: MIT

#include "batuta/haptics/stick_forces.hpp"

#include "batuta/haptics/force_share.hpp"

namespace batuta::haptics {
using fencing::Side;
namespace {

HandForceSettings<float> feel_of(const ForceSettings& settings) {
  HandForceSettings<float> feel = settings.feel;
  feel.transient.max_force = settings.full_scale;
  return feel;
}

}  // namespace

Status validate(const ForceSettings& settings) {
  const bool good = is_positive(settings.full_scale) && is_positive(settings.gain().x()) &&
                    validate(settings.ramp) == Status::kOk &&
                    validate(settings.speed_limit) == Status::kOk &&
                    validate(feel_of(settings)) == Status::kOk;
  return good ? Status::kOk : Status::kInvalidArgument;
}

Status StickForces::configure(const ForceSettings& settings) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  full_scale_ = settings.full_scale;
  forces_ = {};
  stale_steps_ = 0;
  exchange_ = 1;
  for (ForceRamp& ramp : ramps_) (void)ramp.configure(settings.ramp);             // Bound: 2; valid
  for (HandForce<float>& hand : hands_) (void)hand.configure(feel_of(settings));  // Bound: 2; valid
  return Status::kOk;
}

/// Both have been put on guard.
void StickForces::leap(std::uint32_t exchange) {
  for (HandForce<float>& hand : hands_) hand.leap();  // Bound: 2
  exchange_ = exchange;
}

void StickForces::take(Side side, const Vec2<float>& demanded, bool fresh) {
  ForceRamp& ramp = ramps_[index_of(side)];
  ramp.advance(fresh);
  const float least = kLeastFeltShare * full_scale_;
  Vec2<float> felt = demanded;
  for (int i = 0; i < 2; ++i) {  // Bound: the stick's coordinates
    if (std::abs(felt[i]) < least) felt[i] = 0.0F;
  }
  StickForce& force = forces_[index_of(side)];
  force = force_of(felt, ramp);
  // The hand's pulses and coupling come cut to the range, and as zero where they are no number.
  const HandForce<float>& hand = hands_[index_of(side)];
  force.limited = force.limited || hand.is_clipped() || hand.is_invalid();
  force.excess = max_of(force.excess, hand.excess());
}

/// By the output stage's own first step, and its watchdog over the samples.
StickForce StickForces::force_of(const Vec2<float>& demanded, const ForceRamp& ramp) const {
  const Vec2<float> whole = scaled(demanded, Vec2<float>::Constant(1.0F / full_scale_));
  const bool usable = is_finite(whole);
  const ForceShare force = usable ? clipped(whole) : ForceShare{};
  const float left = ramp.share();
  return {
      demanded,         left,       left * force.share, force.excess, !usable || force.is_clipped(),
      ramp.is_silent(), left < 1.0F};
}

}  // namespace batuta::haptics
