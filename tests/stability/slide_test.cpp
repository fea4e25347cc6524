// SPDX-License-Identifier: MIT
// R03: a rod slides along two blades. R04: it comes to their ends, and falls.
#include <gtest/gtest.h>

#include "resting.hpp"

namespace batuta {
namespace {

constexpr double kG = 9.81;
constexpr double kBladeHalf = 2;
constexpr double kD = 1e-4;

/// A rod along x on two blades along y, sliding along them.
template <class SceneT>
struct Slide {
  using S = typename SceneT::Scalar;
  World<SceneT> world;

  Slide(double y, double speed) {
    auto rod = test::rod_at<SceneT>({0, y, 2 * test::kRodRadius + kD}, Vec3<double>::UnitX());
    rod.body.momentum.linear_W.y() = static_cast<S>(speed);
    (void)world.add(rod);
    for (const double side : {-0.35, 0.35}) {
      auto blade = test::post_at<SceneT>({side, 0, 0}, Vec3<double>::UnitY());
      blade.capsule_B.axis = {test::vector<S>(0, -kBladeHalf, 0),
                              test::vector<S>(0, kBladeHalf, 0)};
      (void)world.add(blade);
    }
  }
  const Body<S>& rod() const { return test::body_in(world, 0).body; }
  double y() const { return static_cast<double>(rod().X_WB.p_W.y()); }
  double speed() const { return static_cast<double>(rod().momentum.linear_W.y()); }
  double energy() const {
    return static_cast<double>(kinetic_energy(rod())) +
           kG * static_cast<double>(rod().X_WB.p_W.z());
  }
  void step() {
    ASSERT_EQ(world.step(static_cast<S>(test::kTick)), Status::kOk);
    ASSERT_TRUE(world.report().complete());
    ASSERT_GT(test::least_gap<SceneT>(world), 0);
  }
};

template <class S>
class Sliding : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Sliding, Scalars);

TYPED_TEST(Sliding, Smooth_KeepsItsSpeedAndIsNeverHeld) {
  Slide<test::RestScene<TypeParam>> slide(-1.75, 10);
  for (int i = 0; i < 350; ++i) {
    slide.step();
    EXPECT_EQ(slide.world.report().time_held, 0);
    // It lies on the blades all the way, within D.
    EXPECT_NEAR(slide.rod().X_WB.p_W.z(), 2 * test::kRodRadius + kD / 2, kD / 2);
  }
  const double precision = static_cast<double>(kRoundOff<TypeParam>) * 350 * 4;
  EXPECT_NEAR(slide.speed(), 10, 10 * precision);
  EXPECT_NEAR(slide.y(), 1.75, 10 * precision);
}

// What it loses is mu g t: it slides, and rubs with all of its weight.
TYPED_TEST(Sliding, Rough_LosesMuGTimesTime) {
  Slide<test::RubbingScene<TypeParam>> slide(-1.75, 10);
  constexpr int kSteps = 300;
  for (int i = 0; i < kSteps; ++i) {
    slide.step();
    EXPECT_EQ(slide.world.report().time_held, 0);
  }
  const double mu = 0.5;  // of rod_at()
  const double lost = mu * kG * kSteps * test::kTick;
  // What weighs in the last steps may not have been answered yet.
  EXPECT_NEAR(10 - slide.speed(), lost, mu * kG * 10 * test::kTick);
}

TYPED_TEST(Sliding, OffTheEnd_FallsAndTheContactsEnd) {
  Slide<test::RestScene<TypeParam>> slide(kBladeHalf - 0.1, 1);
  const double energy = slide.energy();
  int ends = 0;
  for (int i = 0; i < 400; ++i) {
    slide.step();
    EXPECT_EQ(slide.world.report().time_held, 0);
    // D is restored again and again, never more.
    EXPECT_LT(slide.energy(), energy + kG * 2 * kD);
    for (const auto& event : slide.world.events()) ends += event.kind == EventKind::kEnd ? 1 : 0;
    // It does not fall before it has left the blades.
    if (slide.y() < kBladeHalf) {
      EXPECT_GT(slide.rod().X_WB.p_W.z(), 2 * test::kRodRadius);
    }
  }
  EXPECT_GE(ends, 2);
  EXPECT_EQ(slide.world.report().pairs, 0U);  // nothing near any more
  EXPECT_LT(static_cast<double>(slide.rod().X_WB.p_W.z()), -0.2);
  const auto before = slide.rod().momentum.linear_W;
  slide.step();
  EXPECT_NEAR(slide.rod().momentum.linear_W.z() - before.z(), -kG * test::kTick, 1e-6);
}

}  // namespace
}  // namespace batuta
