// SPDX-License-Identifier: MIT
#include "batuta/haptics/detail/whole.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace batuta::detail {
namespace {

float of_bits(std::uint32_t bits) {
  float number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

TEST(Whole, AnyNumber_IsThatOfTheStandardLibrary) {
  std::mt19937 random(3);
  int with_fraction = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float x = of_bits(static_cast<std::uint32_t>(random()));
    if (std::isnan(x)) continue;
    ASSERT_EQ(whole_below(x), std::floor(x)) << x;
    with_fraction += std::abs(x) > 1.0F && std::floor(x) != x ? 1 : 0;
  }
  EXPECT_GT(with_fraction, 50000);
}

TEST(Whole, EdgesAndWhatIsNoNumber_Stay) {
  for (const float x : {8388607.5F, 8388608.0F, 8388609.0F, 2147483648.0F, 3e38F, 2.0F, 0.0F}) {
    EXPECT_EQ(whole_below(x), std::floor(x)) << x;
    EXPECT_EQ(whole_below(-x), std::floor(-x)) << x;
  }
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(whole_below(infinity), infinity);
  EXPECT_EQ(whole_below(-infinity), -infinity);
  EXPECT_TRUE(std::isnan(whole_below(std::numeric_limits<float>::quiet_NaN())));
}

}  // namespace
}  // namespace batuta::detail
