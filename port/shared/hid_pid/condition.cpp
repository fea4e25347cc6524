// SPDX-License-Identifier: MIT

#include "shared/hid_pid/condition.hpp"

#include "batuta/core/types.hpp"
#include "shared/hid_pid/limits.hpp"

namespace batuta::pid {
namespace {

/// hid-pidff of Linux 7.2 and 7.3 sends the negative saturation as a number with a sign: the whole
/// range, 0xFFFF, arrives as 0. What lets nothing through on that side alone is taken for that.
int saturation_below(const Condition& condition) {
  return condition.negative_saturation == 0 ? condition.positive_saturation
                                            : condition.negative_saturation;
}

}  // namespace

float Condition::force(float metric, float knee) const {
  const float beyond_high = metric - share_of(centre + dead_band);
  const float beyond_low = metric - share_of(centre - dead_band);
  const bool above = beyond_high > 0.0F;
  if (!above && !(beyond_low < 0.0F)) return 0.0F;
  const float beyond = above ? beyond_high : beyond_low;
  const float step = knee < 1.0F ? clamp(beyond / knee, -1.0F, 1.0F) : beyond;
  const float coefficient = share_of(above ? positive_coefficient : negative_coefficient);
  const float most = share_of(above ? positive_saturation : saturation_below(*this));
  return clamp(coefficient * step, -most, most);
}

}  // namespace batuta::pid
