// SPDX-License-Identifier: MIT
// The duty of a bridge against exact arithmetic.

#include "shared/drivers/bridge_duty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "platforms/stm32f405/board.hpp"

namespace batuta::stm32f405 {
using namespace drivers;  // what boards share
namespace {

TEST(BridgeDuty, Ends_AreExact) {
  EXPECT_EQ(bridge_duty(1.0F, 8400).in1, 8400U);
  EXPECT_EQ(bridge_duty(1.0F, 8400).in2, 0U);
  EXPECT_EQ(bridge_duty(-1.0F, 8400).in1, 0U);
  EXPECT_EQ(bridge_duty(-1.0F, 8400).in2, 8400U);
  EXPECT_EQ(bridge_duty(0.0F, 8400).in1 + bridge_duty(-0.0F, 8400).in2, 0U);
}

TEST(BridgeDuty, EveryStepOfTheTimer_IsReached) {
  for (std::uint32_t k = 0; k <= kPulsePeriod; ++k) {
    const float force = static_cast<float>(k) / static_cast<float>(kPulsePeriod);
    EXPECT_EQ(bridge_duty(force, kPulsePeriod).in1, k);
    EXPECT_EQ(bridge_duty(-force, kPulsePeriod).in2, k);
  }
}

TEST(BridgeDuty, AllForces_AreTheNearestStepMonotoneAndSymmetric) {
  constexpr double kSlack = 0.5 + 1.0 / 256;
  std::uint32_t last = 0;
  for (std::uint32_t i = 0; i <= 1000000; ++i) {
    const float force = static_cast<float>(i) * 1e-6F;
    const BridgeDuty forward = bridge_duty(force, kPulsePeriod);
    const BridgeDuty back = bridge_duty(-force, kPulsePeriod);
    const double exact = static_cast<double>(force) * kPulsePeriod;
    ASSERT_LE(std::abs(static_cast<double>(forward.in1) - exact), kSlack) << force;
    ASSERT_GE(forward.in1, last);
    ASSERT_EQ(forward.in2, 0U);
    ASSERT_EQ(back.in1, 0U);
    ASSERT_EQ(back.in2, forward.in1);
    last = forward.in1;
  }
}

TEST(BridgeDuty, Nonsense_IsAnEndOrNothing) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const BridgeDuty nan = bridge_duty(std::numeric_limits<float>::quiet_NaN(), 8400);
  EXPECT_EQ(nan.in1 + nan.in2, 0U);
  EXPECT_EQ(bridge_duty(kInfinity, 8400).in1, 8400U);
  EXPECT_EQ(bridge_duty(-1e30F, 8400).in2, 8400U);
  EXPECT_EQ(bridge_duty(std::numeric_limits<float>::denorm_min(), 8400).in1, 0U);
}

}  // namespace
}  // namespace batuta::stm32f405
