// SPDX-License-Identifier: MIT
// Lanes as wide as those of a machine with AVX, made by its instructions, whatever machine the
// build is for. In a namespace of their own: the copies of other files must not take their place.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "batuta/geometry/segment_arrays.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__AVX__)
#pragma GCC diagnostic ignored "-Wpsabi"  // no lanes are passed to other files
#pragma GCC push_options
#pragma GCC target("avx")
#define __AVX__ 1  // which GCC before 13 does not do by the line above
#define lanes lanes_of_avx
#include "../../../src/geometry/lanes.hpp"
#undef lanes
#undef __AVX__

namespace batuta {
namespace {

static_assert(lanes_of_avx::kMachineBytes == 32);
static_assert(lanes_of_avx::kWidth<float> == 8 && lanes_of_avx::kWidth<double> == 4);

/// unit_clamp() of W numbers.
template <class Scalar, int W>
[[gnu::noinline]] void clamp_all(std::array<Scalar, W>& x) {
  using L = lanes_of_avx::Lanes<Scalar, W>;
  lanes_of_avx::store(lanes_of_avx::unit_clamp(lanes_of_avx::load<L>(x.data())), x.data());
}

[[gnu::noinline]] void clamp_eight(std::array<float, 8>& x) {
  clamp_all<float, 8>(x);
}
[[gnu::noinline]] void clamp_four(std::array<double, 4>& x) {
  clamp_all<double, 4>(x);
}

}  // namespace
}  // namespace batuta
#pragma GCC pop_options

namespace batuta {
namespace {

TEST(WideLanes, EightFloats_AreClampedToZeroAndOne) {
  if (__builtin_cpu_supports("avx") == 0) GTEST_SKIP() << "this processor has no such lanes";
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::array<float, 8> x = {-3.0F, -0.0F, 0.25F, 1.0F, 1.5F, kNan, kInfinity, -kInfinity};
  clamp_eight(x);
  EXPECT_EQ(x, (std::array<float, 8>{0, 0, 0.25F, 1, 1, 0, 1, 0}));
  for (const float number : x) EXPECT_FALSE(std::signbit(number));
}

TEST(WideLanes, FourDoubles_AreClampedToZeroAndOne) {
  if (__builtin_cpu_supports("avx") == 0) GTEST_SKIP() << "this processor has no such lanes";
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double low : {-3.0, -0.0, kNan}) {
    std::array<double, 4> x = {low, 0.25, 1.0, 1.5};
    clamp_four(x);
    EXPECT_EQ(x, (std::array<double, 4>{0, 0.25, 1, 1}));
    EXPECT_FALSE(std::signbit(x[0]));
  }
}

}  // namespace
}  // namespace batuta
#endif
