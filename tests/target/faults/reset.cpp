// SPDX-License-Identifier: MIT
// A board that resets after a fault: the next start finds the record, once, and the force off.
#include "batuta/core/assert.hpp"
#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/registers.hpp"
#include "push.hpp"

using batuta::cortex_m::FaultCode;

void batuta_board_halt(FaultCode /*code*/) {
  batuta::cortex_m::reset();
}

namespace {

constexpr std::uint32_t kFirst = 0x600DF00DU;
constexpr std::uint32_t kSecond = 4711;

bool is_off() {
  const batuta::mps2::ForceLevel level = batuta::mps2::force_level();
  return level.x == 0 && level.y == 0;
}

}  // namespace

int main() {
  const batuta::cortex_m::FaultRecord last = batuta::cortex_m::take_last_fault();
  if (last.code == FaultCode::kNone) {
    push();
    batuta_trap(kFirst, kSecond);
  }
  const bool taken = batuta::cortex_m::take_last_fault().code == FaultCode::kNone;
  const bool right =
      last.code == FaultCode::kAssert && last.detail[0] == kFirst && last.detail[1] == kSecond;
  batuta::semihosting::write("after the reset\n");
  batuta::semihosting::exit(taken && right && is_off() ? 0 : 1);
}
