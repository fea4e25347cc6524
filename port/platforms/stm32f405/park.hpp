// SPDX-License-Identifier: MIT
#pragma once
// Where a board stays that has restarted too often.

#include <cstdint>

namespace batuta::stm32f405 {

/// Blinks `code`, pauses, and again, for ever, on the internal oscillator with the force off, until
/// the reset button or the power. The watchdog is fed here, because it may run already (an option
/// byte starts it with the part): parked is where the board is safe.
/// @pre batuta_board_force_off() was called, port C has its clock
[[noreturn]] void park(std::uint32_t code);

}  // namespace batuta::stm32f405
