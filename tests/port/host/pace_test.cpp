// SPDX-License-Identifier: MIT
#include "programs/duel/pace.hpp"

#include <gtest/gtest.h>

namespace batuta::host {
namespace {

constexpr std::int32_t kStep_us = 1000;

TEST(Pace, StepsAreDueOneAfterTheOther_AcrossTheWrap) {
  Microseconds now = 0xFFFFF000U;  // 4.096 ms before it
  Pace pace(now, kStep_us);
  for (int i = 0; i < 10; ++i) {
    now += 200;  // spent on the step
    EXPECT_EQ(pace.wait_us(now), 800) << i;
    now += 800;
  }
}

TEST(Pace, ALittleTime_IsMadeUpFor) {
  Pace pace(0, kStep_us);
  EXPECT_EQ(pace.wait_us(3500), 0) << "a step that took too long";
  EXPECT_EQ(pace.wait_us(3600), 0);
  EXPECT_EQ(pace.wait_us(3700), 0);
  EXPECT_EQ(pace.wait_us(3800), 200) << "the fourth is due after four";
}

TEST(Pace, ABoutThatStoodStill_GoesOnFromThere) {
  for (const Microseconds pause : {200000U, 10000000U, 0x7FFFFFFFU, 0x80000000U, 0x90000000U}) {
    Pace pace(0, kStep_us);
    EXPECT_EQ(pace.wait_us(500), 500);
    const Microseconds now = 1000 + pause;
    EXPECT_EQ(pace.wait_us(now), 0) << pause;
    EXPECT_EQ(pace.wait_us(now + 100), 900) << "neither a burst nor a sleep: " << pause;
  }
}

}  // namespace
}  // namespace batuta::host
