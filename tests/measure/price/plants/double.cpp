// SPDX-License-Identifier: MIT
// What the gate has to find: double.

double volatile product = 3;
int main() {
  product = product * 1.5;
  return static_cast<int>(product);
}
