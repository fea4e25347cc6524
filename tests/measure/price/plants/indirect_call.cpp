// SPDX-License-Identifier: MIT
// What the gate has to find: indirect call.

int twice(int x) {
  return 2 * x;
}
int (*volatile function)(int) = twice;
int main() {
  return function(3) + 1;
}
