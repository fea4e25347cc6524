// SPDX-License-Identifier: MIT
// Encoder and Coulomb friction: below 2 f_c / Delta every stick comes to rest, above it there are
// places where none ever does. The springs are far below the bound of sampling.
#include <gtest/gtest.h>

#include "draws.hpp"
#include "sampled_loop.hpp"

namespace batuta {
namespace {

constexpr double kFriction = 0.02;
constexpr double kStep = 1e-3;
constexpr double kBound = 2 * kFriction / kStep;

/// At rest between two steps of the encoder: where what it shows is furthest from what is.
test::LoopSettings loop_with(double stiffness) {
  test::LoopSettings loop;
  loop.axis.period = 1e-3;
  loop.axis.mass = 0.05;
  loop.axis.damping = 0.2;  // 2 b / T = 400
  loop.axis.friction = kFriction;
  loop.encoder_step = kStep;
  loop.gains.stiffness = stiffness;
  loop.centre = 0.5 * kStep;
  return loop;
}

/// Whether it still moves in the last fifth of 10 s.
bool never_rests(const test::LoopSettings& settings, double start, double speed) {
  constexpr int kSteps = 10'000;
  return test::last_way(settings, start, speed, kSteps) > 0;
}

TEST(HapticEncoder, LimitCycle_BeginsAtTheBound) {
  const double onset = test::onset(
      0.5 * kBound, 2 * kBound, [](double K) { return never_rests(loop_with(K), 0.3 * kStep, 0); });
  EXPECT_NEAR(onset / kBound, 1, 0.01);
}

TEST(HapticEncoder, BelowTheBound_EverythingComesToRest) {
  test::Draws draws(61, 0, 0);
  for (int i = 0; i < 100; ++i) {
    test::LoopSettings loop = loop_with(kBound * draws.between(0.5, 0.99));
    loop.centre = kStep * draws.between(0, 1);
    const double start = kStep * draws.between(-5, 5);
    EXPECT_FALSE(never_rests(loop, start, draws.between(-0.1, 0.1))) << i;
  }
}

// A faster loop does not help against an encoder.
TEST(HapticEncoder, FourTimesTheRate_ChangesNothing) {
  for (const double period : {0.25e-3, 1e-3}) {
    test::LoopSettings loop = loop_with(1.05 * kBound);
    loop.axis.period = period;
    EXPECT_TRUE(never_rests(loop, 0.3 * kStep, 0)) << period;
    loop.gains.stiffness = 0.95 * kBound;
    EXPECT_FALSE(never_rests(loop, 0.3 * kStep, 0)) << period;
  }
}

}  // namespace
}  // namespace batuta
