// SPDX-License-Identifier: MIT
// What the advisor is given of a device that was measured, and why that is safe.
#include <array>
#include <vector>

#include "hostile_numbers.hpp"
#include "measured_device.hpp"

namespace batuta {
using namespace haptics;
namespace {

// The advisor's answer to what was measured, beside its answer to the truth.
TEST(MeasuredProfile, OfADevice_AdvisesNoMoreThanTheTruthAndNotMuchLess) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    test::MeasuredDevice device;
    device.encoder_step = i % 2 == 0 ? 1e-4 : 1e-3;
    device.delay = static_cast<double>(i % 5);
    test::Measuring measuring(device, i);
    ASSERT_EQ(measuring.run(), MeasurementState::kMeasured) << i;
    const auto profile = measured_profile(measuring.settings, measuring.measurement.estimates(), 3);
    ASSERT_EQ(profile.status, Status::kOk);
    DeviceProfile<float> truth = profile.value;
    truth.delay = static_cast<int>(device.delay);
    // An encoder too coarse to tell a whole delay from a part more has it rounded up.
    const int rounded_up = profile.value.delay - truth.delay;
    EXPECT_TRUE(rounded_up == 0 || (rounded_up == 1 && i % 2 == 1)) << i;
    truth.damping = static_cast<float>(device.damping);
    truth.friction = static_cast<float>(device.friction);
    truth.encoder_step = static_cast<float>(device.encoder_step);
    const float most = largest_stiffness(truth, 0.0F).value.largest;
    const float advised = largest_stiffness(profile.value, 0.0F).value.largest;
    EXPECT_LE(advised, most) << i;
    truth.delay += i % 2 == 1 ? 1 : 0;
    EXPECT_GE(advised, 0.9F * largest_stiffness(truth, 0.0F).value.largest) << i;
  }
}

TEST(MeasuredProfile, HostileEstimates_AreRefusedOrAreAProfile) {
  MeasurementSettings settings;
  settings.force_limit = 5;
  Estimate DeviceEstimates::*const fields[] = {&DeviceEstimates::damping,
                                               &DeviceEstimates::friction, &DeviceEstimates::delay,
                                               &DeviceEstimates::encoder_step};
  for (const float bad : test::kHostile<float>) {
    for (const auto field : fields) {
      for (const bool is_sigma : {false, true}) {
        DeviceEstimates estimates;
        (is_sigma ? (estimates.*field).sigma : (estimates.*field).value) = bad;
        const auto profile = measured_profile(settings, estimates, 3);
        EXPECT_TRUE(!profile.ok() || validate(profile.value) == Status::kOk) << bad;
      }
    }
    if (!(bad >= 0.0F && is_finite(bad))) {
      EXPECT_EQ(measured_profile(settings, {}, bad).status, Status::kInvalidArgument) << bad;
    }
  }
}

/// Good ones, all of whose numbers are other ones.
DeviceEstimates good_estimates() {
  DeviceEstimates estimates;
  estimates.damping = {1, 0.01F};
  estimates.friction = {2, 0.02F};
  estimates.mass = {3, 0.03F};
  estimates.stiffness = {4, 0.04F};
  estimates.offset = {-5, 0.05F};
  estimates.delay = {1, 0.06F};
  estimates.encoder_step = {0.001F, 1e-5F};
  estimates.misfit = 0.01F;
  return estimates;
}

// Also what the profile does not have: whatever made it is not to be believed in the rest. A
// negative error would tell more damping and friction than were measured.
TEST(MeasuredProfile, NumberThatIsNone_OrErrorBelowZero_IsRefused) {
  MeasurementSettings settings;
  settings.force_limit = 5;
  ASSERT_EQ(measured_profile(settings, good_estimates(), 3).status, Status::kOk);
  Estimate DeviceEstimates::*const fields[] = {
      &DeviceEstimates::damping,     &DeviceEstimates::friction, &DeviceEstimates::mass,
      &DeviceEstimates::stiffness,   &DeviceEstimates::offset,   &DeviceEstimates::delay,
      &DeviceEstimates::encoder_step};
  const float infinite = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto status = [&settings](const DeviceEstimates& estimates, float margin) {
    return measured_profile(settings, estimates, margin).status;
  };
  for (const float margin : {0.0F, 3.0F}) {
    for (const auto field : fields) {
      for (const float bad : {infinite, -infinite, nan, -1e-6F}) {
        DeviceEstimates estimates = good_estimates();
        (estimates.*field).sigma = bad;
        EXPECT_EQ(status(estimates, margin), Status::kInvalidArgument) << bad;
        if (is_finite(bad)) continue;
        estimates = good_estimates();
        (estimates.*field).value = bad;
        EXPECT_EQ(status(estimates, margin), Status::kInvalidArgument) << bad;
      }
      DeviceEstimates estimates = good_estimates();
      (estimates.*field).sigma = 0;
      EXPECT_EQ(status(estimates, margin), Status::kOk);
    }
    for (const float bad : {infinite, -infinite, nan}) {
      DeviceEstimates estimates = good_estimates();
      estimates.misfit = bad;
      EXPECT_EQ(status(estimates, margin), Status::kInvalidArgument) << bad;
    }
  }
}

