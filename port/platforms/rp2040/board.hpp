// SPDX-License-Identifier: MIT
#pragma once
// What another board with an RP2040 would change. rp2040.md has the wiring.

#include "batuta/port/sample_builder.hpp"
#include "shared/drivers/stick_window.hpp"

namespace batuta::rp2040 {

// Pins.
inline constexpr unsigned kFirstForcePin = 2;  ///< 2 and 3: bridge of x; 4 and 5: bridge of y
inline constexpr unsigned kForcePins = 4;
inline constexpr unsigned kBreakPin = 6;    ///< the emergency stop's loop, low: no force
inline constexpr unsigned kStickXPin = 26;  ///< ADC0
inline constexpr unsigned kStickYPin = 27;  ///< ADC1
inline constexpr unsigned kFirstAdcPin = 26;

/// Steps of a bridge's pulse: 125 MHz / 6250 = 20 kHz, above hearing.
inline constexpr std::uint32_t kPulsePeriod = 6250;

/// The stick's ends and dead zone, in sums of kOversampling conversions.
inline constexpr AxisCalibration kStickAxis{
    AxisKind::kAbsolute, false,
    drivers::kOversampling* static_cast<std::int32_t>(drivers::kLowestCount),
    drivers::kOversampling* static_cast<std::int32_t>(drivers::kHighestCount), 400};
static_assert(is_valid(kStickAxis), "");

/// The hardware's watchdog, ms: a loop that hangs takes the force away by a reset, and so does a
/// guard that is dead.
inline constexpr std::uint32_t kWatchdogMs = 10;

}  // namespace batuta::rp2040
