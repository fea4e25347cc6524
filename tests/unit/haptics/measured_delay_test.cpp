// SPDX-License-Identifier: MIT
// The longest delay that is measured, the longest that a profile is made of, and how long measuring
// takes.
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

TEST(MeasuredDelay, Below16Periods_IsTold) {
  for (const double delay : {0.0, 1.0, 7.0, 12.0, 14.0, 15.0, 15.5}) {
    EXPECT_EQ(end_of(delay), State::kMeasured) << delay;
  }
}

TEST(MeasuredDelay, From16PeriodsOn_IsCalledTooLong) {
  for (const double delay : {16.0, 16.25, 16.5, 17.0, 18.0, 20.0, 40.0}) {
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

/// device_measurement.md, "The motion": 30,000 periods. A device that stuck once is not pushed as
/// weakly again; so it sticks no more than a few times, for 2000 periods each.
TEST(MeasuredDelay, AnyDevice_IsToldWithinThirtyThousandPeriods) {
  int told = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Measuring measuring(test::any_device(i), i);
    if (measuring.run() != State::kMeasured) continue;
    ++told;
    EXPECT_LE(measuring.measurement.steps(), 30'000) << i;
  }
  EXPECT_GT(told, 80);
}

}  // namespace
}  // namespace batuta
