// SPDX-License-Identifier: MIT
#include "batuta/haptics/slew_limiter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace batuta {
using namespace haptics;
namespace {

SlewLimiter configured(float most) {
  SlewLimiter slew;
  EXPECT_EQ(slew.configure(most), Status::kOk);
  return slew;
}

TEST(SlewLimiter, AStep_IsClimbedInEqualParts_AndReachedExactly) {
  SlewLimiter slew = configured(0.25F);
  for (const float share : {0.25F, 0.5F, 0.7F, 0.7F}) EXPECT_EQ(slew.towards(0.7F), share);
  const float down = 0.7F - 0.25F;
  EXPECT_EQ(slew.towards(-1), down);
}

TEST(SlewLimiter, Dropped_IsAtZero) {
  SlewLimiter slew = configured(0.5F);
  (void)slew.towards(1);
  slew.drop();
  EXPECT_EQ(slew.towards(1), 0.5F);
}

TEST(SlewLimiter, ARateOutOfRange_IsRefused_AndChangesNothing) {
  SlewLimiter slew = configured(0.25F);
  (void)slew.towards(1);
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {0.0F, -1.0F, infinity, std::nanf("")}) {
    EXPECT_EQ(slew.configure(bad), Status::kInvalidArgument) << bad;
  }
  EXPECT_EQ(slew.towards(1), 0.5F);
}

RC_GTEST_PROP(SlewLimiter, NeverFaster_NeverBeyondTheGoal, (std::uint16_t rate)) {
  const float most = static_cast<float>(rate + 1) / 65536.0F;
  SlewLimiter slew = configured(most);
  float last = 0;
  for (int i = 0; i < 50; ++i) {
    const float goal = static_cast<float>(*rc::gen::inRange(-1000, 1001)) / 1000.0F;
    const float share = slew.towards(goal);
    const float rounding = std::numeric_limits<float>::epsilon();
    RC_ASSERT(std::abs(share - last) <= most + rounding);
    RC_ASSERT(share >= std::min(last, goal) && share <= std::max(last, goal));
    RC_ASSERT(share != last || goal == last);
    last = share;
  }
}

}  // namespace
}  // namespace batuta
