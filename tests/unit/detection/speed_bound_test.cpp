// SPDX-License-Identifier: MIT
#include "batuta/detection/speed_bound.hpp"

#include <gtest/gtest.h>

#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class SpeedBoundOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SpeedBoundOf, Scalars);

TYPED_TEST(SpeedBoundOf, LinearMotion_IsTheSpeed) {
  const auto m = moving<TypeParam>({{9, 9, 9}, {0, -1, 0}, {0, 1, 0}, 0.1, {3, 4, 0}});
  EXPECT_GE(speed_bound(m), TypeParam(5));
  EXPECT_LE(speed_bound(m), TypeParam(5) * (1 + 64 * kRoundOff<TypeParam>));
}

TYPED_TEST(SpeedBoundOf, Turning_AddsLeverAndRadius) {
  const auto m = moving<TypeParam>({{0, 0, 0}, {-1, 0, 0}, {2, 0, 5}, 0.5, {1, 0, 0}, {0, 0, 4}});
  EXPECT_NEAR(static_cast<double>(speed_bound(m)), 1 + 4 * 2 + 4 * 0.5, 1e-4);
}

TYPED_TEST(SpeedBoundOf, AtRest_IsZero) {
  const auto m = moving<TypeParam>({{1, 2, 3}, {-1, 0, 0}, {1, 0, 0}, 0.5});
  EXPECT_EQ(speed_bound(m), TypeParam(0));
  EXPECT_EQ(closing_speed_bound(make_moving_pair(m, m).value), TypeParam(0));
}

TYPED_TEST(SpeedBoundOf, MotionThatUnderflows_IsNotRest) {
  constexpr double kTiny = 1e-30;
  const auto m =
      moving<TypeParam>({{0, 0, 0}, {kTiny, 0, 0}, {0, 0, 0}, 0, {0, 0, 0}, {0, 0, kTiny}});
  EXPECT_GT(speed_bound(m), TypeParam(0));
}

TYPED_TEST(SpeedBoundOf, CommonVelocity_DoesNotCount) {
  const auto A = moving<TypeParam>({{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, 0.5, {100, 0, 0}});
  const auto B = moving<TypeParam>({{5, 0, 0}, {-1, 0, 0}, {1, 0, 0}, 0.5, {101, 0, 0}});
  const TypeParam bound = closing_speed_bound(make_moving_pair(A, B).value);
  EXPECT_NEAR(static_cast<double>(bound), 1, 1e-5);
}

TEST(SpeedBound, RandomMotion_NoSurfacePointIsFaster) {
  std::mt19937 random(4);
  double tightest = 0;
  for (int i = 0; i < 500; ++i) {
    const auto m = random_moving<double>(random, 4);
    const double bound = speed_bound(m);
    const Vec3<double> direction = random_vector(random, 1).normalized();
    const Vec3<double> x_B =
        (i % 2 == 0 ? m.capsule_B.axis.a : m.capsule_B.axis.b) + m.capsule_B.radius * direction;
    const Pose<double> X_WB = pose_at(m.motion, 0.5);
    const double speed = velocity_at(X_WB, m.motion.twist, to_world(X_WB, x_B)).norm();
    ASSERT_LE(speed, bound) << i;
    tightest = max_of(tightest, speed / bound);
  }
  EXPECT_GT(tightest, 0.9);
}

TEST(ClosingSpeedBound, RandomPairs_NoGapChangesFaster) {
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const auto A = random_moving<double>(random, 4);
    const auto B = random_moving<double>(random, 4);
    const auto pair = make_moving_pair(A, B).value;
    const double bound = closing_speed_bound(pair);
    EXPECT_LE(bound, (speed_bound(A) + speed_bound(B)) * (1 + 1e-14)) << i;
    for (int k = 0; k < 20; ++k) {
      const double t = k / 20.0;
      const double change = gap_at(pair, t + 0.05).gap - gap_at(pair, t).gap;
      ASSERT_LE(std::abs(change), bound * 0.05 * (1 + 1e-12)) << i;
    }
  }
}

}  // namespace
}  // namespace batuta
