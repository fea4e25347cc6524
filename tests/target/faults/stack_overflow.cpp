// SPDX-License-Identifier: MIT
// Calls itself until the stack is used up, with numbers in FP registers, in steps of 8 bytes or of
// a few hundred: stack_overflow small|large
#include <cstdint>

#include "push.hpp"

namespace {

volatile float seed = 1.5F;
volatile bool always = true;

[[gnu::noinline]] float fall_slowly(float x) {  // NOLINT(misc-no-recursion)
  if (!always) return x;
  return fall_slowly(x * seed) + x;
}

[[gnu::noinline]] float fall(float x) {  // NOLINT(misc-no-recursion)
  volatile float frame[120];
  frame[0] = x;
  frame[119] = x * seed;
  if (!always) return x;
  return fall(frame[119]) + frame[0];
}

}  // namespace

int main() {
  push();
  const float result = first_argument() == 's' ? fall_slowly(seed) : fall(seed);
  batuta::semihosting::exit(result > 0 ? 0 : 1);
}
