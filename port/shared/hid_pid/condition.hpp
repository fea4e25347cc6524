// SPDX-License-Identifier: MIT
#pragma once
// The law of springs, dampers, inertia and friction: a force against a metric of the stick, its
// position, velocity or acceleration.

#include <cstdint>

namespace batuta::pid {

/// One axis of a condition, as its report has it: of kFullLevel each.
struct Condition {
  std::int16_t centre = 0;
  std::int16_t positive_coefficient = 0;
  std::int16_t negative_coefficient = 0;
  std::uint16_t positive_saturation = 0;  ///< 0 lets no force through
  std::uint16_t negative_saturation = 0;  ///< 0: as the positive one
  std::uint16_t dead_band = 0;

  /// The force that the condition comes with: to be put on the axis with the opposite sign, so that
  /// a positive coefficient holds the stick. With c the centre and d the dead band: 0 where |q - c|
  /// <= d, k (q - (c + d)) above and k (q - (c - d)) below, each with the coefficient and the
  /// saturation of its side.
  /// Source: PID 1.0, set condition report; DirectInput, DICONDITION.
  /// @param metric  q, finite, -1 ... 1
  /// @param knee    how far beyond the dead band the force has its full size; 1 for the law above.
  ///                Friction takes little: its force is nearly the same at every velocity, yet
  ///                without a jump at rest
  /// Bound: no loop.
  float force(float metric, float knee) const;
};

}  // namespace batuta::pid
