// SPDX-License-Identifier: MIT
#pragma once
// Which two axes of a device move the sword, and what their counts mean. Mice have relative axes;
// sticks, tablets and touch screens absolute ones; some touch devices speak of fingers only.

#include <optional>
#include <string>
#include <vector>

#include "batuta/port/sample_builder.hpp"
#include "host/devices/description.hpp"
#include "host/devices/event_line.hpp"

namespace batuta::host {

struct MotionAxes {
  std::uint16_t type = 0;  ///< EV_REL or EV_ABS
  std::uint16_t code_x = 0;
  std::uint16_t code_y = 0;
  bool fingers = false;  ///< the codes are of one finger among several
  AxisCalibration x;
  AxisCalibration y;
  std::string note;  ///< what had to be guessed; one line, or empty
};

/// The first of relative, absolute and finger axes that moves in the events.
/// @returns nothing if none does
std::optional<MotionAxes> find_motion_axes(const std::vector<DeviceEvent>& events,
                                           const std::optional<Description>& description);

}  // namespace batuta::host
