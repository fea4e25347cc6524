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

/// A hand that never yields: at its speed, whatever it meets.
template <class S>
struct Press : Fixed<S> {
  Vec3<S> v_W = Vec3<S>::Zero();

  PlannedMotion<S> plan(const Body<S>& body, S /*t*/, S duration) const {
    PlannedMotion<S> course{still(body.X_WB, duration), false};
    course.motion.twist.v_W = v_W;
    return course;
  }
};

template <class S>
using PressScene =
    Scene<test::rest_scene_options, Advancement<S>, AnyController<S, FreeFlight<S>, Press<S>>>;

template <class SceneT>
Actor<SceneT> led(double z, double speed, const Vec3<double>& axis) {
  using S = typename SceneT::Scalar;
  auto rod = test::rod_at<SceneT>({0, 0, z}, axis);
  Press<S> hand;
  hand.v_W.z() = static_cast<S>(z > 0 ? -speed : speed);
  rod.controller = hand;
  return rod;
}

/// Runs for a second. @returns steps in which the pair was frozen
template <class SceneT>
int press(double speed, const Vec3<double>& axis) {
  World<SceneT> world;
  (void)world.add(led<SceneT>(0.0102, speed, Vec3<double>::UnitX()));
  (void)world.add(led<SceneT>(-0.0102, speed, axis));
  int frozen = 0;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(world.step(static_cast<typename SceneT::Scalar>(test::kTick)), Status::kOk);
    EXPECT_EQ(world.report().complete(), world.report().frozen == 0) << i;
    // 0.5 m to each end, ways of 1 cm at most.
    EXPECT_GT(test::least_gap<SceneT>(world), -test::margin<typename SceneT::Scalar>(1.2)) << i;
    EXPECT_LE(world.events().size(), SceneT::kMaxSeparations) << i;
    EXPECT_EQ(world.report().frozen > 0, world.report().time_held > 0) << i;
    frozen += world.report().frozen > 0 ? 1 : 0;
  }
  return frozen;
}

TYPED_TEST(Pressed, FromBothSides_IsFrozenAndFlaggedAndNeverOverlaps) {
  using SceneT = PressScene<TypeParam>;
  for (const Vec3<double>& axis :
       {Vec3<double>(Vec3<double>::UnitX()), Vec3<double>(Vec3<double>::UnitY())}) {
    EXPECT_GT(press<SceneT>(10.0, axis), 900);  // blows: a gap lasts for microseconds
    EXPECT_GT(press<SceneT>(0.5, axis), 900);
    // At rest speed: opened again and again, or frozen and flagged.
    EXPECT_GE(press<SceneT>(0.005, axis), 0);
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
    for (int i = 0; i < 1000; ++i) {
      ASSERT_EQ(world.step(static_cast<S>(test::kTick)), Status::kOk);
      // The widest D asks for eighty times the room that there is: what is held back is told.
      const auto& report = world.report();
      ASSERT_TRUE(report.complete() || (D > 1e-2 && report.frozen > 0)) << D << ' ' << i;
      ASSERT_GT(test::least_gap<SceneT>(world), -test::margin<S>(2)) << D << ' ' << i;
    }
    // It lies on the lower ones: their gap is 0.6 D at most, or all the room there is.
    const auto gap = static_cast<double>(test::body_in(world, 0).body.X_WB.p_W.z()) + kNear;
    EXPECT_LT(gap, std::min(0.6 * D, 2 * kNear) + test::margin<S>(2)) << D;
  }
}

}  // namespace
}  // namespace batuta
