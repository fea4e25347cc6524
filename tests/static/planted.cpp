// SPDX-License-Identifier: MIT
// Everything that the core must not contain; check_symbols.py must report all of it.

#include <cmath>
#include <cstdlib>

extern "C" int planted_state;
int planted_state = 1;

float planted(float x);
float planted(float x) {
  auto* volatile block = static_cast<float*>(std::malloc(sizeof(float)));
  auto* volatile object = new float(x);
  if (x > 2) throw x;
  *block = std::sin(x) + std::atan2(x, *object);
  planted_state += static_cast<int>(*block);
  return *block;
}
