// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "batuta/core/assert.hpp"

void batuta_trap(std::uint32_t /*file_id*/, std::uint32_t /*line*/) {
  std::abort();
}
