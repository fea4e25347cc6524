// SPDX-License-Identifier: MIT
// The longest delay that is measured, and the longest that a profile is made of.
#include "measured_device.hpp"

namespace batuta {
using namespace haptics;
using test::MeasuredDevice;
using test::Measuring;
namespace {

using State = MeasurementState;

State end_of(double delay) {
  MeasuredDevice device;
  device.delay = delay;
  return Measuring(device).run();
}

TEST(MeasuredDelay, UpTo16Periods_IsTold) {
  for (const double delay : {0.0, 1.0, 7.0, 12.0, 14.0, 15.0, 15.5}) {
    EXPECT_EQ(end_of(delay), State::kMeasured) << delay;
  }
}

TEST(MeasuredDelay, Beyond16Periods_IsCalledTooLong) {
  for (const double delay : {16.25, 16.5, 17.0, 18.0, 20.0, 40.0}) {
    EXPECT_EQ(end_of(delay), State::kDelayTooLong) << delay;
  }
}

/// What may be a part of a period longer than what is measured is told as the period after it.
TEST(MeasuredDelay, ProfileOf17Periods_IsTheLastThatThereIs) {
  MeasurementSettings settings;
  settings.force_limit = 5;
  DeviceEstimates estimates;
  estimates.delay = {16.5F, 0};
  const auto longest = measured_profile(settings, estimates, 3);
  ASSERT_EQ(longest.status, Status::kOk);
  EXPECT_EQ(longest.value.delay, 17);
  estimates.delay = {17.5F, 0};
  EXPECT_EQ(measured_profile(settings, estimates, 3).status, Status::kInvalidArgument);
}

}  // namespace
}  // namespace batuta
