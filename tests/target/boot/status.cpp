// SPDX-License-Identifier: MIT
// A failure is seen: the exit status arrives.
#include "platforms/cortex_m/semihosting.hpp"

int main() {
  batuta::semihosting::exit(3);
}
