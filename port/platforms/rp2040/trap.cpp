// SPDX-License-Identifier: MIT
// A precondition or an invariant does not hold: no force, then the watchdog's reset.

#include "batuta/core/assert.hpp"
#include "platforms/rp2040/drivers/force_off.hpp"

void batuta_trap(std::uint32_t file_id, std::uint32_t line) {
  batuta::rp2040::force_off();
  const volatile std::uint32_t where[] = {file_id, line};
  for (;;) (void)where[0];  // for ever: nobody feeds the watchdog, and a debugger finds both
}
