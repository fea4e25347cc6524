// SPDX-License-Identifier: MIT

#include "batuta/haptics/force_share.hpp"

namespace batuta::haptics {

ForceShare clipped(const Vec2<float>& share) {
  const float largest = max_of(std::abs(share.x()), std::abs(share.y()));
  if (largest <= 1.0F) return {share, 0.0F};
  return {share / largest, largest - 1.0F};
}

}  // namespace batuta::haptics
