// SPDX-License-Identifier: MIT
// What the gate has to find: guard.

int volatile question;
int answer() {
  static const int kept = question;
  return kept;
}
int main() {
  return answer();
}
