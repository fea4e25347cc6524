// SPDX-License-Identifier: MIT
#pragma once
// What another board with an STM32F4 would change: crystal, pins, rates. stm32f405.md has the
// wiring.

#include "batuta/port/sample_builder.hpp"
#include "platforms/stm32f405/drivers/clock_start.hpp"
#include "platforms/stm32f405/registers/gpio.hpp"
#include "shared/drivers/stick_window.hpp"

namespace batuta::stm32f405 {
using namespace drivers;  // what boards share

/// 8 MHz / 4 * 168 / 2 = 168 MHz; APB1 42, APB2 84 MHz. 2 MHz into the PLL jitters least.
inline constexpr ClockTree kClocks{8000000, 4, 168, 2, 7, 4, 2};
static_assert(is_valid(kClocks), "a divider or a frequency is out of its range");
static_assert(kClocks.sysclk_hz() == 168000000 && flash_wait_states(kClocks.hclk_hz()) == 5, "");
static_assert(kClocks.pclk1_hz() == 42000000 && kClocks.pclk2_hz() == 84000000, "");

/// A step of free telemetry is up to 280 bytes, and 70 more for each contact; 3 Mbit/s moves 300 in
/// a millisecond, the sender's and the line's rings hold what comes at once.
inline constexpr std::uint32_t kBaud = 3000000;
static_assert(baud_error_ppm(kClocks.pclk2_hz(), kBaud) == 0, "a receiver allows some 20,000 ppm");

/// Pulses of the bridges: above hearing, below what the bridges' switching costs.
inline constexpr std::uint32_t kPulseHz = 20000;
inline constexpr std::uint32_t kPulsePeriod = kClocks.timers2_hz() / kPulseHz;
static_assert(kPulsePeriod * kPulseHz == kClocks.timers2_hz() && kPulsePeriod <= 65535, "");

// Pins. Port A
inline constexpr unsigned kBreakPin = 6;    ///< TIM8_BKIN: the emergency stop's loop, low: no force
inline constexpr unsigned kUsbVbusPin = 9;  ///< OTG_FS_VBUS: whether a host's cable is plugged
inline constexpr unsigned kUsbMinusPin = 11;
inline constexpr unsigned kUsbPlusPin = 12;
// Port B
inline constexpr unsigned kTransmitPin = 6;  ///< USART1_TX
inline constexpr unsigned kReceivePin = 7;   ///< USART1_RX
// Port C
inline constexpr unsigned kStickXPin = 0;      ///< ADC1_IN10
inline constexpr unsigned kStickYPin = 1;      ///< ADC1_IN11
inline constexpr unsigned kFirstForcePin = 6;  ///< TIM8_CH1 ... CH4 on pins 6 ... 9
inline constexpr unsigned kForcePins = 4;
inline constexpr unsigned kLightPin = 13;  ///< a LED to the supply: low is on

inline constexpr unsigned kStickXChannel = 10;
inline constexpr unsigned kStickYChannel = 11;
inline constexpr std::uint32_t kFunctionTim8 = 3;    ///< data sheet table 9
inline constexpr std::uint32_t kFunctionUsart1 = 7;  ///< data sheet table 9
inline constexpr std::uint32_t kFunctionOtgFs = 10;  ///< data sheet table 9

/// Port C with the force pins as plain outputs, which are low: nothing ever sets them in ODR.
inline constexpr std::uint32_t kPortCSafe =
    pin_mode(kStickXPin, PinMode::kAnalog) | pin_mode(kStickYPin, PinMode::kAnalog) |
    pin_mode(kFirstForcePin, PinMode::kOutput) | pin_mode(kFirstForcePin + 1, PinMode::kOutput) |
    pin_mode(kFirstForcePin + 2, PinMode::kOutput) |
    pin_mode(kFirstForcePin + 3, PinMode::kOutput) | pin_mode(kLightPin, PinMode::kOutput);

/// The stick's ends and dead zone, in sums of 16 conversions: as far as a reading is a stick's at
/// all. A stick that does not reach them gets its own numbers here.
inline constexpr std::int32_t kStickLow = kOversampling * static_cast<std::int32_t>(kLowestCount);
inline constexpr std::int32_t kStickHigh = kOversampling * static_cast<std::int32_t>(kHighestCount);
inline constexpr AxisCalibration kStickAxis{AxisKind::kAbsolute, false, kStickLow, kStickHigh, 400};
static_assert(is_valid(kStickAxis), "");

/// How the clocks came up; kRunning, or kAbsent in an emulator, where no force may be armed.
ClockStart clock_state();

/// Ticks without a fault, for long enough: restarts are counted from zero again.
void forget_restarts();

/// Hands the force pins from their safe level to the timer.
/// @pre the timer is configured, its outputs forced low
void connect_force_pins();

/// TIM7 once a millisecond, for the force guard, which no hanging loop keeps from acting.
/// @param priority  of its interrupt
void start_guard(std::uint32_t priority);

/// Pins, clock and sense of VBUS of USB OTG FS; the rest is the USB stack's.
/// @pre clock_state() is kRunning
void connect_usb();

}  // namespace batuta::stm32f405
