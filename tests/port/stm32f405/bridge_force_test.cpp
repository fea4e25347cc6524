// SPDX-License-Identifier: MIT
// The four ways in which the force goes away, and the one in which it comes.

#include "platforms/stm32f405/drivers/bridge_force.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "plain_force.hpp"

namespace batuta::stm32f405 {
namespace {

class BridgeForceTest : public ::testing::Test {
 protected:
  BridgeForceTest() { force_.configure(8400); }
  Status write(float x, float y) { return hand_.write({0, x, y}); }
  bool is_silent() const {
    return timer_.ccr[0] + timer_.ccr[1] + timer_.ccr[2] + timer_.ccr[3] == 0;
  }
  void tick(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) force_.guard_tick();
  }

  Tim timer_{};
  BridgeForce force_{timer_};
  batuta::test::PlainForce hand_{force_};
};

TEST_F(BridgeForceTest, Configured_IsForcedLow) {
  EXPECT_FALSE(force_.is_armed());
  EXPECT_EQ(timer_.arr, 8399U);
  EXPECT_EQ(timer_.bdtr, BridgeForce::kSafe);
  EXPECT_EQ(timer_.bdtr, 0x1E00U);  // BKE, OSSR, OSSI, LOCK 2; not MOE (RM0090 17.4.18)
  EXPECT_TRUE(is_silent());
}

TEST_F(BridgeForceTest, NotArmed_TakesNothing) {
  EXPECT_EQ(write(0.5F, 0.5F), Status::kUnavailable);
  EXPECT_TRUE(is_silent());
}

TEST_F(BridgeForceTest, Armed_SignsChooseTheInput) {
  ASSERT_EQ(force_.arm(), Status::kOk);
  EXPECT_EQ(write(0.5F, -0.25F), Status::kOk);
  EXPECT_EQ(timer_.ccr[0], 4200U);
  EXPECT_EQ(timer_.ccr[1], 0U);
  EXPECT_EQ(timer_.ccr[2], 0U);
  EXPECT_EQ(timer_.ccr[3], 2100U);
  EXPECT_EQ(timer_.cr1 & Tim::kCr1Udis, 0U);  // or the values would never be taken over
  EXPECT_EQ(write(-0.5F, 0.25F), Status::kOk);
  EXPECT_EQ(timer_.ccr[0], 0U);
  EXPECT_EQ(timer_.ccr[1], 4200U);
  EXPECT_EQ(timer_.ccr[2], 2100U);
  EXPECT_EQ(timer_.ccr[3], 0U);
}

TEST_F(BridgeForceTest, BadCommand_TakesTheForceAway) {
  ASSERT_EQ(force_.arm(), Status::kOk);
  ASSERT_EQ(write(1, 1), Status::kOk);
  EXPECT_EQ(write(std::numeric_limits<float>::quiet_NaN(), 0), Status::kInvalidArgument);
  EXPECT_TRUE(is_silent());
}

TEST_F(BridgeForceTest, NoCommand_TheGuardActsAfterItsTicksAndOnce) {
  ASSERT_EQ(force_.arm(), Status::kOk);
  ASSERT_EQ(write(1, -1), Status::kOk);
  tick(BridgeForce::kGuardTicks - 1);
  EXPECT_FALSE(is_silent());
  tick(1);
  EXPECT_TRUE(is_silent());
  EXPECT_EQ(force_.expiries(), 1U);
  tick(100);
  EXPECT_EQ(force_.expiries(), 1U);
  EXPECT_EQ(force_.guard_ticks(), 100U + BridgeForce::kGuardTicks);
  EXPECT_EQ(write(1, 0), Status::kOk);  // commands have come back
  EXPECT_EQ(timer_.ccr[0], 8400U);
}

TEST_F(BridgeForceTest, CommandThatHangs_TheGuardsZeroesAreTakenOver) {
  ASSERT_EQ(force_.arm(), Status::kOk);
  ASSERT_EQ(write(1, 1), Status::kOk);
  timer_.cr1 |= Tim::kCr1Udis;  // as between the stores of a command
  tick(BridgeForce::kGuardTicks);
  EXPECT_TRUE(is_silent());
  EXPECT_EQ(timer_.cr1, Tim::kCr1Arpe | Tim::kCr1Cen);
}

TEST_F(BridgeForceTest, Commands_KeepTheGuardWaiting) {
  ASSERT_EQ(force_.arm(), Status::kOk);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(write(1, 0), Status::kOk);
    tick(BridgeForce::kGuardTicks - 1);
    ASSERT_EQ(timer_.ccr[0], 8400U);
  }
  EXPECT_EQ(force_.expiries(), 0U);
}

TEST_F(BridgeForceTest, Break_IsToldAndTheForceDoesNotComeBackByItself) {
  ASSERT_EQ(force_.arm(), Status::kOk);
  ASSERT_EQ(write(1, 1), Status::kOk);
  timer_.bdtr &= ~Tim::kBdtrMoe;  // what the break input does
  EXPECT_EQ(write(1, 1), Status::kUnavailable);
  EXPECT_TRUE(is_silent());
  EXPECT_FALSE(force_.is_armed());
}

TEST_F(BridgeForceTest, Disarmed_IsForcedLow) {
  ASSERT_EQ(force_.arm(), Status::kOk);
  force_.disarm();
  EXPECT_EQ(timer_.bdtr, BridgeForce::kSafe);
  EXPECT_EQ(write(1, 1), Status::kUnavailable);
}

}  // namespace
}  // namespace batuta::stm32f405
