// SPDX-License-Identifier: MIT

#include "shared/usb_stick/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace batuta::usb {
namespace {

InputSample at(Microseconds time, float x, float y = 0) {
  InputSample sample;
  sample.time = time;
  sample.x = x;
  sample.y = y;
  return sample;
}

TEST(UsbMotion, SteadyMotion_HasItsVelocity) {
  Motion motion;
  Microseconds now = 0xFFFFF000U;  // wraps soon
  for (int i = 0; i < 100; ++i) motion.take(at(now += 1000, 0.003F * static_cast<float>(i), 0.5F));
  EXPECT_NEAR(motion.stick().velocity.x(), 3.0F, 1e-3F);
  EXPECT_EQ(motion.stick().velocity.y(), 0.0F);
  EXPECT_NEAR(motion.stick().acceleration.x(), 0.0F, 0.1F);
  EXPECT_EQ(motion.stick().position.y(), 0.5F);
}

// A step in velocity v is answered by v (1 - (T / (h + T))^n) after n samples h apart.
TEST(UsbMotion, StepOfVelocity_ComesWithTheTimeConstant) {
  Motion motion;
  motion.take(at(0, 0));
  const double h = 0.001;
  const double left = 0.004 / (h + 0.004);
  for (int n = 1; n <= 40; ++n) {
    motion.take(at(static_cast<Microseconds>(1000 * n), 0.001F * static_cast<float>(n)));
    EXPECT_NEAR(motion.stick().velocity.x(), 1.0 - std::pow(left, n), 1e-3) << n;
  }
}

TEST(UsbMotion, SteadyAcceleration_IsFound) {
  Motion motion;
  for (int n = 0; n <= 100; ++n) {
    const float t = 0.001F * static_cast<float>(n);
    motion.take(at(static_cast<Microseconds>(1000 * n), 0.5F * 8 * t * t));
  }
  EXPECT_NEAR(motion.stick().acceleration.x(), 8.0F, 0.2F);
}

TEST(UsbMotion, GapOrTimeThatGoesBack_IsANewBeginningAtRest) {
  for (const Microseconds next :
       {Microseconds{50001}, Microseconds{21001}, Microseconds{1000}, Microseconds{500}}) {
    Motion motion;
    motion.take(at(0, 0));
    motion.take(at(1000, 0.1F));
    EXPECT_GT(motion.stick().velocity.x(), 0.0F);
    motion.take(at(next, 0.9F));
    EXPECT_EQ(motion.stick().velocity.x(), 0.0F) << next;
    EXPECT_EQ(motion.stick().acceleration.x(), 0.0F) << next;
    EXPECT_EQ(motion.stick().position.x(), 0.9F) << next;
  }
  Motion motion;
  motion.take(at(7, 1.0F));
  EXPECT_EQ(motion.stick().velocity.x(), 0.0F) << "the first sample";
}

}  // namespace
}  // namespace batuta::usb
