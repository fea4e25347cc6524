// SPDX-License-Identifier: MIT
// Within the advisor's bounds the stored energy falls at every sample, whatever holds the stick. By
// default for seconds; BATUTA_HAPTIC_SECONDS=3600 in the environment makes it a simulated hour.
#include <gtest/gtest.h>

#include <cstdlib>

#include "draws.hpp"
#include "sampled_loop.hpp"

namespace batuta {
using namespace haptics;
namespace {

constexpr double kPeriods[] = {0.25e-3, 0.5e-3, 1e-3, 2e-3, 5e-3};

double seconds_to_run() {
  const char* seconds = std::getenv("BATUTA_HAPTIC_SECONDS");
  return seconds != nullptr ? std::atof(seconds) : 5.0;
}

/// Of the energy, in a period: what rounding may add. The matrix of a period is good to some 1e-15.
constexpr double kRounding = 1e-13;

/// The largest growth over a period, as a share of the energy before. Where nearly nothing is left
/// the loop is pushed anew.
double largest_growth(const test::LoopSettings& settings, long steps) {
  constexpr double kLeft = 1e-6;
  test::SampledLoop loop(settings);
  loop.place(1, 0);
  double first = loop.stored();
  double before = first;
  double most = -1;
  for (long i = 0; i < steps; ++i) {
    loop.step();
    const double now = loop.stored();
    most = std::max(most, now / before - 1);
    before = now;
    if (now > kLeft * first) continue;
    loop.place(0.5, loop.settings().axis.period);
    before = first = loop.stored();
  }
  return most;
}

TEST(HapticEnergy, JustBelowTheBound_NeverGrows) {
  constexpr double kJustBelow = 0.999;
  for (const double period : kPeriods) {
    for (const auto& [delay, damping] : {std::pair(0, 0.0), {0, 0.3}, {2, 0.0}}) {
      const DeviceProfile<double> profile{period, delay, 0.8, 0, 0, 1, 1};
      test::LoopSettings loop;
      loop.axis.period = period;
      loop.axis.damping = profile.damping;
      loop.axis.hand_mass = 0.1;
      loop.axis.hand_stiffness = 20;
      loop.delay = delay;
      loop.gains.damping = damping;
      loop.gains.stiffness = kJustBelow * largest_stiffness(profile, damping).value.largest;
      const long steps = static_cast<long>(seconds_to_run() / period);
      EXPECT_LE(largest_growth(loop, steps), kRounding) << period << ' ' << delay;
    }
  }
}

/// Any device, any gains within its bounds, any hand.
struct Drawn {
  test::LoopSettings loop;
  bool is_rough = false;  ///< with friction and an encoder
};

Drawn draw(std::uint64_t number) {
  test::Draws draws(51, 0, number);
  Drawn drawn;
  DeviceProfile<double> profile;
  profile.period = std::exp(draws.between(std::log(0.25e-3), std::log(5e-3)));
  profile.delay = static_cast<int>(draws.between(0, 4));
  profile.damping = std::exp(draws.between(-4, 1));
  profile.force_limit = profile.travel = 1;
  drawn.is_rough = draws.chance(0.5);
  if (drawn.is_rough) {
    profile.friction = std::exp(draws.between(-5, 0));
    profile.encoder_step = std::exp(draws.between(-10, -3));
  }
  const double most_B = largest_damping(profile, 0.0).value.largest;
  drawn.loop.gains.damping = draws.chance(0.3) ? 0 : most_B * draws.between(-1, 1);
  drawn.loop.gains.stiffness =
      largest_stiffness(profile, drawn.loop.gains.damping).value.largest * draws.between(0.5, 1);
  drawn.loop.delay = profile.delay;
  drawn.loop.encoder_step = profile.encoder_step;
  auto& axis = drawn.loop.axis;
  axis.period = profile.period;
  axis.damping = profile.damping;
  axis.friction = profile.friction;
  axis.mass = std::exp(draws.between(-5, 0));
  axis.hand_mass = draws.chance(0.3) ? 0 : std::exp(draws.between(-3, 3));
  const double turn = draws.between(0, 3) / axis.period;
  axis.hand_stiffness = draws.chance(0.3) ? 0 : (axis.mass + axis.hand_mass) * turn * turn;
  axis.hand_damping = draws.chance(0.5) ? 0 : draws.between(0, 1);
  return drawn;
}

TEST(HapticEnergy, AnyHandWithinTheBounds_EnergyNeverGrows) {
  int rough = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    const Drawn drawn = draw(number);
    ASSERT_EQ(validate(drawn.loop.axis), Status::kOk);
    EXPECT_LE(largest_growth(drawn.loop, drawn.is_rough ? 400 : 2000), kRounding) << number;
    rough += drawn.is_rough ? 1 : 0;
  }
  EXPECT_GT(rough, 100);
}

}  // namespace
}  // namespace batuta
