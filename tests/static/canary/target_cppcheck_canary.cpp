// SPDX-License-Identifier: MIT
// Never linked. cppcheck must report what is planted here, as the cross build compiles it.

#include "batuta/core/types.hpp"

unsigned long target_canary(unsigned long word);
unsigned long target_canary(unsigned long word) {
  const int unused = 3;  // expect: unreadVariable
  return word << 40;     // expect: shiftTooManyBits
}
