// SPDX-License-Identifier: MIT
// What the gate has to find: vla.

#include <alloca.h>
int volatile count = 3;
int volatile* volatile kept;
int main() {
  auto* words = static_cast<int*>(alloca(sizeof(int) * static_cast<unsigned>(count)));
  kept = words;
  kept[0] = 1;
  return words[0];
}
