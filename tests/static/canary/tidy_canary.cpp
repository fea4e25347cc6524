// SPDX-License-Identifier: MIT
// Never linked. clang-tidy must report what is planted here, behind the same includes as the core's
// files.

#include "batuta/core/types.hpp"

float canary(const batuta::Vec3<float>& v, int depth);
float canary(const batuta::Vec3<float>& v, int depth) {  // expect: misc-no-recursion
  auto* owned = new float(v.x());                        // expect: cppcoreguidelines-owning-memory
  const int BadName = depth / 2 * 2;
  const float half = depth / 2;  // expect: bugprone-integer-division
  // expect: clang-analyzer-cplusplus.NewDeleteLeaks
  return *owned + half + static_cast<float>(BadName) + (depth > 0 ? canary(v, depth - 1) : 0.0F);
}
int WrongCase();  // expect: readability-identifier-naming
