// SPDX-License-Identifier: MIT
// A body between neighbours: a shift by separation is cut short only by those it leads towards.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace batuta {
namespace {

template <class S>
class WorldSupports : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WorldSupports, Scalars);

constexpr double kRadius = 0.05;
constexpr double kNear = 1e-5;  // gap between the rod and each post, m

/// A rod along z at x = 0 that drifts slowly towards -x, and a post on the side `x` of it at z.
template <class S>
struct Rack {
  using SceneT = test::FlightScene<S>;
  using BodyId = typename World<SceneT>::BodyId;
  World<SceneT> world;
  BodyId rod;

  Rack() {
    auto actor = test::rod<SceneT>(0, 0.5, kRadius);
    actor.body.momentum.linear_W = test::vec<S>(-2e-3, 0, 0);
    rod = world.add(actor).value;
  }
  BodyId add_post(double side, double z) {
    auto post = test::post<SceneT>(side * (2 * kRadius + kNear), kRadius);
    post.body.X_WB.p_W.z() = static_cast<S>(z);
    return world.add(post).value;
  }
  double gap_to(BodyId post) {
    const auto shape = [this](BodyId id) {
      return to_world(world.get(id)->body.X_WB, world.get(id)->capsule_B);
    };
    return static_cast<double>(capsule_gap(shape(rod), shape(post)).gap);
  }
};

TYPED_TEST(WorldSupports, TwoOnOneSide_BothGapsOpenToD) {
  Rack<TypeParam> rack;
  const auto low = rack.add_post(-1, -0.3);
  const auto high = rack.add_post(-1, 0.3);
  const auto D = static_cast<double>(WorldSettings<test::FlightScene<TypeParam>>{}.separation);
  for (int step = 0; step < 20; ++step) {
    ASSERT_EQ(rack.world.step(TypeParam(1e-2)), Status::kOk);
    ASSERT_TRUE(rack.world.report().complete()) << step;
    ASSERT_GT(rack.gap_to(low), 0) << step;
    ASSERT_GT(rack.gap_to(high), 0) << step;
    if (rack.world.report().separations == 0) continue;
    // The centre is pushed out by D; what a tilt takes from one end it gives to the other.
    EXPECT_GT(rack.gap_to(low) + rack.gap_to(high), D);
    return;
  }
  FAIL() << "the rod never came to rest on its posts";
}

TYPED_TEST(WorldSupports, OneOnEachSide_NeverPushedIntoTheOther) {
  Rack<TypeParam> rack;
  const auto below = rack.add_post(-1, 0);
  const auto above = rack.add_post(1, 0);
  std::uint32_t separations = 0;
  for (int step = 0; step < 20; ++step) {
    ASSERT_EQ(rack.world.step(TypeParam(1e-2)), Status::kOk);
    separations += rack.world.report().separations;
    ASSERT_GT(rack.gap_to(below), 0) << step;
    ASSERT_GT(rack.gap_to(above), 0) << step;
  }
  EXPECT_GT(separations, 0U);
}

}  // namespace
}  // namespace batuta
