// SPDX-License-Identifier: MIT

#include "batuta/haptics/speed_limiter.hpp"

#include "batuta/core/types.hpp"

namespace batuta::haptics {

Status validate(const SpeedLimitSettings& settings) {
  const bool good = is_positive(settings.limit) && is_finite(settings.proportional) &&
                    settings.proportional >= 0.0F && is_finite(settings.integral) &&
                    settings.integral >= 0.0F;
  return good ? Status::kOk : Status::kInvalidArgument;
}

Status SpeedLimiter::configure(const SpeedLimitSettings& settings, float dt) {
  const float integral_step = settings.integral * dt;
  const bool good = is_positive(dt) && is_finite(integral_step);
  if (!good || validate(settings) != Status::kOk) return Status::kInvalidArgument;
  settings_ = settings;
  integral_step_ = integral_step;
  memory_ = 0;
  return Status::kOk;
}

float SpeedLimiter::limited(float share, float velocity) {
  const float excess = std::abs(velocity) - settings_.limit;
  memory_ = clamp(memory_ + integral_step_ * excess, 0.0F, 1.0F);
  const bool drives = share > 0.0F ? velocity > 0.0F : velocity < 0.0F;
  const float taken = settings_.proportional * excess + memory_;
  if (!drives || !(taken > 0.0F)) return share;
  const float left = max_of(std::abs(share) - taken, 0.0F);
  return share > 0.0F ? left : -left;
}

}  // namespace batuta::haptics
