// SPDX-License-Identifier: MIT
#include "batuta/core/assert.hpp"
#include "platforms/cortex_m/fault.hpp"

void batuta_trap(std::uint32_t file_id, std::uint32_t line) {
  batuta::cortex_m::enter_safe_state(batuta::cortex_m::FaultCode::kAssert, file_id, line);
}
