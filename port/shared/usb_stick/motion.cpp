// SPDX-License-Identifier: MIT

#include "shared/usb_stick/motion.hpp"

namespace batuta::usb {

void Motion::take(const InputSample& sample) {
  const Vec2<float> position(sample.x, sample.y);
  const std::int32_t gap_us = elapsed_us(last_, sample.time);
  const bool follows = begun_ && gap_us > 0 && gap_us <= kLongestGapUs;
  const Vec2<float> from = stick_.position;
  const Vec2<float> before = stick_.velocity;
  stick_ = {};
  stick_.position = position;
  last_ = sample.time;
  begun_ = true;
  if (!follows) return;
  const float gap = static_cast<float>(gap_us) * kSecondsPerUs<float>;
  const float weight = gap / (gap + kMotionTimeConstant);
  stick_.velocity = before + ((position - from) / gap - before) * weight;
  stick_.acceleration = (stick_.velocity - before) / gap;
}

}  // namespace batuta::usb
