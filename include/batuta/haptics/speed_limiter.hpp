// SPDX-License-Identifier: MIT
#pragma once
// No force drives an axis of the stick ever faster: a stick that runs away, or that nobody holds,
// loses the force along its motion. A force that brakes is left alone. src/haptics/output_stage.md.

#include "batuta/core/status.hpp"

namespace batuta::haptics {

/// From which speed on a force gives way, and how much.
struct SpeedLimitSettings {
  float limit = 12;           ///< speed from which on the force gives way, 1/s, > 0, finite
  float proportional = 0.1F;  ///< share taken for each 1/s too fast, >= 0, finite
  float integral = 1;         ///< share taken for each unit too far, that is 1/s too fast for 1 s;
                              ///< >= 0, finite
};

/// @returns kOk | kInvalidArgument: out of range
Status validate(const SpeedLimitSettings& settings);

/// Of one axis. Allocates: never.
class SpeedLimiter {
 public:
  /// Starts anew. @param dt  length of a step, s, > 0, finite
  /// @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const SpeedLimitSettings& settings, float dt);

  /// A step. @param share  the force  @param velocity  of the stick along the axis, 1/s
  /// @pre both finite. Bound: no loop.
  /// @returns share, or less of it where it points along the motion; never another sign, never more
  float limited(float share, float velocity);

 private:
  SpeedLimitSettings settings_;
  float integral_step_ = 0;  ///< share for each 1/s too fast in one step
  float memory_ = 0;         ///< of the integral, 0 ... 1
};

}  // namespace batuta::haptics
