// SPDX-License-Identifier: MIT
// The condition law against its definition in double, and its properties.

#include "shared/hid_pid/condition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace batuta::pid {
namespace {

/// PID 1.0, side by side: k (q - (c + d)) above, k (q - (c - d)) below, 0 between; then the side's
/// saturation.
double law(const Condition& c, double q) {
  const double high = (c.centre + c.dead_band) / 1e4;
  const double low = (c.centre - c.dead_band) / 1e4;
  if (q > high) {
    const double most = c.positive_saturation / 1e4;
    return std::clamp(c.positive_coefficient / 1e4 * (q - high), -most, most);
  }
  if (q < low) {
    const double most = c.negative_saturation / 1e4;
    return std::clamp(c.negative_coefficient / 1e4 * (q - low), -most, most);
  }
  return 0.0;
}

Condition drawn(std::mt19937& random) {
  std::uniform_int_distribution<int> any(-10000, 10000);
  const auto magnitude = [&] { return static_cast<std::uint16_t>(std::abs(any(random))); };
  const auto signed_one = [&] { return static_cast<std::int16_t>(any(random)); };
  return {signed_one(), signed_one(), signed_one(), magnitude(), magnitude(), magnitude()};
}

TEST(PidCondition, Force_FollowsTheLawOfTheClassDefinition) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metrics(-1.0F, 1.0F);
  int held = 0;
  for (int i = 0; i < 20000; ++i) {
    const Condition c = drawn(random);
    const float q = metrics(random);
    // Three roundings of numbers up to 2, and one of the product.
    ASSERT_NEAR(c.force(q, 1.0F), law(c, static_cast<double>(q)), 4 * 0x1p-23);
    if (law(c, static_cast<double>(q)) != 0.0) ++held;
  }
  EXPECT_GT(held, 5000);
}

TEST(PidCondition, HandWorked_Values) {
  const Condition c = {1000, 10000, 5000, 3000, 10000, 500};  // dead from 0.05 to 0.15
  EXPECT_EQ(c.force(0.05F, 1.0F), 0.0F);
  EXPECT_EQ(c.force(0.1F, 1.0F), 0.0F);
  EXPECT_NEAR(c.force(0.25F, 1.0F), 0.1F, 1e-7F);
  EXPECT_EQ(c.force(1.0F, 1.0F), 0.3F);  // 0.85, clipped
  EXPECT_NEAR(c.force(-0.15F, 1.0F), -0.1F, 1e-7F);
  EXPECT_NEAR(c.force(-1.0F, 1.0F), -0.525F, 1e-7F);
}

TEST(PidCondition, Mirrored_IsMirrored) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> metrics(-1.0F, 1.0F);
  for (int i = 0; i < 5000; ++i) {
    const Condition c = drawn(random);
    const Condition m = {static_cast<std::int16_t>(-c.centre),
                         c.negative_coefficient,
                         c.positive_coefficient,
                         c.negative_saturation,
                         c.positive_saturation,
                         c.dead_band};
    const float q = metrics(random);
    for (const float knee : {1.0F, 0.05F}) ASSERT_EQ(c.force(q, knee), -m.force(-q, knee));
  }
}

// No jump anywhere, and none at rest for friction: the slope is at most the coefficient over the
// knee.
TEST(PidCondition, Force_IsContinuous) {
  std::mt19937 random(3);
  constexpr float kStep = 1.0F / 4096;
  for (int i = 0; i < 50; ++i) {
    const Condition c = drawn(random);
    for (const float knee : {1.0F, 0.05F}) {
      for (float q = -1.0F; q < 1.0F; q += kStep) {
        ASSERT_LE(std::abs(c.force(q + kStep, knee) - c.force(q, knee)), kStep / knee + 1e-6F);
      }
    }
  }
}

// Linux 7.2 and 7.3 send the whole range of that side as 0.
TEST(PidCondition, NegativeSaturationOfNothing_IsThatOfThePositiveSide) {
  Condition c{0, 10000, 10000, 6000, 0, 0};
  EXPECT_FLOAT_EQ(c.force(1.0F, 1.0F), 0.6F);
  EXPECT_FLOAT_EQ(c.force(-1.0F, 1.0F), -0.6F);
  EXPECT_FLOAT_EQ(c.force(-0.5F, 1.0F), -0.5F);
  c.negative_saturation = 2000;
  EXPECT_FLOAT_EQ(c.force(-1.0F, 1.0F), -0.2F) << "what is said counts";
  c.positive_saturation = 0;
  EXPECT_EQ(c.force(1.0F, 1.0F), 0.0F);
}

TEST(PidCondition, NoSaturation_IsNoForce) {
  const Condition c = {0, 10000, 10000, 0, 0, 0};
  EXPECT_EQ(c.force(1.0F, 1.0F), 0.0F);
  EXPECT_EQ(c.force(-1.0F, 0.05F), 0.0F);
}

}  // namespace
}  // namespace batuta::pid
