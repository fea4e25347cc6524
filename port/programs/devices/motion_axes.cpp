// SPDX-License-Identifier: MIT

#include "programs/devices/motion_axes.hpp"

#include <linux/input.h>

#include <algorithm>
#include <array>
#include <limits>

namespace batuta::host {
namespace {

/// Counts of a relative device from the centre to the rim: a hand's width on an ordinary mouse.
constexpr std::int32_t kRelativeReach = 400;
/// A stroke is what happens within this time; see reach_of().
constexpr std::int64_t kStroke_us = 1'000'000;

struct Candidate {
  std::uint16_t type;
  std::uint16_t code_x;
  std::uint16_t code_y;
  bool fingers;
};

constexpr std::array<Candidate, 3> kCandidates = {{
    {EV_REL, REL_X, REL_Y, false},
    {EV_ABS, ABS_X, ABS_Y, false},
    {EV_ABS, ABS_MT_POSITION_X, ABS_MT_POSITION_Y, true},
}};

/// For the feet: a second stick, a hat.
constexpr std::array<Candidate, 2> kFeet = {{
    {EV_ABS, ABS_RX, ABS_RY, false},
    {EV_ABS, ABS_HAT0X, ABS_HAT0Y, false},
}};

MotionAxes uncalibrated(const Candidate& candidate) {
  MotionAxes axes;
  axes.type = candidate.type;
  axes.code_x = candidate.code_x;
  axes.code_y = candidate.code_y;
  axes.fingers = candidate.fingers;
  return axes;
}

bool moves(const std::vector<DeviceEvent>& events, const Candidate& axes) {
  return std::any_of(events.begin(), events.end(), [&](const DeviceEvent& event) {
    return event.type == axes.type && (event.code == axes.code_x || event.code == axes.code_y);
  });
}

/// The counts that an axis has reported; around its only one if it has not moved, so that this is
/// the centre.
AxisRange observed(const std::vector<DeviceEvent>& events, std::uint16_t code) {
  AxisRange range{std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), 0};
  for (const DeviceEvent& event : events) {
    if (event.type != EV_ABS || event.code != code) continue;
    range.min = std::min(range.min, event.value);
    range.max = std::max(range.max, event.value);
  }
  if (range.min < range.max) return range;
  const int only = range.min == range.max ? range.min : 0;
  return {only - (only > std::numeric_limits<int>::min() ? 1 : 0),
          only + (only < std::numeric_limits<int>::max() ? 1 : 0), 0};
}

/// Up is a smaller count in the whole input stack, on screens and sticks alike.
AxisCalibration calibrate(AxisKind kind, const AxisRange& range, bool vertical) {
  AxisCalibration axis;
  axis.kind = kind;
  axis.reversed = vertical;
  axis.min = range.min;
  axis.max = range.max;
  axis.flat = range.flat;
  if (!is_valid(axis)) axis.flat = 0;
  return axis;
}

/// From the centre to the rim. A mouse with a fine grid would hit the rim with every twitch; half
/// of its widest stroke is then the measure.
std::int32_t reach_of(const std::vector<DeviceEvent>& events, std::uint16_t code) {
  std::int64_t position = 0;
  std::int64_t lowest = 0;
  std::int64_t highest = 0;
  std::int64_t widest = 0;
  std::int64_t stroke_start_us = events.front().time_us;
  for (const DeviceEvent& event : events) {
    if (event.time_us - stroke_start_us > kStroke_us) {
      stroke_start_us = event.time_us;
      lowest = highest = position;
    }
    if (event.type != EV_REL || event.code != code) continue;
    position += event.value;
    lowest = std::min(lowest, position);
    highest = std::max(highest, position);
    widest = std::max(widest, highest - lowest);
  }
  const std::int64_t limit = std::numeric_limits<std::int32_t>::max() / 2;
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(widest / 2, kRelativeReach, limit));
}

void calibrate_relative(MotionAxes& axes, const std::vector<DeviceEvent>& events) {
  const std::int32_t reach = std::max(reach_of(events, axes.code_x), reach_of(events, axes.code_y));
  axes.x = calibrate(AxisKind::kRelative, {-reach, reach, 0}, false);
  axes.y = calibrate(AxisKind::kRelative, {-reach, reach, 0}, true);
}

AxisCalibration calibrate_absolute(MotionAxes& axes, const std::vector<DeviceEvent>& events,
                                   const std::optional<Description>& description, bool vertical) {
  const std::uint16_t code = vertical ? axes.code_y : axes.code_x;
  std::optional<AxisRange> range = description ? description->range(code) : std::nullopt;
  if (!range) {
    range = observed(events, code);
    axes.note = "the device's axis ranges are not known; taken from the counts in the recording";
  }
  return calibrate(AxisKind::kAbsolute, *range, vertical);
}

/// @param is_used   whether a pair of axes is to be looked at
/// @param range_of  of the axis with this code, or nothing
template <class IsUsed, class RangeOf>
std::optional<FeetAxes> find_feet(const MotionAxes& axes, const IsUsed& is_used,
                                  const RangeOf& range_of) {
  if (axes.type != EV_ABS || axes.fingers) return std::nullopt;
  for (const Candidate& feet : kFeet) {  // Bound: kFeet
    if (!is_used(feet)) continue;
    const std::optional<AxisRange> x = range_of(feet.code_x);
    const std::optional<AxisRange> y = range_of(feet.code_y);
    if (!x || !y) continue;
    return FeetAxes{feet.code_x, feet.code_y, calibrate(AxisKind::kAbsolute, *x, false),
                    calibrate(AxisKind::kAbsolute, *y, true)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<MotionAxes> find_motion_axes(const std::vector<DeviceEvent>& events,
                                           const std::optional<Description>& description) {
  const auto* found = std::find_if(kCandidates.begin(), kCandidates.end(),
                                   [&](const Candidate& axes) { return moves(events, axes); });
  if (found == kCandidates.end()) return std::nullopt;
  MotionAxes axes = uncalibrated(*found);
  if (axes.type == EV_REL) {
    calibrate_relative(axes, events);
  } else {
    axes.x = calibrate_absolute(axes, events, description, false);
    axes.y = calibrate_absolute(axes, events, description, true);
  }
  if (description) {
    axes.feet = find_feet(
        axes, [&](const Candidate& feet) { return moves(events, feet); },
        [&](std::uint16_t code) { return description->range(code); });
  }
  return axes;
}

std::optional<MotionAxes> find_motion_axes(const Abilities& device) {
  for (const Candidate& candidate : kCandidates) {  // Bound: kCandidates
    const bool both = device.has(candidate.type, candidate.code_x) &&
                      device.has(candidate.type, candidate.code_y);
    if (!both) continue;
    MotionAxes axes = uncalibrated(candidate);
    const bool relative = axes.type == EV_REL;
    const AxisRange reach{-kRelativeReach, kRelativeReach, 0};
    const std::optional<AxisRange> x = relative ? reach : device.range(axes.code_x);
    const std::optional<AxisRange> y = relative ? reach : device.range(axes.code_y);
    if (!x || !y) continue;
    const AxisKind kind = relative ? AxisKind::kRelative : AxisKind::kAbsolute;
    axes.x = calibrate(kind, *x, false);
    axes.y = calibrate(kind, *y, true);
    axes.feet = find_feet(
        axes,
        [&](const Candidate& feet) {
          return device.has(feet.type, feet.code_x) && device.has(feet.type, feet.code_y);
        },
        device.range);
    return axes;
  }
  return std::nullopt;
}

}  // namespace batuta::host
