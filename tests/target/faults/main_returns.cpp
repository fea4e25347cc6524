// SPDX-License-Identifier: MIT
#include "push.hpp"

int main() {
  push();
  return 5;
}
