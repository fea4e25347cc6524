// SPDX-License-Identifier: MIT
// What the gate has to find: heap.

#include <cstdlib>
void* volatile kept;
int main() {
  kept = std::malloc(16);
  return kept == nullptr ? 1 : 0;
}
