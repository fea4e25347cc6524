// SPDX-License-Identifier: MIT
#pragma once
// The end of the line, the same for every way to get there: the force is cut, what happened is
// written where a reset does not reach, and the board halts. See cortex_m.md.

#include <cstdint>

namespace batuta::cortex_m {

enum class FaultCode : std::uint32_t {
  kNone = 0,
  kStartUp = 1,        ///< detail: StartUpFailure, the board's reason
  kHardFault = 2,      ///< detail: program counter, fault status (CFSR) or kUnexpectedInterrupt | n
  kStackOverflow = 3,  ///< detail: stack pointer, fault status (CFSR)
  kAssert = 4,         ///< detail: file_id, line
  kWatchdog = 5,       ///< detail: the board's
  kMainReturned = 6,   ///< detail: what main returned, 0
};

/// First detail of kStartUp.
enum class StartUpFailure : std::uint32_t {
  kNoFpu = 1,        ///< the program is compiled for an FPU that is not there
  kBoard = 2,        ///< batuta_board_init() gave the reason that is the second detail
  kApplication = 3,  ///< the application could not set itself up; its reason is the second detail
};

/// Second detail of kHardFault where an exception came that nobody handles; its number is added.
inline constexpr std::uint32_t kUnexpectedInterrupt = 0x80000000U;

struct FaultRecord {
  FaultCode code = FaultCode::kNone;
  std::uint32_t detail[2] = {0, 0};
};

/// Interrupts off, force off, record written, board halted. Callable from everywhere, interrupt and
/// fault handlers included, with little stack and nothing else working.
[[noreturn]] void enter_safe_state(FaultCode code, std::uint32_t detail0, std::uint32_t detail1);

/// Writes the record without halting: for a board that learns at start-up why it was reset.
void record_fault(FaultCode code, std::uint32_t detail0, std::uint32_t detail1);

/// What the record says; kNone after power-on, or where the memory did not hold it.
FaultRecord last_fault();

/// The same, and clears the record.
FaultRecord take_last_fault();

}  // namespace batuta::cortex_m

// What a board supplies.

/// Called before constructors and main(), with variables initialised: clocks, pins, the force off.
/// @returns 0, or the reason why the board cannot work: the end in kStartUp
extern "C" std::uint32_t batuta_board_init();

/// Cuts the force. Needs nothing of the library, hardly any stack, may be called at any time and
/// again.
extern "C" void batuta_board_force_off();

/// Called once the force is off and the record is written: reset, park, or tell whoever listens.
extern "C" [[noreturn]] void batuta_board_halt(batuta::cortex_m::FaultCode code);
