// SPDX-License-Identifier: MIT
// What the gate has to find: libm.

#include <cmath>
float volatile angle = 1;
int main() {
  angle = std::sin(angle);
  return 0;
}
