// SPDX-License-Identifier: MIT
// A tripped assert on the host: say where, and stop with a core to look at.

#include <cstdio>
#include <cstdlib>

#include "batuta/core/assert.hpp"

void batuta_trap(std::uint32_t file_id, std::uint32_t line) {
  (void)std::fprintf(stderr, "batuta: assertion failed, file id %08x, line %u\n",
                     static_cast<unsigned>(file_id), static_cast<unsigned>(line));
  std::abort();
}