DeviceProfile<float> profile_of(float delay, float error) {
  MeasurementSettings settings;
  settings.force_limit = 5;
  DeviceEstimates estimates;
  estimates.delay = {delay, error};
  estimates.damping = {1, 0};
  return measured_profile(settings, estimates, 3).value;
}

// Three sigma more than was measured, and up to a whole number; 2.05 is 2 with a damping of
// 2.5 / (2.5 + 1.5 x 0.05) = 2.5 / 2.575.
TEST(MeasuredProfile, Delay_IsNoLessThanItMayBe) {
  EXPECT_EQ(profile_of(2.02F, 0.01F).delay, 2);
  EXPECT_NEAR(profile_of(2.02F, 0.01F).damping, 2.5 / 2.575, 1e-6);
  EXPECT_EQ(profile_of(1.98F, 0.01F).delay, 2);
  EXPECT_NEAR(profile_of(1.98F, 0.01F).damping, 2.5 / 2.515, 1e-6);
  EXPECT_EQ(profile_of(1.95F, 0.01F).delay, 2);
  EXPECT_EQ(profile_of(1.95F, 0.01F).damping, 1.0F);
  EXPECT_EQ(profile_of(2.08F, 0.01F).delay, 3);
  EXPECT_EQ(profile_of(2.08F, 0.01F).damping, 1.0F);
  EXPECT_EQ(profile_of(2.5F, 0.01F).delay, 3);
  EXPECT_EQ(profile_of(2.0F, 0.2F).delay, 3);
  EXPECT_EQ(profile_of(-0.01F, 0.001F).delay, 0);
  EXPECT_EQ(profile_of(-0.01F, 0.001F).damping, 1.0F);
}

/// Whether a spring of stiffness K can give a hand energy in kPeriods from rest, where b = T = 1
/// and its force is held after n + w periods: whether the loss, a square form of the ways, two to a
/// period, before the force changes and after, has a pivot below zero. Nothing here is of the
/// proof.
bool gives_energy(double K, int n, double w) {
  constexpr int kPeriods = 48;
  constexpr int kWays = 2 * kPeriods;
  std::vector<std::array<double, kWays>> loss(kWays);
  const auto pull = [&](int way, int sample) {  // K q way, q the sum of all ways to the sample
    for (int i = 0; i < 2 * sample; ++i) {
      loss[way][i] += K / 2;
      loss[i][way] += K / 2;
    }
  };
  for (int k = 0; k < kPeriods; ++k) {  // from sample k to the next
    pull(2 * k, k - n - 1);
    pull(2 * k + 1, k - n);
    loss[2 * k][2 * k] += 1 / w;
    loss[2 * k + 1][2 * k + 1] += 1 / (1 - w);
  }
  for (int i = 0; i < kWays; ++i) {
    if (loss[i][i] < 0) return true;
    for (int j = i + 1; j < kWays; ++j) {
      const double share = loss[j][i] / loss[i][i];
      for (int k = i + 1; k < kWays; ++k) loss[j][k] -= share * loss[i][k];
    }
  }
  return false;
}

TEST(MeasuredProfile, DelayInParts_GivesNoEnergyAway) {
  for (int n = 0; n < 3; ++n) {
    for (const float w : {0.01F, 0.03F, 0.06F, 0.09F}) {
      const DeviceProfile<float> told = profile_of(static_cast<float>(n) + w, 0);
      ASSERT_EQ(told.delay, n);
      const double T = static_cast<double>(told.period);
      const double K = static_cast<double>(largest_stiffness(told, 0.0F).value.largest) * T;
      EXPECT_FALSE(gives_energy(K, n, static_cast<double>(w))) << n << " + " << w;
      // Without the damping that the part takes it is beyond what may be.
      EXPECT_TRUE(gives_energy(1.02 / (n + 0.5), n, static_cast<double>(w))) << n << " + " << w;
    }
  }
}

}  // namespace
}  // namespace batuta
