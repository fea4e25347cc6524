// SPDX-License-Identifier: MIT
#pragma once
// A soft end of one axis of the stick, before the hard one: a spring and a damper that push inward
// and never outward. src/haptics/output_stage.md.

#include "batuta/core/status.hpp"

namespace batuta::haptics {

/// Shares are of the actuator's range, the unit is the stick's: its square is [-1, 1]^2.
struct EndStopSettings {
  float start = 0.95F;   ///< deflection at which it begins, > 0, finite
  float stiffness = 20;  ///< share for each unit beyond the start, >= 0, finite; 0: no end stop
  float damping = 0.1F;  ///< share for each unit/s, >= 0, finite
};

/// @returns kOk | kInvalidArgument: out of range
Status validate(const EndStopSettings& settings);

/// How hard the stop of the side where the stick is pushes inward: a share, 0 ... 1, and 0 within
/// the start. @param position, velocity  of the stick along the axis, units and 1/s, finite
float end_stop_push(const EndStopSettings& settings, float position, float velocity);

/// A force with the stop's push. What drives outward gives way as the push grows: at its strongest
/// the stop has the whole actuator, whatever was demanded.
/// @param share     the force, -1 ... 1
/// @param push      of end_stop_push()
/// @param position  of the stick, whose sign tells outward
/// @returns -1 ... 1, never further outward than `share`
float with_end_stop(float share, float push, float position);

}  // namespace batuta::haptics
