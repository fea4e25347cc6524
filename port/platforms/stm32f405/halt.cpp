// SPDX-License-Identifier: MIT
// After a fault: a reset. The record and the count of restarts survive it; batuta_board_init()
// decides whether the board runs again or parks.

#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/registers.hpp"

void batuta_board_halt(batuta::cortex_m::FaultCode /*code*/) {
  batuta::cortex_m::reset();
}
