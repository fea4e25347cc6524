// SPDX-License-Identifier: MIT
// R08: resting with a D of nothing, of less than rounding, and of more than a radius.
#include <gtest/gtest.h>

#include "resting.hpp"

namespace batuta {
namespace {

template <class S>
class RestingDistance : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RestingDistance, Scalars);

TYPED_TEST(RestingDistance, NothingOrNoNumber_IsRefused) {
  World<test::RestScene<TypeParam>> world;
  const auto before = world.settings().separation;
  const auto infinity = std::numeric_limits<TypeParam>::infinity();
  for (const TypeParam D : {TypeParam(0), -TypeParam(0), TypeParam(-1e-4), infinity,
                            std::numeric_limits<TypeParam>::quiet_NaN()}) {
    auto settings = world.settings();
    settings.separation = D;
    EXPECT_EQ(world.configure(settings), Status::kInvalidArgument) << D;
    EXPECT_EQ(world.settings().separation, before);
  }
}

// Less than rounding can tell: raised to what it can. More than a radius: that far apart, and held
// up there.
TYPED_TEST(RestingDistance, AnyOther_IsWhatTheGapIsRestoredTo) {
  using SceneT = test::RubbingScene<TypeParam>;
  constexpr double kRounding = 4e-5;  // no more than that in float, for rods of 1 m
  for (const double D : {1e-30, 1e-9, 1e-6, 1e-3, 2 * test::kRodRadius, 0.1}) {
    World<SceneT> world;
    auto settings = world.settings();
    settings.separation = static_cast<TypeParam>(D);
    ASSERT_EQ(world.configure(settings), Status::kOk);
    test::pile_up(world, test::Pile::kAcross, std::max(D, kRounding));
    const World<SceneT>& shown = world;
    const double most = std::max(D, kRounding);
    for (int i = 0; i < 2000; ++i) {
      ASSERT_EQ(world.step(static_cast<TypeParam>(test::kTick)), Status::kOk);
      ASSERT_TRUE(world.report().complete()) << D;
      ASSERT_GT(test::least_gap(shown), 0) << D << ' ' << i;
      // Where one end is lifted to D the other may be a little higher.
      ASSERT_LT(test::least_gap(shown), 1.01 * most) << D << ' ' << i;
      ASSERT_LT(test::body_in(shown, 0).body.X_WB.p_W.z(), 2 * test::kRodRadius + 3 * most) << D;
    }
  }
}

}  // namespace
}  // namespace batuta
