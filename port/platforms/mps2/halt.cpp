// SPDX-License-Identifier: MIT
// The board's end: what happened as a line on the console, and 100 + code as exit status.
#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/semihosting.hpp"
#include "platforms/mps2/force.hpp"

void batuta_board_halt(batuta::cortex_m::FaultCode code) {
  using namespace batuta;
  const cortex_m::FaultRecord record = cortex_m::last_fault();
  const mps2::ForceLevel force = mps2::force_level();
  semihosting::write("fault ");
  semihosting::write_unsigned(static_cast<std::uint32_t>(record.code));
  semihosting::write(" detail ");
  semihosting::write_hex(record.detail[0]);
  semihosting::write(" ");
  semihosting::write_hex(record.detail[1]);
  semihosting::write(" force ");
  semihosting::write_hex(static_cast<std::uint32_t>(force.x));
  semihosting::write(" ");
  semihosting::write_hex(static_cast<std::uint32_t>(force.y));
  semihosting::write("\n");
  constexpr int kExitOfFaults = 100;
  semihosting::exit(kExitOfFaults + static_cast<int>(code));
}
