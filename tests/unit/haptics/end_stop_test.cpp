// SPDX-License-Identifier: MIT
#include "batuta/haptics/end_stop.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace batuta {
using namespace haptics;
namespace {

constexpr EndStopSettings kStop{0.5F, 4, 0.25F};

TEST(EndStop, WithinItsStart_DoesNothing) {
  for (const float position : {0.0F, 0.3F, -0.49F, 0.5F, -0.5F}) {
    EXPECT_EQ(end_stop_push(kStop, position, 100), 0.0F);
    EXPECT_EQ(with_end_stop(0.7F, 0, position), 0.7F);
    EXPECT_EQ(with_end_stop(-0.7F, 0, position), -0.7F);
  }
}

TEST(EndStop, IsASpring) {
  for (const float side : {-1.0F, 1.0F}) {
    EXPECT_EQ(end_stop_push(kStop, side * 0.625F, 0), 0.5F);
    EXPECT_EQ(end_stop_push(kStop, side * 0.75F, 0), 1.0F);
    EXPECT_EQ(end_stop_push(kStop, side * 3.0F, 0), 1.0F) << "no more than there is";
  }
}

TEST(EndStop, IsADamper_ThatNeverPullsOutward) {
  for (const float side : {-1.0F, 1.0F}) {
    EXPECT_EQ(end_stop_push(kStop, side * 0.625F, side * 1), 0.75F) << "on its way out";
    EXPECT_EQ(end_stop_push(kStop, side * 0.625F, side * -1), 0.25F) << "on its way back";
    EXPECT_EQ(end_stop_push(kStop, side * 0.625F, side * -100), 0.0F);
  }
}

TEST(EndStop, WithoutStiffness_IsNone) {
  EXPECT_EQ(end_stop_push({0.5F, 0, 1}, 0.9F, 1), 0.0F);
}

TEST(EndStop, AtItsStrongest_HasTheWholeActuator) {
  for (const float side : {-1.0F, 1.0F}) {
    for (const float share : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) {
      EXPECT_EQ(with_end_stop(share, 1, side * 0.75F), -side);
    }
    EXPECT_EQ(with_end_stop(side * 1.0F, 0.5F, side), 0.0F);  // half of the demand, half of it
    EXPECT_EQ(with_end_stop(-side * 0.25F, 0.5F, side), -side * 0.75F) << "both push inward";
  }
}

TEST(EndStop, WhateverTheStickDoes_ThePushIsANumber) {
  const float largest = std::numeric_limits<float>::max();
  const EndStopSettings hard{0.5F, largest, largest};
  for (const float position : {0.6F, -0.6F, largest, -largest}) {
    for (const float velocity : {0.0F, largest, -largest}) {
      const float push = end_stop_push(hard, position, velocity);
      EXPECT_TRUE(push >= 0 && push <= 1) << position << " " << velocity;
    }
  }
}

TEST(EndStop, SettingsOutOfRange_AreRefused) {
  EXPECT_EQ(validate(EndStopSettings{}), Status::kOk);
  EXPECT_EQ(validate(EndStopSettings{1, 0, 0}), Status::kOk);
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::nanf("");
  for (const EndStopSettings& bad : {EndStopSettings{0, 1, 1},
                                     {-1, 1, 1},
                                     {nan, 1, 1},
                                     {infinity, 1, 1},
                                     {1, -1, 1},
                                     {1, nan, 1},
                                     {1, infinity, 1},
                                     {1, 1, -1},
                                     {1, 1, nan},
                                     {1, 1, infinity}}) {
    EXPECT_EQ(validate(bad), Status::kInvalidArgument);
  }
}

RC_GTEST_PROP(EndStop, PushesInwardOnly_WithinTheRange_AndTheSameOnBothSides, ()) {
  const auto number = [](float most) {
    return static_cast<float>(*rc::gen::inRange(-1000, 1001)) * most / 1000;
  };
  const EndStopSettings settings{0.01F + std::abs(number(1)), std::abs(number(50)),
                                 std::abs(number(1))};
  const float share = number(1);
  const float position = number(1.5F);
  const float velocity = number(30);
  const float push = end_stop_push(settings, position, velocity);
  const float told = with_end_stop(share, push, position);
  const float side = position < 0 ? -1.0F : 1.0F;
  RC_ASSERT(std::abs(told) <= 1);
  RC_ASSERT(side * told <= side * share);
  RC_ASSERT(std::abs(position) > settings.start || told == share);
  // Seen in a mirror.
  if (position == 0) return;
  RC_ASSERT(end_stop_push(settings, -position, -velocity) == push);
  RC_ASSERT(with_end_stop(-share, push, -position) == -told);
}

}  // namespace
}  // namespace batuta
