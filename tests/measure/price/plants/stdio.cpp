// SPDX-License-Identifier: MIT
// What the gate has to find: stdio.

#include <cstdio>
int volatile answer = 42;
int main() {
  std::printf("%d\n", answer);
  return 0;
}
