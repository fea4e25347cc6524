// SPDX-License-Identifier: MIT
#pragma once
// Every one of these programs leaves a force on the stick, and says so, before it goes wrong.

#include "plain_force.hpp"
#include "platforms/cortex_m/semihosting.hpp"
#include "platforms/mps2/force.hpp"

inline void push() {
  batuta::mps2::Force device;
  (void)batuta::test::PlainForce(device).write({0, 0.5F, -0.5F});
  const batuta::mps2::ForceLevel level = batuta::mps2::force_level();
  batuta::semihosting::write("force before ");
  batuta::semihosting::write_hex(static_cast<std::uint32_t>(level.x));
  batuta::semihosting::write(" ");
  batuta::semihosting::write_hex(static_cast<std::uint32_t>(level.y));
  batuta::semihosting::write("\n");
}

/// What the record should say, for the test to compare.
inline void announce(std::uint32_t detail) {
  batuta::semihosting::write("at ");
  batuta::semihosting::write_hex(detail);
  batuta::semihosting::write("\n");
}

/// The program's first argument, its first letter; '\0' where there is none.
inline char first_argument() {
  char line[512];
  char word[16];
  if (batuta::semihosting::read_command_line(line, sizeof line) < 0) return '\0';
  return batuta::semihosting::word_of(line, 1, word, sizeof word) > 0 ? word[0] : '\0';
}
