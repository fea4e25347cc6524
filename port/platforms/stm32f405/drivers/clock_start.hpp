// SPDX-License-Identifier: MIT
#pragma once
// From the internal 16 MHz, on which the part starts, to the clock tree of board.hpp. Every wait
// has a bound: a crystal that does not swing ends in a report, not in a hang.

#include "platforms/stm32f405/drivers/clock_tree.hpp"
#include "platforms/stm32f405/registers/power_flash.hpp"
#include "platforms/stm32f405/registers/rcc.hpp"

namespace batuta::stm32f405 {

enum class ClockStart : std::uint32_t {
  kRunning,    ///< on the PLL, watched by the clock security system
  kNoCrystal,  ///< HSE not ready in time
  kNoFlash,    ///< the flash did not take the wait states
  kNoPll,      ///< PLL not ready in time
  kNoSwitch,   ///< SYSCLK did not change over in time
  kAbsent,     ///< there is no clock control: an emulator. The part runs; nothing may move
};

struct ClockRegisters {
  Rcc& rcc;
  Pwr& pwr;
  FlashInterface& flash;
};

/// Turns of a wait. One takes at least 4 cycles of 16 MHz: 100 ms at least, where a crystal takes 2
/// and the PLL 0.3 (data sheet).
inline constexpr int kClockTurns = 400000;

/// @pre is_valid(tree); the part has just been reset
/// @returns see ClockStart; where it is neither kRunning nor kAbsent, the part stays on the
/// internal
///   oscillator
/// Bound: 3 kClockTurns turns.
ClockStart start_clocks(const ClockRegisters& at, const ClockTree& tree, int turns = kClockTurns);

}  // namespace batuta::stm32f405
