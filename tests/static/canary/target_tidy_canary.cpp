// SPDX-License-Identifier: MIT
// Never linked. clang-tidy must report what is planted here, as the cross build compiles it.

#include <array>

#include "batuta/core/types.hpp"

static_assert(sizeof(void*) == 4, "the sizes are the board's");
#if !defined(__arm__) || !defined(__ARM_FEATURE_DSP)
#error "the flags are not those of a Cortex-M4"
#endif

float target_canary(const batuta::Vec3<float>& v, int depth);
float target_canary(const batuta::Vec3<float>& v, int depth) {
  const std::array<int, 2> halves{depth / 2, depth - depth / 2};
  auto* owned = new float(v.x());    // expect: cppcoreguidelines-owning-memory
  const float half = halves[0] / 2;  // expect: bugprone-integer-division
  return *owned + half;              // expect: clang-analyzer-cplusplus.NewDeleteLeaks
}
