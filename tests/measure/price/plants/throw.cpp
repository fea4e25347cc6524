// SPDX-License-Identifier: MIT
// What the gate has to find: throw.

int volatile question;
int main() {
  if (question == 42) throw 42;
  return 0;
}
