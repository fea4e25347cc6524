// SPDX-License-Identifier: MIT
// batuta_target_arithmetic: the probe of core/arithmetic.hpp on the part itself: as the project
// compiles, as a file with -ffp-contract=fast, and with every way to set up the FPU otherwise.
// Exit status: 0, or the number of the first check that failed.
#include "batuta/core/arithmetic.hpp"

#include <array>
#include <cstdint>

#include "../io.hpp"
#include "../text.hpp"
#include "contracted.hpp"

namespace batuta::digest {
namespace {

#if defined(__arm__) && defined(__ARM_FP)

constexpr std::uint32_t kFlushToZero = 1U << 24U;
constexpr std::uint32_t kRoundUp = 1U << 22U;
constexpr std::uint32_t kRoundDown = 2U << 22U;
constexpr std::uint32_t kRoundToZero = 3U << 22U;

/// Whether the probe objects to each of them, and not any more when it is taken back.
int see_control_bits() {
  constexpr std::array<std::uint32_t, 4> kWays = {kFlushToZero, kRoundUp, kRoundDown, kRoundToZero};
  const std::uint32_t before = __builtin_arm_get_fpscr();
  int check = 10;
  for (const std::uint32_t way : kWays) {  // Bound: 4
    __builtin_arm_set_fpscr(before | way);
    const bool fooled = rounds_each_operation<float>();
    __builtin_arm_set_fpscr(before);
    if (fooled) return check;
    ++check;
  }
  return rounds_each_operation<float>() ? 0 : check;
}

#else

int see_control_bits() {
  return 0;  // without such an FPU there is nothing to set up
}

#endif

/// Whether the compiler has a fused multiply-add of floats to use for this part.
#ifdef __FP_FAST_FMAF
constexpr bool kCanFuse = true;
#else
constexpr bool kCanFuse = false;
#endif

int check() {
  if (!rounds_each_operation<float>()) return 1;
  if (contracted_rounds_each_operation() == kCanFuse) return 2;
  return see_control_bits();
}

}  // namespace
}  // namespace batuta::digest

int main() {
  using namespace batuta::digest;
  const int failed = check();
  Text line;
  line << (failed == 0 ? "arithmetic: the probe tells right from wrong; fused multiply-add: "
                       : "arithmetic: a check failed; fused multiply-add: ")
       << (kCanFuse ? "present\n" : "absent\n");
  say(line.c_str());
  return leave(failed);
}
