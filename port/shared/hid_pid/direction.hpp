// SPDX-License-Identifier: MIT
#pragma once
// Where a force comes from. An angle of HID, DirectInput, SDL and Linux alike counts clockwise from
// north, which is away from the user, and names the wind: a force from the north pushes the stick
// south, towards the user. Here x is right and y is up (north), as in batuta/port; HID's own Y
// grows towards the user.

#include "batuta/core/types.hpp"
#include "shared/hid_pid/limits.hpp"

namespace batuta::pid {

inline constexpr float kRadiansPerTurn = 0x1.921fb6p+2F;  ///< 2 pi

/// The unit vector towards a direction: (0, 1) for north, (1, 0) for a quarter turn, east. Exact at
/// the four winds, error of each component <= 4 ulp of 1 elsewhere.
/// @param angle  of kFullTurn; a full turn and more wrap
/// Bound: one sine.
Vec2<float> direction_of(unsigned angle);

}  // namespace batuta::pid
