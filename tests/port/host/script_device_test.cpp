// SPDX-License-Identifier: MIT
#include "programs/devices/script_device.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace batuta::host {
namespace {

class Scripts : public testing::TestWithParam<const char*> {};

TEST_P(Scripts, GiveOneSampleAMillisecond_Smoothly_InRange) {
  ScriptDevice device(*script_named(GetParam()));
  InputSample last;
  ASSERT_EQ(device.read(0, last), Status::kOk);
  float farthest = 0;
  for (Microseconds ms = 1; ms < 20'000; ++ms) {
    InputSample sample;
    ASSERT_EQ(device.read(ms * 1000U, sample), Status::kOk);
    EXPECT_EQ(sample.time, ms * 1000U);
    EXPECT_EQ(sample.sequence, ms);
    const float step = std::hypot(sample.x - last.x, sample.y - last.y);
    ASSERT_LT(step, 0.02F) << "20 deflections a second is more than a hand can do, at " << ms;
    farthest = std::fmax(farthest, step);
    ASSERT_EQ(device.read(ms * 1000U + 999U, sample), Status::kUnavailable);
    last = sample;
  }
  EXPECT_GT(farthest, 1e-5F) << "it moves";
}

TEST_P(Scripts, GiveTheSameTwice_AndWhenSamplesAreSkipped) {
  ScriptDevice every(*script_named(GetParam()));
  ScriptDevice seventh(*script_named(GetParam()));
  for (Microseconds ms = 0; ms < 10'000; ++ms) {
    InputSample a;
    InputSample b;
    ASSERT_EQ(every.read(ms * 1000U, a), Status::kOk);
    if (ms % 7 != 0) continue;
    ASSERT_EQ(seventh.read(ms * 1000U + 300U, b), Status::kOk);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.sequence, b.sequence);
  }
}

TEST_P(Scripts, NeverEnd_AcrossTheWrapOfTheClock) {
  ScriptDevice device(*script_named(GetParam()));
  InputSample sample;
  Microseconds now = 0;
  for (int minute = 0; minute < 100; ++minute, now += 60'000'000U) {
    ASSERT_EQ(device.read(now, sample), Status::kOk);
    EXPECT_EQ(sample.time, now);
  }
  EXPECT_EQ(device.read(now - 120'000'000U, sample), Status::kUnavailable) << "a clock gone back";
  EXPECT_TRUE(std::isinf(device.duration()));
}

INSTANTIATE_TEST_SUITE_P(All, Scripts, testing::Values("guard", "parry", "attack"),
                         [](const auto& script) { return std::string(script.param); });

TEST(Scripts, OtherNamesAreUnknown) {
  EXPECT_FALSE(script_named("riposte"));
  EXPECT_FALSE(script_named(""));
}

}  // namespace
}  // namespace batuta::host
