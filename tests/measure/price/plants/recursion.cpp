// SPDX-License-Identifier: MIT
// What the gate has to find: recursion.

int volatile depth = 3;
__attribute__((noinline)) int sum_up_to(int n);
__attribute__((noinline)) int one_less(int n) {
  return n + sum_up_to(n - 1) * depth;
}
int sum_up_to(int n) {
  return n == 0 ? 0 : one_less(n) + depth;
}
int main() {
  return sum_up_to(depth);
}
