// SPDX-License-Identifier: MIT
// R02: three layers of rods, each across the one below, on two posts.
#include <gtest/gtest.h>

#include "resting.hpp"

namespace batuta {
namespace {

template <class SceneT>
constexpr SceneOptions stacked_options() {
  SceneOptions scene = SceneT::kStated;
  scene.max_bodies = 8;
  scene.max_pairs = 28;
  scene.max_contacts = 128;
  scene.max_events = 128;
  return scene;
}
template <class SceneT>
using Stacked =
    Scene<stacked_options<SceneT>, typename SceneT::Search, typename SceneT::Controller>;

constexpr int kLayers = 3;

/// Rods first, from below, two in a layer, alternating between along x and along y; then the posts.
template <class SceneT>
void stack(World<SceneT>& world, double D, double restitution) {
  using S = typename SceneT::Scalar;
  constexpr double kAside = 0.35;
  const Vec3<double> X = Vec3<double>::UnitX();
  const Vec3<double> Y = Vec3<double>::UnitY();
  for (int layer = 1; layer <= kLayers; ++layer) {
    for (const double side : {-kAside, kAside}) {
      const bool along_x = layer % 2 == 1;
      Vec3<double> place = side * (along_x ? Y : X);
      place.z() = layer * (2 * test::kRodRadius + D);
      auto rod = test::rod_at<SceneT>(place, along_x ? X : Y);
      rod.restitution = static_cast<S>(restitution);
      (void)world.add(rod);
    }
  }
  (void)world.add(test::post_at<SceneT>(-kAside * X, Y));
  (void)world.add(test::post_at<SceneT>(kAside * X, Y));
}

struct Seen {
  double drift = 0;  ///< of any rod sideways, m
  double least_gap = 1;
  int separations = 0;
  int incomplete = 0;
  int overlaps = 0;
  std::uint32_t asleep = 0;
  double top_speed_late = 0;  ///< of any rod in the last second, m/s
};

template <class SceneT>
Seen watch(double D, double restitution, int steps) {
  using S = typename SceneT::Scalar;
  World<SceneT> world;
  WorldSettings<SceneT> settings;
  settings.separation = static_cast<S>(D);
  EXPECT_EQ(world.configure(settings), Status::kOk);
  stack(world, D, restitution);
  const World<SceneT>& shown = world;
  std::array<Vec3<double>, 2 * kLayers> start;
  const auto place = [&](std::size_t k) {
    return Vec3<double>(
        test::body_in(shown, static_cast<int>(k)).body.X_WB.p_W.template cast<double>());
  };
  for (std::size_t k = 0; k < start.size(); ++k) start[k] = place(k);
  Seen seen;
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(world.step(static_cast<S>(test::kTick)), Status::kOk);
    const bool late = i + 1000 >= steps;
    for (std::size_t k = 0; k < start.size(); ++k) {
      const Vec3<double> moved = place(k) - start[k];
      seen.drift = std::max(seen.drift, moved.head<2>().norm());
      const auto& momentum = test::body_in(shown, static_cast<int>(k)).body.momentum.linear_W;
      if (late)
        seen.top_speed_late = std::max(seen.top_speed_late, static_cast<double>(momentum.norm()));
    }
    seen.least_gap = std::min(seen.least_gap, test::least_gap(shown));
    seen.separations = std::max(seen.separations, test::most_separations(shown));
    seen.incomplete += world.report().complete() ? 0 : 1;
    seen.overlaps += static_cast<int>(world.report().overlaps_at_start);
    seen.asleep = world.report().asleep;
  }
  return seen;
}

template <class S>
class StackAtRest : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StackAtRest, Scalars);

template <class SceneT>
Seen expect_sound(double D, double restitution) {
  const Seen seen = watch<SceneT>(D, restitution, 2000);
  EXPECT_GT(seen.least_gap, 0) << D << ' ' << restitution;
  EXPECT_LE(seen.separations, SceneT::kMaxSeparations) << D << ' ' << restitution;
  EXPECT_EQ(seen.incomplete, 0) << D << ' ' << restitution;
  EXPECT_EQ(seen.overlaps, 0) << D << ' ' << restitution;
  // What holds a rod for a step carries it: its weight does not add up to a speed.
  EXPECT_LT(seen.top_speed_late, 1) << D << ' ' << restitution;
  return seen;
}

TYPED_TEST(StackAtRest, ThatMaySleep_StaysAndFallsAsleep) {
  constexpr double kD = 1e-4;
  for (const double restitution : {0.0, 0.5}) {
    const Seen seen = expect_sound<Stacked<test::SleepyScene<TypeParam>>>(kD, restitution);
    EXPECT_EQ(seen.asleep, 2U * kLayers);
    EXPECT_LT(seen.drift, 5e-4 * test::kRodLength);  // before they sleep
  }
}

// Without sleep the layers rock on their gaps, and the rods creep: by 0.1 ... 3 mm in these 2 s.
TYPED_TEST(StackAtRest, ThatMayNotSleep_StandsThoughItCreeps) {
  for (const double D : {2e-5, 1e-4}) {
    for (const double restitution : {0.0, 0.9}) {
      const Seen seen = expect_sound<Stacked<test::RubbingScene<TypeParam>>>(D, restitution);
      EXPECT_LT(seen.drift, 1e-2) << D << ' ' << restitution;
    }
  }
}

TYPED_TEST(StackAtRest, Smooth_IsSoundWhileItSlides) {
  for (const double D : {2e-5, 1e-4}) {
    for (const double restitution : {0.0, 0.9}) {
      (void)expect_sound<Stacked<test::RestScene<TypeParam>>>(D, restitution);
    }
  }
}

}  // namespace
}  // namespace batuta
