// SPDX-License-Identifier: MIT
// R06: a ball that bounces ever lower (Zeno) comes to rest, with a bounded number of events. And a
// rod that lands flat is not set spinning.
#include <gtest/gtest.h>

#include "resting.hpp"

namespace batuta {
namespace {

template <class S>
class Bouncing : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Bouncing, Scalars);

constexpr double kG = 9.81;
constexpr double kRadius = 0.05;
constexpr double kDrop = 0.1;
constexpr double kD = 1e-4;

TYPED_TEST(Bouncing, BallWithEOf09_ComesToRestAfterTheTimeItsBouncesTake) {
  using SceneT = test::RestScene<TypeParam>;
  for (const double e : {0.0, 0.5, 0.9}) {
    World<SceneT> world;
    const double floor = kRadius + test::kRodRadius;
    auto ball = test::ball_at<SceneT>({0, 0, floor + kDrop}, kRadius);
    ball.restitution = static_cast<TypeParam>(e);
    (void)world.add(ball);
    (void)world.add(test::post_at<SceneT>({0, 0, 0}, Vec3<double>::UnitY()));
    const World<SceneT>& shown = world;
    const double height_of_fall = std::sqrt(2 * kDrop / kG);
    const double all_bounces = height_of_fall * (1 + e) / (1 - e);
    int most_events = 0;
    double last_above = 0;  // when it was last more than a rest away from its place
    const auto steps = static_cast<int>((all_bounces + 2) / test::kTick);
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(world.step(static_cast<TypeParam>(test::kTick)), Status::kOk);
      ASSERT_TRUE(world.report().complete());
      ASSERT_GT(test::least_gap(shown), 0);
      ASSERT_EQ(world.report().frozen, 0U);
      most_events = std::max(most_events, static_cast<int>(world.events().size()));
      if (test::least_gap(shown) > 1.5 * kD) last_above = test::kTick * i;
    }
    EXPECT_LE(most_events, 2) << e;
    EXPECT_LT(last_above, all_bounces + 0.1) << e;
    // Below the rest speed v a bounce is none: with it all that would come after, of 2 v / g each.
    const double rest = std::sqrt(2 * kG * kD);
    EXPECT_GT(last_above, all_bounces - 2 * rest / kG / (1 - e) - 0.05) << e;
  }
}

// In one blow, and with the two ends of the line in no order: no spin.
TYPED_TEST(Bouncing, RodThatLandsFlat_IsNotSetSpinning) {
  using SceneT = test::RestScene<TypeParam>;
  for (const double e : {0.0, 0.7}) {
    World<SceneT> world;
    auto rod = test::rod_at<SceneT>({0, 0.1, 0.1}, Vec3<double>::UnitY());
    rod.restitution = static_cast<TypeParam>(e);
    (void)world.add(rod);
    // The line of contact reaches from one end of the rod to the other, and no further.
    auto floor = test::post_at<SceneT>({0, 0, 0}, Vec3<double>::UnitY());
    floor.capsule_B.axis = {test::vector<TypeParam>(0, -2, 0), test::vector<TypeParam>(0, 2, 0)};
    (void)world.add(floor);
    const World<SceneT>& shown = world;
    std::uint32_t hits = 0;
    for (int i = 0; i < 1500; ++i) {
      ASSERT_EQ(world.step(static_cast<TypeParam>(test::kTick)), Status::kOk);
      ASSERT_TRUE(world.report().complete());
      hits += world.report().collisions;
      // Blows of 1 N s in all, at arms known to some u of the rod's length.
      const TypeParam spin = test::body_in(shown, 0).body.momentum.angular_W.norm();
      ASSERT_LT(spin, 64 * kRoundOff<TypeParam>) << i;
    }
    // What is faster than a fall through 4 D is a blow.
    std::uint32_t blows = 0;
    const double rest = std::sqrt(8 * kG * kD);
    for (double v = std::sqrt(2 * kG * (0.1 - 2 * test::kRodRadius)); v > rest; v *= e) ++blows;
    EXPECT_GE(hits, blows) << e;
  }
}

}  // namespace
}  // namespace batuta
