// SPDX-License-Identifier: MIT

#include "batuta/haptics/end_stop.hpp"

#include "batuta/core/types.hpp"

namespace batuta::haptics {

Status validate(const EndStopSettings& settings) {
  const bool good = is_positive(settings.start) && is_finite(settings.stiffness) &&
                    settings.stiffness >= 0.0F && is_finite(settings.damping) &&
                    settings.damping >= 0.0F;
  return good ? Status::kOk : Status::kInvalidArgument;
}

float end_stop_push(const EndStopSettings& settings, float position, float velocity) {
  const float outward = position < 0.0F ? -velocity : velocity;
  const float depth = std::abs(position) - settings.start;
  if (settings.stiffness == 0.0F || depth <= 0.0F) return 0.0F;
  const float push = settings.stiffness * depth + settings.damping * outward;
  return push > 0.0F ? min_of(push, 1.0F) : 0.0F;  // 0 too where both terms are beyond all numbers
}

float with_end_stop(float share, float push, float position) {
  const float side = position < 0.0F ? -1.0F : 1.0F;
  const float outward = side * share;
  const float left = outward > 0.0F ? outward * (1.0F - push) : outward;
  return side * max_of(left - push, -1.0F);
}

}  // namespace batuta::haptics
