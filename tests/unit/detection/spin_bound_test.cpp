// SPDX-License-Identifier: MIT
// A bar that spins while it travels, and the plane that it cannot reach before a known instant.
#include "../../../src/detection/spin_bound.hpp"

#include <gtest/gtest.h>

#include "moving.hpp"

namespace batuta {
namespace {

using testing_detection::Capsule64;
using testing_detection::moving;

constexpr double kLeast = 0.5;

/// A bar of half length 1.5 that turns about z, 5 m along x from a ball at the origin.
double free_until(double speed, double theta, double half = 1.5) {
  const Capsule64 ball{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0.1};
  Capsule64 bar{{5, 0, 0}, {-half, 0, 0}, {half, 0, 0}, 0.1};
  bar.v = {speed, 0, 0};
  bar.w = {0, 0, 40};
  const auto pair = make_moving_pair(moving<double>(ball), moving<double>(bar));
  EXPECT_TRUE(pair.ok());
  return free_until_by_spin<double>(pair.value, pair.value.B.v, {1, 0, 0}, kLeast, theta);
}

TEST(FreeUntilBySpin, Approaching_EndsWhereTheSwingReachesThePlane) {
  for (const double speed : {-4.0, -8.0, -100.0}) {
    const double truth = (5 - 1.5 - kLeast) / -speed;
    for (const double theta : {0.0, truth / 2}) {
      const double found = free_until(speed, theta);
      EXPECT_LE(found, truth) << speed;
      EXPECT_GE(found, truth * (1 - 1e-12)) << speed;
    }
  }
}

TEST(FreeUntilBySpin, TooSlowRestingOrParting_IsFreeToTheEnd) {
  for (const double speed : {-2.9, 0.0, 2.0}) EXPECT_EQ(free_until(speed, 0.25), 1.0) << speed;
}

TEST(FreeUntilBySpin, WithinReach_ProvesNothing) {
  EXPECT_EQ(free_until(-8, 0, 4.5), 0.0);
  EXPECT_EQ(free_until(2, 0.1, 5), 0.1);
}

}  // namespace
}  // namespace batuta
