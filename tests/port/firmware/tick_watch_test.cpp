// SPDX-License-Identifier: MIT
#include "shared/firmware/tick_watch.hpp"

#include <gtest/gtest.h>

namespace batuta::firmware {
namespace {

constexpr Microseconds kStart = 0xFFFFFF00U;   // wraps soon
constexpr std::uint32_t kFirst = 0xFFFFFFFEU;  // wraps even sooner

TickWatch started() {
  TickWatch watch;
  watch.start(1000);
  return watch;
}

TEST(TickWatch, InTime_CountsNothingButTicks_AcrossBothWraps) {
  TickWatch watch = started();
  for (std::uint32_t i = 0; i < 100; ++i) {
    watch.begin(kFirst + i, kStart + i * 1000);
    EXPECT_EQ(watch.begun(), kStart + i * 1000);
    watch.end(kStart + i * 1000 + 1000);
  }
  EXPECT_EQ(watch.report().used, 100U);
  EXPECT_EQ(watch.report().skipped, 0U);
  EXPECT_EQ(watch.report().overruns, 0U);
  EXPECT_EQ(watch.report().longest_us, 1000);
}

TEST(TickWatch, WorkLongerThanThePeriod_IsAnOverrun_AndTheTicksUnderItAreSkipped) {
  TickWatch watch = started();
  watch.begin(7, kStart);
  watch.end(kStart + 3500);
  EXPECT_EQ(watch.report().overruns, 1U);
  EXPECT_EQ(watch.report().longest_us, 3500);
  watch.begin(10, kStart + 3500);
  EXPECT_EQ(watch.report().skipped, 2U);
  watch.end(kStart + 3600);
  EXPECT_EQ(watch.report().overruns, 1U);
  EXPECT_EQ(watch.report().used, 2U);
}

TEST(TickWatch, TheFirstTick_SkipsNothing_WhateverItsNumber) {
  TickWatch watch = started();
  watch.begin(1234567, 0);
  EXPECT_EQ(watch.report().skipped, 0U);
}

TEST(TickWatchDeathTest, ATickBegunTwice_IsACallersMistake) {
  TickWatch watch = started();
  watch.begin(7, 0);
  watch.end(10);
  EXPECT_DEATH(watch.begin(7, 20), "");
}

TEST(TickWatch, Start_ForgetsEverything) {
  TickWatch watch = started();
  watch.begin(1, 0);
  watch.end(9000);
  watch.begin(50, 50000);
  watch.start(1000);
  EXPECT_EQ(watch.report().used, 0U);
  EXPECT_EQ(watch.report().skipped, 0U);
  EXPECT_EQ(watch.report().overruns, 0U);
}

}  // namespace
}  // namespace batuta::firmware
