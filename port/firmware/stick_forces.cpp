// SPDX-License-Identifier: MIT

#include "firmware/stick_forces.hpp"

namespace batuta::firmware {

Status validate(const ForceSettings& settings) {
  if (!(settings.full_scale > 0.0F) || !is_finite(settings.full_scale)) {
    return Status::kInvalidArgument;
  }
  return validate(settings.ramp);
}

Status StickForces::configure(const ForceSettings& settings) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  settings_ = settings;
  forces_ = {};
  stale_steps_ = 0;
  for (ForceRamp& ramp : ramps_) (void)ramp.configure(settings.ramp);  // Bound: 2; valid
  return Status::kOk;
}

void StickForces::advance(const DuelType& duel, const std::array<bool, 2>& fresh) {
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    ForceRamp& ramp = ramps_[index_of(side)];
    ramp.advance(fresh[index_of(side)]);
    const KeyedPose<float>& hand = duel.hand(side);
    const Momentum<float> blow = blow_about(hand.X_WH.p_W, side, duel.world().events());
    const ForceShare force =
        as_share(stick_force(hand.jacobian, blow, duel.dt()), settings_.full_scale);
    const float share = ramp.share();
    forces_[index_of(side)] = {share * force.share, force.limited, ramp.is_silent(), share < 1.0F};
  }
  if (forces_[0].silent || forces_[1].silent) ++stale_steps_;
}

}  // namespace batuta::firmware
