// SPDX-License-Identifier: MIT
#pragma once
// From single axis events to whole samples: what every port does between its device and
// InputDevice::do_read(). A device says "x is at 812", "y moved by -3", "button 0 is down", and
// then "that was all of it" (the sync mark). Where events were lost on the way, what came in
// between is a mixture of two states, and is discarded. Integers up to the last division: a stick
// that returns to a count returns to the same bits.

#include <array>

#include "batuta/port/input.hpp"

namespace batuta {

/// One of the axes of a device: those of its stick, and those of a second pair, if it has one.
enum class Axis : std::uint8_t {
  kX,      ///< to the right
  kY,      ///< up
  kFeetX,  ///< to the right, of the second pair
  kFeetY,  ///< up, of the second pair
};

/// What the counts of an axis mean.
enum class AxisKind : std::uint8_t {
  kAbsolute,  ///< an event says where the axis is
  kRelative,  ///< an event says by how much it moved; the sum is held in [min, max]
};

/// How counts of a device become a deflection. For a relative axis, min and max choose the gain: 2
/// / (max - min) a count.
struct AxisCalibration {
  AxisKind kind = AxisKind::kAbsolute;  ///< what the counts mean
  bool reversed = false;                ///< counts grow to the left or downwards
  std::int32_t min = -32767;  ///< counts at one rim; beyond it the axis is taken to be at the rim
  std::int32_t max = 32767;   ///< counts at the other
  std::int32_t flat = 0;      ///< dead zone: so many counts to either side of the centre are 0
};

/// A kind that there is, min < max, and flat leaves something of the axis.
constexpr bool is_valid(const AxisCalibration& axis) {
  return axis.kind <= AxisKind::kRelative && axis.min < axis.max && axis.flat >= 0 &&
         2 * std::int64_t{axis.flat} < std::int64_t{axis.max} - axis.min;
}

/// The deflection at `counts`: 0 in the dead zone, +-1 at the rims, linear and continuous between
/// them.
/// @pre is_valid(axis)
/// Bound: no loop; |error| <= 1.5 units in the last place; monotone.
float deflection(const AxisCalibration& axis, std::int32_t counts);

/// Collects events and gives a sample at each sync mark. One for each device; not for several
/// threads.
class SampleBuilder {
 public:
  static constexpr int kMaxButtons = 32;  ///< as many as InputSample::buttons has bits

  /// Calibrates and starts anew: both axes at their centre, or half a count off it where it lies
  /// between two (one of 0 ... 255 at 127), no second pair, no button pressed, sequence 0.
  /// @returns kOk | kInvalidArgument: !is_valid(x) or !is_valid(y); nothing changed
  Status configure(const AxisCalibration& x, const AxisCalibration& y);

  /// There is a second pair of axes, at their centre as in configure(). Without it they are zero.
  /// @returns kOk | kInvalidArgument: !is_valid(x) or !is_valid(y); nothing changed
  Status configure_feet(const AxisCalibration& x, const AxisCalibration& y);

  /// An event: position or movement in counts, by the axis's kind. Movement beyond the rim is not
  /// remembered, nor is an axis that the device does not have.
  void axis(Axis which, std::int32_t counts);

  /// A button was pressed or let go. @returns kOk | kInvalidArgument: index not in [0, kMaxButtons)
  Status button(int index, bool pressed);

  /// The device or its controller lost events: discards what came since the last sync mark and what
  /// comes up to the next.
  void lost();

  /// The sync mark.
  /// @returns kOk: the sample | kUnavailable: this mark ends a loss; the next one gives a sample
  Result<InputSample> sync(Microseconds time);

  /// Calls of lost() since the start.
  std::uint32_t losses() const { return losses_; }

 private:
  static constexpr std::size_t kPair = 2;

  struct State {
    std::array<std::int32_t, 2 * kPair> at{};  ///< by Axis
    std::uint32_t buttons = 0;
  };

  Status set_pair(std::size_t first, const AxisCalibration& x, const AxisCalibration& y);

  std::array<AxisCalibration, 2 * kPair> axes_;  ///< by Axis
  std::size_t count_ = kPair;                    ///< of the axes that there are
  State pending_;                                ///< with the events since the last mark
  State synced_;                                 ///< as of that mark
  std::uint32_t sequence_ = 0;
  std::uint32_t losses_ = 0;
  bool discarding_ = false;
};

}  // namespace batuta
