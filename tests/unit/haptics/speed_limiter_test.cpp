// SPDX-License-Identifier: MIT
#include "batuta/haptics/speed_limiter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace batuta {
using namespace haptics;
namespace {

constexpr float kDt = 1.0F / 1024;

SpeedLimiter configured(const SpeedLimitSettings& settings, float dt = kDt) {
  SpeedLimiter limiter;
  EXPECT_EQ(limiter.configure(settings, dt), Status::kOk);
  return limiter;
}

TEST(SpeedLimiter, WithinTheLimit_LeavesTheForce) {
  SpeedLimiter limiter = configured({10, 1, 1});
  for (const float velocity : {0.0F, 9.9F, -9.9F, 10.0F, -10.0F}) {
    for (int i = 0; i < 100; ++i) EXPECT_EQ(limiter.limited(0.75F, velocity), 0.75F) << velocity;
  }
}

TEST(SpeedLimiter, TooFast_TakesInProportion_FromTheForceAlongTheMotionAlone) {
  SpeedLimiter limiter = configured({10, 0.125F, 0});
  EXPECT_EQ(limiter.limited(1, 12), 0.75F);
  EXPECT_EQ(limiter.limited(-1, -12), -0.75F);
  EXPECT_EQ(limiter.limited(-1, 12), -1.0F) << "it brakes";
  EXPECT_EQ(limiter.limited(1, -12), 1.0F) << "it brakes";
  EXPECT_EQ(limiter.limited(0, 12), 0.0F);
  EXPECT_EQ(limiter.limited(0.125F, 12), 0.0F) << "less than is taken: none, not the other way";
  EXPECT_EQ(limiter.limited(-0.125F, -12), 0.0F);
}

TEST(SpeedLimiter, TooFastForLong_TakesMoreAndMore_AndForgetsItWhenSlow) {
  SpeedLimiter limiter = configured({10, 0, 1});
  for (int i = 1; i <= 512; ++i) EXPECT_EQ(limiter.limited(1, 11), 1 - static_cast<float>(i) * kDt);
  // Five below the limit: five times as fast back.
  for (int i = 1; i <= 100; ++i) {
    EXPECT_EQ(limiter.limited(1, 5), 1 - static_cast<float>(512 - 5 * i) * kDt);
  }
}

TEST(SpeedLimiter, ItsMemory_IsNeverMoreThanTheWholeForce) {
  SpeedLimiter limiter = configured({10, 0, 1024});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(limiter.limited(1, 100), 0.0F);
  EXPECT_EQ(limiter.limited(1, 9.5F), 0.5F);
  EXPECT_EQ(limiter.limited(1, 9.5F), 1.0F);
}

/// A mass on which a constant force pulls until its bearings hold it: at 80 and at 24 1/s.
TEST(SpeedLimiter, HandsOff_TheStickSettlesAtTheLimit) {
  for (const float share : {1.0F, -0.3F}) {
    SpeedLimiter limiter = configured({});
    const double pull = 400;  // 1/s^2 for a whole share
    const double drag = 5;    // 1/s
    double velocity = 0;
    double fastest = 0;
    for (int i = 0; i < 5000; ++i) {
      const float left = limiter.limited(share, static_cast<float>(velocity));
      velocity += (pull * left - drag * velocity) * kDt;
      fastest = std::fmax(fastest, std::fabs(velocity));
    }
    EXPECT_NEAR(velocity, share > 0 ? 12 : -12, 0.05) << share;
    EXPECT_LT(fastest, 22) << "at least the proportional part: 12 + 1 / 0.1";
    EXPECT_GT(fastest, 12) << "else nothing was limited";
  }
}

TEST(SpeedLimiter, SettingsOutOfRange_AreRefused_AndChangeNothing) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float largest = std::numeric_limits<float>::max();
  const float nan = std::nanf("");
  SpeedLimiter limiter = configured({10, 0.125F, 0});
  for (const SpeedLimitSettings& bad : {SpeedLimitSettings{0, 1, 1},
                                        {-1, 1, 1},
                                        {nan, 1, 1},
                                        {infinity, 1, 1},
                                        {1, -1, 1},
                                        {1, nan, 1},
                                        {1, infinity, 1},
                                        {1, 1, -1},
                                        {1, 1, nan},
                                        {1, 1, infinity}}) {
    EXPECT_EQ(limiter.configure(bad, kDt), Status::kInvalidArgument);
  }
  for (const float dt : {0.0F, -kDt, nan, infinity}) {
    EXPECT_EQ(limiter.configure({}, dt), Status::kInvalidArgument) << dt;
  }
  EXPECT_EQ(limiter.configure({1, 1, largest}, 2), Status::kInvalidArgument) << "their product";
  EXPECT_EQ(limiter.limited(1, 12), 0.75F);
}

RC_GTEST_PROP(SpeedLimiter, NeverReverses_NeverAdds_NeverTakesFromABrake, ()) {
  const auto number = [](int most) {
    return static_cast<float>(*rc::gen::inRange(-1000, 1001)) * static_cast<float>(most) / 1000;
  };
  SpeedLimiter limiter =
      configured({0.1F + std::abs(number(20)), std::abs(number(2)), std::abs(number(200))});
  for (int i = 0; i < 100; ++i) {
    const float share = number(1);
    const float velocity = *rc::gen::inRange(0, 10) == 0
                               ? std::copysign(std::numeric_limits<float>::max(), number(1))
                               : number(100);
    const float left = limiter.limited(share, velocity);
    RC_ASSERT(std::abs(left) <= std::abs(share));
    RC_ASSERT(left * share >= 0);
    RC_ASSERT(share * velocity > 0 || left == share);
  }
}

}  // namespace
}  // namespace batuta
