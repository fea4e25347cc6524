// SPDX-License-Identifier: MIT
#include "batuta/haptics/force_ramp.hpp"

#include <gtest/gtest.h>

namespace batuta {
using namespace haptics;
namespace {

ForceRamp configured(std::int32_t silent_after, std::int32_t length) {
  ForceRamp ramp;
  EXPECT_EQ(ramp.configure({silent_after, length}), Status::kOk);
  return ramp;
}

void advance(ForceRamp& ramp, bool alive, int steps) {
  for (int i = 0; i < steps; ++i) ramp.advance(alive);
}

TEST(ForceRamp, BeforeTheFirstSample_GivesNothing_AndThatIsNoSilence) {
  ForceRamp ramp = configured(3, 4);
  advance(ramp, false, 100);
  EXPECT_EQ(ramp.share(), 0.0F);
  EXPECT_TRUE(ramp.is_silent());
  EXPECT_EQ(ramp.silences(), 0U);
}

TEST(ForceRamp, TheFirstSample_BringsTheForceInOverTheLength) {
  ForceRamp ramp = configured(3, 4);
  for (const float share : {0.25F, 0.5F, 0.75F, 1.0F, 1.0F}) {
    ramp.advance(true);
    EXPECT_EQ(ramp.share(), share);
  }
}

TEST(ForceRamp, Silence_BeginsAfterExactlyTheLimit_AndTakesTheForceOverTheLength) {
  ForceRamp ramp = configured(3, 4);
  advance(ramp, true, 10);
  for (int i = 0; i < 3; ++i) {
    ramp.advance(false);
    EXPECT_EQ(ramp.share(), 1.0F);
    EXPECT_FALSE(ramp.is_silent());
  }
  for (const float share : {0.75F, 0.5F, 0.25F, 0.0F, 0.0F}) {
    ramp.advance(false);
    EXPECT_EQ(ramp.share(), share);
    EXPECT_TRUE(ramp.is_silent());
  }
  EXPECT_EQ(ramp.silences(), 1U);
}

TEST(ForceRamp, OneSampleInTime_StartsTheCountAnew) {
  ForceRamp ramp = configured(3, 4);
  advance(ramp, true, 10);
  for (int i = 0; i < 20; ++i) {
    advance(ramp, false, 3);
    ramp.advance(true);
  }
  EXPECT_EQ(ramp.share(), 1.0F);
  EXPECT_EQ(ramp.silences(), 0U);
}

TEST(ForceRamp, LifeDuringTheFall_TurnsItRoundWhereItIs) {
  ForceRamp ramp = configured(0, 4);
  advance(ramp, true, 4);
  advance(ramp, false, 2);
  EXPECT_EQ(ramp.share(), 0.5F);
  ramp.advance(true);
  EXPECT_EQ(ramp.share(), 0.75F);
  EXPECT_FALSE(ramp.is_silent());
  advance(ramp, false, 1);
  EXPECT_EQ(ramp.silences(), 2U);
}

TEST(ForceRamp, Dropped_IsZeroAtOnce_AndComesBackAsSlowlyAsEver) {
  ForceRamp ramp = configured(0, 4);
  advance(ramp, true, 10);
  advance(ramp, false, 1);
  ramp.drop();
  EXPECT_EQ(ramp.share(), 0.0F);
  EXPECT_EQ(ramp.silences(), 1U);
  for (const float share : {0.25F, 0.5F, 0.75F, 1.0F}) {
    ramp.advance(true);
    EXPECT_EQ(ramp.share(), share);
  }
}

TEST(ForceRamp, SettingsOutOfRange_AreRefused_AndChangeNothing) {
  ForceRamp ramp = configured(3, 4);
  ramp.advance(true);
  for (const RampSettings bad :
       {RampSettings{-1, 4}, {3, 0}, {3, -1}, {2000000, 4}, {3, 2000000}}) {
    EXPECT_EQ(ramp.configure(bad), Status::kInvalidArgument);
  }
  EXPECT_EQ(ramp.share(), 0.25F);
}

}  // namespace
}  // namespace batuta
