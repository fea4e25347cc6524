// SPDX-License-Identifier: MIT
// The end of the line: a precondition or an invariant does not hold, and nothing the library says
// may be believed.

#include "batuta/core/assert.hpp"

// Must: switch the actuators off first, with code that needs nothing of the library; then leave
// file_id and line where they will be found (a breakpoint, a register that survives the reset, a
// blinking light); then stop or reset. Must not return. May be called from whatever context the
// failing call was in, interrupts included.
void batuta_trap(std::uint32_t file_id, std::uint32_t line) {
  const volatile std::uint32_t where[] = {file_id, line};
  for (;;) (void)where[0];  // for ever: a debugger finds both
}
