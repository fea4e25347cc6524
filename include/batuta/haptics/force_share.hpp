// SPDX-License-Identifier: MIT
#pragma once
// A force on the stick as shares of what the actuator has: the first step of the output stage.
// Everything behind it works within the range, and keeps it: src/haptics/output_stage.md.

#include "batuta/core/types.hpp"

namespace batuta::haptics {

/// Within the range, and how far it was outside.
struct ForceShare {
  Vec2<float> share = Vec2<float>::Zero();  ///< each in [-1, 1]
  float excess = 0;  ///< by how much the larger coordinate was beyond 1; 0: it fits

  /// Whether it did not fit.
  bool is_clipped() const { return excess > 0.0F; }
};

/// The force as shares, however large.
/// @param force  N m for each unit of the stick  @param gain  shares for each N m, by axis
inline Vec2<float> scaled(const Vec2<float>& force, const Vec2<float>& gain) {
  return force.cwiseProduct(gain);
}

/// What does not fit keeps its direction and becomes as long as fits: the larger coordinate is then
/// 1 or -1, exactly. @pre finite
ForceShare clipped(const Vec2<float>& share);

}  // namespace batuta::haptics
