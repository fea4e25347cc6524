// SPDX-License-Identifier: MIT
// A blow or a push sends a ball, in the same step, to where nobody had looked for it.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace batuta {
namespace {

using test::ball;
using test::FlightScene;
using test::vec;

template <class SceneT>
class StruckAside : public testing::Test {};
using Scenes = testing::Types<FlightScene<float, Advancement>, FlightScene<double, Advancement>,
                              FlightScene<float, Stepping>, FlightScene<double, Stepping>>;
TYPED_TEST_SUITE(StruckAside, Scenes);

/// Three equal balls, smooth and elastic. The first, at 20 m/s along x, meets the second, at rest
/// at the origin, after 0.02 s, under half a right angle to either side, and gives it what it has
/// along the normal n: 10 sqrt(2). The third stands on the way there, off that of the first.
TYPED_TEST(StruckAside, Ball_MeetsWhoStandsOnItsNewWay) {
  using S = typename TypeParam::Scalar;
  for (const double side : {-1.0, 1.0}) {
    const Vec3<double> n = Vec3<double>(1, side, 0) / std::sqrt(2.0);
    World<TypeParam> world;
    const auto add = [&world](const Vec3<double>& place, double vx) {
      auto actor = ball<TypeParam>(place.x(), 0.1, vx);
      actor.body.X_WB.p_W.y() = static_cast<S>(place.y());
      return world.add(actor).value;
    };
    const auto first = add(-0.2 * n - Vec3<double>(0.4, 0, 0), 20);
    const auto second = add(Vec3<double>::Zero(), 0);
    const auto third = add(0.8 * n, 0);
    ASSERT_EQ(world.step(S(0.1)), Status::kOk);
    EXPECT_TRUE(world.report().complete());
    EXPECT_EQ(world.report().collisions, 2U);
    const auto velocity = [&world](auto id) {
      return Vec3<double>(world.get(id)->body.momentum.linear_W.template cast<double>());
    };
    // Places are met to some 1e-5 m. 0.2 m apart that turns a normal by 1e-4, and the next one, 0.6
    // m on, by four times as much: 1e-3 is more than both, of 20 m/s.
    constexpr double kBound = 20 * 1e-3;
    EXPECT_LE((velocity(first) - Vec3<double>(10, -10 * side, 0)).norm(), kBound);
    EXPECT_LE(velocity(second).norm(), kBound);
    EXPECT_LE((velocity(third) - Vec3<double>(10, 10 * side, 0)).norm(), kBound);
  }
}

constexpr SceneOptions pushing_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.max_contacts = 6;
  scene.resting = RestingContact::kSettling;
  return scene;
}
template <class S>
class PushedAside : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(PushedAside, Scalars);

/// 3 kg that touch a ball of 1 kg push it from rest to 1.5 m/s before anybody moves. Its way in the
/// step, 15 mm, leads into a post 5 mm away that is beyond the way of the heavy one, 20 mm.
TYPED_TEST(PushedAside, Ball_MeetsWhoStandsBeyond) {
  using S = TypeParam;
  using SceneT = Scene<pushing_options, Advancement<S>>;
  constexpr double kRadius = 0.1;
  for (const double side : {-1.0, 1.0}) {
    World<SceneT> world;
    const auto add = [&](double x, double mass, double v) {
      auto actor = ball<SceneT>(side * x, kRadius, 0);
      actor.body.inverse_mass = mass > 0 ? static_cast<S>(1 / mass) : S(0);
      if (mass == 0) actor.body.inverse_moments.setZero();
      actor.body.momentum.linear_W.x() = static_cast<S>(side * mass * v);
      actor.restitution = 0;
      return world.add(actor).value;
    };
    const auto x = [&](auto id) {
      return side * static_cast<double>(world.get(id)->body.X_WB.p_W.x());
    };
    add(-2 * kRadius - 5e-5, 3, 2);
    const auto pushed = add(0, 1, 0);
    const auto post = add(2 * kRadius + 5e-3, 0, 0);
    ASSERT_EQ(world.step(S(0.01)), Status::kOk);
    EXPECT_TRUE(world.report().complete());
    EXPECT_GT(x(pushed), 4e-3);
    EXPECT_LE(x(pushed) + 2 * kRadius, x(post) + 1e-6);
  }
}

}  // namespace
}  // namespace batuta
