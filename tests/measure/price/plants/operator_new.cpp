// SPDX-License-Identifier: MIT
// What the gate has to find: operator new.

int* volatile kept;
int main() {
  kept = new int(7);
  return *kept;
}
