// SPDX-License-Identifier: MIT
// R02: three layers of rods, each across the one below, on two posts.
#include <gtest/gtest.h>

#include "resting.hpp"

namespace batuta {
namespace {

template <class SceneT>
struct Stacked : SceneT {
  static constexpr int kMaxBodies = 8;
  static constexpr int kMaxPairs = 28;
  static constexpr int kMaxContacts = 128;
  static constexpr int kMaxEvents = 128;
};

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
  double sink = 0;   ///< of any rod below where it would touch the posts through the others, m
  double least_gap = 1;
  int separations = 0;
  int most_contacts = 0;  ///< events of a step
  std::uint32_t frozen = 0;
  int frozen_late = 0;  ///< steps of the last second with a frozen pair
  int incomplete = 0;
  int overlaps = 0;
  std::uint32_t asleep = 0;
  double deepest = 0;
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
      const auto& momentum = test::body_in(shown, static_cast<int>(k)).body.momentum.p_W;
      if (late)
        seen.top_speed_late = std::max(seen.top_speed_late, static_cast<double>(momentum.norm()));
    }
    seen.least_gap = std::min(seen.least_gap, test::least_gap(shown));
    seen.separations = std::max(seen.separations, test::most_separations(shown));
    seen.most_contacts = std::max(seen.most_contacts, static_cast<int>(world.events().size()));
    seen.frozen += world.report().frozen;
    seen.frozen_late += late && world.report().frozen > 0 ? 1 : 0;
    seen.incomplete += world.report().complete() ? 0 : 1;
    seen.overlaps += static_cast<int>(world.report().overlaps_at_start);
    seen.asleep = world.report().asleep;
    seen.deepest = std::max(seen.deepest, static_cast<double>(world.report().deepest_overlap));
  }
  std::printf(
      "  drift %.2g m, gap %.2g m, %d separations, events %d, frozen %u (%d late), incomplete %d, "
      "overlaps %d (%.2g), asleep %u, speed %.2g\n",
      seen.drift, seen.least_gap, seen.separations, seen.most_contacts, seen.frozen,
      seen.frozen_late, seen.incomplete, seen.overlaps, seen.deepest, seen.asleep, seen.top_speed_late);
  return seen;
}

template <class S>
class StackAtRest : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StackAtRest, Scalars);

TYPED_TEST(StackAtRest, Exp) {
  for (double D : {2e-5, 1e-4}) {
    for (double e : {0.0, 0.9}) {
      std::printf("D %g e %g\n", D, e);
      watch<Stacked<test::RubbingScene<TypeParam>>>(D, e, 2000);
      watch<Stacked<test::SleepyScene<TypeParam>>>(D, e, 2000);
      watch<Stacked<test::RestScene<TypeParam>>>(D, e, 2000);
    }
  }
}

}  // namespace
}  // namespace batuta
