// SPDX-License-Identifier: MIT
// R05: two rods that hands press against each other. And a rod between two posts: what pushes it
// out of one does not push it into the other.
#include <gtest/gtest.h>

#include "resting.hpp"

namespace batuta {
namespace {

template <class S>
class Pressed : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Pressed, Scalars);

template <class SceneT>
Actor<SceneT> led(double z, const Vec3<double>& axis) {
  auto rod = test::rod_at<SceneT>({0, 0, z}, axis);
  Hand<typename SceneT::Scalar> hand;
  hand.target_W = rod.body.X_WB;
  hand.target_W.p_W.z() = static_cast<typename SceneT::Scalar>(-z);  // beyond the other one
  hand.step = static_cast<typename SceneT::Scalar>(test::kTick);
  rod.driver = hand;
  return rod;
}

/// @returns steps in which a pair was frozen
template <class SceneT>
int press(const Vec3<double>& axis, double start) {
  using S = typename SceneT::Scalar;
  World<SceneT> world;
  (void)world.add(led<SceneT>(start, Vec3<double>::UnitX()));
  (void)world.add(led<SceneT>(-start, axis));
  int frozen = 0;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(world.step(static_cast<S>(test::kTick)), Status::kOk);
    EXPECT_TRUE(world.report().complete()) << i;
    EXPECT_GT(test::least_gap<SceneT>(world), 0) << i;
    EXPECT_LE(test::most_separations(world), SceneT::kMaxSeparations) << i;
    EXPECT_EQ(world.report().frozen > 0, world.report().time_held > 0) << i;
    frozen += world.report().frozen > 0 ? 1 : 0;
  }
  return frozen;
}

TYPED_TEST(Pressed, ByHandsFromBothSides_NeverOverlap) {
  using SceneT = test::RestScene<TypeParam>;
  for (const double start : {0.0101, 0.012, 0.05}) {
    for (const Vec3<double>& axis : {Vec3<double>(Vec3<double>::UnitX()), Vec3<double>(Vec3<double>::UnitY())}) {
      std::printf("  start %g: frozen in %d steps\n", start, press<SceneT>(axis, start));
    }
  }
}

TYPED_TEST(Pressed, BetweenTwoPosts_IsPushedIntoNeither) {
  using SceneT = test::RestScene<TypeParam>;
  using S = typename SceneT::Scalar;
  for (const double D : {1e-4, 1e-3, 5e-2}) {
    World<SceneT> world;
    WorldSettings<SceneT> settings;
    settings.separation = static_cast<S>(D);
    ASSERT_EQ(world.configure(settings), Status::kOk);
    constexpr double kNear = 3e-4;
    constexpr double kReach = 2 * test::kRodRadius + kNear;
    (void)world.add(test::rod_at<SceneT>({0, 0, 0}, Vec3<double>::UnitX()));
    for (const double side : {-0.35, 0.35}) {
      (void)world.add(test::post_at<SceneT>({side, 0, -kReach}, Vec3<double>::UnitY()));
      (void)world.add(test::post_at<SceneT>({side, 0, kReach}, Vec3<double>::UnitY()));
    }
    std::uint32_t separations = 0;
    for (int i = 0; i < 1000; ++i) {
      ASSERT_EQ(world.step(static_cast<S>(test::kTick)), Status::kOk);
      ASSERT_TRUE(world.report().complete()) << D << ' ' << i;
      ASSERT_GT(test::least_gap<SceneT>(world), 0) << D << ' ' << i;
      separations += world.report().separations;
    }
    EXPECT_GT(separations, 10U);
  }
}

}  // namespace
}  // namespace batuta
