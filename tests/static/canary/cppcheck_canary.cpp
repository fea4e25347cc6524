// SPDX-License-Identifier: MIT
// Never linked. cppcheck must report what is planted here, behind the same includes as the core's
// files.

#include "batuta/core/types.hpp"

float canary(const batuta::Vec3<float>& v);
float canary(const batuta::Vec3<float>& v) {
  int table[3] = {0, 1, 2};
  int unused = 3;  // expect: unreadVariable
  const int* nowhere = nullptr;
  if (v.x() > 0) return static_cast<float>(*nowhere);  // expect: nullPointer
  return static_cast<float>(table[3]);                 // expect: arrayIndexOutOfBounds
}
