// SPDX-License-Identifier: MIT
#pragma once
// Which two axes of a device move the sword, which two the feet, and what their counts mean. Mice
// have relative axes; sticks, tablets and touch screens absolute ones; some touch devices speak of
// fingers only. A second stick, or else a hat, is for the feet.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "batuta/port/sample_builder.hpp"
#include "programs/devices/description.hpp"
#include "programs/devices/event_line.hpp"

namespace batuta::host {

/// A second pair of absolute axes.
struct FeetAxes {
  std::uint16_t code_x = 0;
  std::uint16_t code_y = 0;
  AxisCalibration x;
  AxisCalibration y;
};

struct MotionAxes {
  std::uint16_t type = 0;  ///< EV_REL or EV_ABS
  std::uint16_t code_x = 0;
  std::uint16_t code_y = 0;
  bool fingers = false;  ///< the codes are of one finger among several
  AxisCalibration x;
  AxisCalibration y;
  std::optional<FeetAxes> feet;
  std::string note;  ///< what had to be guessed; one line, or empty
};

/// The first of relative, absolute and finger axes that moves in the events. Feet beside absolute
/// axes: the second stick, or the hat, that moves and whose range the description tells.
/// @returns nothing if none does
std::optional<MotionAxes> find_motion_axes(const std::vector<DeviceEvent>& events,
                                           const std::optional<Description>& description);

/// What a live device says of itself.
struct Abilities {
  std::function<bool(std::uint16_t type, std::uint16_t code)> has;
  /// Of an absolute axis; nothing if it has none, or says that it is empty.
  std::function<std::optional<AxisRange>(std::uint16_t code)> range;
};

/// The first of relative, absolute and finger axes that the device has; beside absolute ones the
/// second stick or else the hat. A relative device reaches
/// the rim with a hand's width of an ordinary mouse: nothing is known of its strokes yet.
/// @returns nothing if it has none, or none with a range
std::optional<MotionAxes> find_motion_axes(const Abilities& device);

}  // namespace batuta::host
