// SPDX-License-Identifier: MIT
#include "batuta/haptics/gain_advisor.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "draws.hpp"

namespace batuta {
using namespace haptics;
namespace {

constexpr double kPi = 3.14159265358979323846;

template <class S>
class GainAdvisor : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(GainAdvisor, Scalars);

/// T = 1 ms, b = 0.8: the device of the textbook examples.
template <class S>
DeviceProfile<S> device(int delay = 0) {
  DeviceProfile<S> profile;
  profile.period = S(1e-3);
  profile.delay = delay;
  profile.damping = S(0.8);
  profile.force_limit = S(5);
  profile.travel = S(0.05);
  return profile;
}

template <class S>
DeviceProfile<S> with_encoder(double friction, double step) {
  DeviceProfile<S> profile = device<S>();
  profile.friction = static_cast<S>(friction);
  profile.encoder_step = static_cast<S>(step);
  return profile;
}

/// Weir and Colgate, eq. 8.2: the damping that the loop needs at the frequency theta / T.
double needed_damping(const DeviceProfile<double>& profile, const Gains<double>& gains,
                      double theta) {
  const std::complex<double> back = std::polar(1.0, -theta);  // z^-1
  const std::complex<double> H = (gains.stiffness + gains.damping / profile.period * (1.0 - back)) *
                                 std::pow(back, profile.delay);
  return profile.period / 2 / (1 - std::cos(theta)) * ((1.0 - back) * H).real();
}

double most_needed_damping(const DeviceProfile<double>& profile, const Gains<double>& gains) {
  constexpr int kFrequencies = 2000;
  double most = -1e9;
  for (int i = 1; i <= kFrequencies; ++i) {
    most = std::max(most, needed_damping(profile, gains, kPi * i / kFrequencies));
  }
  return most;
}

TYPED_TEST(GainAdvisor, TextbookDevices_GetTextbookStiffness) {
  using S = TypeParam;
  constexpr double kUlps = 4 * static_cast<double>(std::numeric_limits<S>::epsilon());
  const auto stiffness = [](const DeviceProfile<S>& profile, double damping) {
    return static_cast<double>(largest_stiffness(profile, static_cast<S>(damping)).value.largest);
  };
  DeviceProfile<S> slow = device<S>();
  slow.period = S(5e-3);
  EXPECT_NEAR(stiffness(device<S>(), 0), 1600, 1600 * kUlps);    // 2 b / T
  EXPECT_NEAR(stiffness(slow, 0), 320, 320 * kUlps);             // 5 ms
  EXPECT_NEAR(stiffness(device<S>(), 0.4), 800, 1600 * kUlps);   // 2 (b - B) / T
  EXPECT_NEAR(stiffness(device<S>(), -0.4), 800, 1600 * kUlps);  // 2 (b - |B|) / T
  EXPECT_NEAR(stiffness(device<S>(1), 0), 1600.0 / 3, 600 * kUlps);
  EXPECT_NEAR(stiffness(with_encoder<S>(0.05, 1e-4), 0), 1000, 1000 * kUlps);  // 2 f_c / Delta
}

TYPED_TEST(GainAdvisor, Damper_GetsWhatTheSpringLeaves) {
  using S = TypeParam;
  constexpr double kUlps = 8 * static_cast<double>(std::numeric_limits<S>::epsilon());
  const auto damping = [](const DeviceProfile<S>& profile, double stiffness) {
    return static_cast<double>(largest_damping(profile, static_cast<S>(stiffness)).value.largest);
  };
  EXPECT_NEAR(damping(device<S>(), 0), 0.8, kUlps);
  EXPECT_NEAR(damping(device<S>(), 800), 0.4, kUlps);                   // b - K T / 2
  EXPECT_NEAR(damping(device<S>(2), 200), 0.3, kUlps);                  // b - 5 K T / 2
  EXPECT_NEAR(damping(with_encoder<S>(0.05, 1e-4), 500), 0.25, kUlps);  // T (f_c / Delta - K / 2)
}

TYPED_TEST(GainAdvisor, Limit_NamesTheBoundThatBinds) {
  using S = TypeParam;
  EXPECT_EQ(largest_stiffness(device<S>(), S(0)).value.bound, GainBound::kSampling);
  EXPECT_EQ(largest_stiffness(with_encoder<S>(0.05, 1e-4), S(0)).value.bound, GainBound::kEncoder);
  EXPECT_EQ(largest_stiffness(with_encoder<S>(0.05, 1e-5), S(0)).value.bound, GainBound::kSampling);
  EXPECT_EQ(largest_damping(with_encoder<S>(0.05, 1e-4), S(0)).value.bound, GainBound::kEncoder);
  EXPECT_EQ(largest_damping(with_encoder<S>(0.05, 1e-5), S(0)).value.bound, GainBound::kSampling);
}

TYPED_TEST(GainAdvisor, NothingLeft_IsZero) {
  using S = TypeParam;
  const auto stiffness = largest_stiffness(device<S>(), S(0.9));
  EXPECT_EQ(stiffness.status, Status::kOk);
  EXPECT_EQ(stiffness.value.largest, S(0));
  EXPECT_EQ(largest_damping(device<S>(), S(1700)).value.largest, S(0));
  // An encoder without friction behind it has no stiffness at which it rests.
  EXPECT_EQ(largest_stiffness(with_encoder<S>(0, 1e-6), S(0)).value.largest, S(0));
}

TYPED_TEST(GainAdvisor, Force_IsAStatementOfItsOwn) {
  using S = TypeParam;
  EXPECT_NEAR(static_cast<double>(unsaturated_stiffness(device<S>()).value), 100, 1e-4);
  DeviceProfile<S> weak = device<S>();
  weak.force_limit = S(0.001);
  EXPECT_EQ(largest_stiffness(weak, S(0)).value.largest,
            largest_stiffness(device<S>(), S(0)).value.largest);
}

// The closed forms against the frequency-domain condition that they come from.
TEST(GainAdvisorTruth, OneGainAlone_UsesUpTheDampingAtSomeFrequency) {
  for (int delay = 0; delay <= 6; ++delay) {
    const DeviceProfile<double> profile = device<double>(delay);
    const double K = largest_stiffness(profile, 0.0).value.largest;
    const double B = largest_damping(profile, 0.0).value.largest;
    EXPECT_NEAR(most_needed_damping(profile, {K, 0}), profile.damping, 1e-4) << delay;
    EXPECT_NEAR(most_needed_damping(profile, {0, B}), profile.damping, 1e-4) << delay;
    EXPECT_NEAR(most_needed_damping(profile, {0, -B}), profile.damping, 1e-4) << delay;
  }
}

TEST(GainAdvisorTruth, BothGains_UseUpTheDampingWithoutDelayAndNeverMore) {
  test::Draws draws(31, 0, 0);
  for (int i = 0; i < 200; ++i) {
    const DeviceProfile<double> profile = device<double>(i % 5);
    const double B = profile.damping * draws.between(-1, 1);
    const double K = largest_stiffness(profile, B).value.largest;
    const double most = most_needed_damping(profile, {K, B});
    EXPECT_LE(most, profile.damping * (1 + 1e-12));
    if (profile.delay == 0) {
      EXPECT_NEAR(most, profile.damping, 1e-5);
    }
  }
}

TYPED_TEST(GainAdvisor, Check_TakesWhatWasAdvisedAndRefusesMore) {
  using S = TypeParam;
  test::Draws draws(32, 0, 0);
  int refused[2] = {0, 0};
  for (int i = 0; i < 2000; ++i) {
    DeviceProfile<S> profile = device<S>(i % 4);
    profile.period = static_cast<S>(std::exp(draws.between(-9, -4)));
    profile.damping = static_cast<S>(std::exp(draws.between(-6, 2)));
    profile.friction = static_cast<S>(std::exp(draws.between(-6, 0)));
    profile.encoder_step = i % 3 == 0 ? S(0) : static_cast<S>(std::exp(draws.between(-12, -4)));
    const S B = largest_damping(profile, S(0)).value.largest * static_cast<S>(draws.between(0, 1));
    const auto K = largest_stiffness(profile, B);
    ASSERT_EQ(K.status, Status::kOk);
    EXPECT_EQ(check(profile, {K.value.largest, B}), GainVerdict::kInside);
    const S some = K.value.largest * static_cast<S>(draws.between(0, 1));
    const auto most_B = largest_damping(profile, some);
    EXPECT_EQ(check(profile, {some, most_B.value.largest}), GainVerdict::kInside);
    if (K.value.largest * profile.period < S(0.01) * profile.damping) continue;  // B took it all
    const bool by_sampling = K.value.bound == GainBound::kSampling;
    EXPECT_EQ(check(profile, {K.value.largest * S(1.01), B}),
              by_sampling ? GainVerdict::kBeyondSampling : GainVerdict::kBeyondEncoder);
    ++refused[by_sampling ? 0 : 1];
  }
  EXPECT_GT(refused[0], 100);
  EXPECT_GT(refused[1], 100);
}

TYPED_TEST(GainAdvisor, OutOfRange_IsRefused) {
  using S = TypeParam;
  constexpr S kNan = std::numeric_limits<S>::quiet_NaN();
  constexpr S kInfinity = std::numeric_limits<S>::infinity();
  using Field = S DeviceProfile<S>::*;
  const auto refused = [](const DeviceProfile<S>& profile) {
    return validate(profile) == Status::kInvalidArgument &&
           largest_stiffness(profile, S(0)).status == Status::kInvalidArgument &&
           largest_damping(profile, S(0)).status == Status::kInvalidArgument &&
           unsaturated_stiffness(profile).status == Status::kInvalidArgument &&
           check(profile, {S(0), S(0)}) == GainVerdict::kInvalidProfile;
  };
  using Profile = DeviceProfile<S>;
  for (const Field field : {&Profile::period, &Profile::damping, &Profile::friction,
                            &Profile::encoder_step, &Profile::force_limit, &Profile::travel}) {
    for (const S bad : {S(-1), kNan, kInfinity}) {
      Profile profile = device<S>();
      profile.*field = bad;
      EXPECT_TRUE(refused(profile));
    }
  }
  for (const Field field : {&Profile::period, &Profile::force_limit, &Profile::travel}) {
    Profile profile = device<S>();
    profile.*field = S(0);
    EXPECT_TRUE(refused(profile));
  }
  EXPECT_TRUE(refused(device<S>(-1)));
  for (const S bad : {kNan, kInfinity}) {
    EXPECT_EQ(check(device<S>(), {bad, S(0)}), GainVerdict::kInvalidGains);
    EXPECT_EQ(check(device<S>(), {S(0), bad}), GainVerdict::kInvalidGains);
    EXPECT_EQ(largest_stiffness(device<S>(), bad).status, Status::kInvalidArgument);
    EXPECT_EQ(largest_damping(device<S>(), bad).status, Status::kInvalidArgument);
  }
  EXPECT_EQ(check(device<S>(), {S(-1), S(0)}), GainVerdict::kInvalidGains);
  EXPECT_EQ(largest_damping(device<S>(), S(-1)).status, Status::kInvalidArgument);
}

TYPED_TEST(GainAdvisor, BeyondTheNumbers_IsRefusedNotInfinite) {
  using S = TypeParam;
  DeviceProfile<S> profile = device<S>();
  profile.period = std::numeric_limits<S>::min();
  profile.damping = std::numeric_limits<S>::max();
  EXPECT_EQ(largest_stiffness(profile, S(0)).status, Status::kInvalidArgument);
  EXPECT_EQ(check(device<S>(), {std::numeric_limits<S>::max(), S(0)}),
            GainVerdict::kBeyondSampling);
  EXPECT_EQ(check(device<S>(), {S(0), std::numeric_limits<S>::max()}),
            GainVerdict::kBeyondSampling);
  profile.force_limit = std::numeric_limits<S>::max();
  EXPECT_EQ(unsaturated_stiffness(profile).status, Status::kInvalidArgument);
  // The encoder's bound is finite where that of sampling is not.
  profile.friction = S(1);
  profile.encoder_step = S(1);
  profile.delay = 0;
  EXPECT_EQ(largest_stiffness(profile, S(0)).value.largest, S(2));
}

}  // namespace
}  // namespace batuta
