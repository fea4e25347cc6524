// SPDX-License-Identifier: MIT
// Law 5: slopes, rolling, floors, grooves and stacks. Formulas stand beside their tests; none is
// from the library's own output.
#include <gtest/gtest.h>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Settling;
using test::Vector;

constexpr double kG = 9.81;

template <class S>
class Rest : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Rest, Scalars);

/// A rod across two rails that gravity is tilted along, by `angle`.
template <class SceneT>
struct Slope {
  using S = typename SceneT::Scalar;
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;

  /// @param rolls  else it cannot turn about its own axis
  /// @param lever  of the rolling resistance, m
  Slope(double angle, double mu, bool rolls, double lever = 0) {
    auto settings = world->settings();
    settings.gravity_W = Vector(0, kG * std::sin(angle), -kG * std::cos(angle)).template cast<S>();
    EXPECT_EQ(world->configure(settings), Status::kOk);
    for (const double x : {-0.35, 0.35}) {
      auto rail = test::fixed_rod<SceneT>(8, 0.01, {x, 2, 0}, test::along_y());
      rail.friction = static_cast<S>(mu);
      if constexpr (SceneT::kRollingResistance) rail.rolling_resistance = static_cast<S>(lever);
      (void)world->add(rail);
    }
    auto rod = test::solid_rod<SceneT>(1, 0.01, {0, -0.8, 0.02 + 5e-5}, test::along_x());
    if (!rolls) rod.body.inverse_moments.z() = 0;
    rod.friction = static_cast<S>(mu);
    if constexpr (SceneT::kRollingResistance) rod.rolling_resistance = static_cast<S>(lever);
    id = world->add(rod).value;
  }
  const Body<S>& rod() const { return std::as_const(*world).get(id)->body; }
  double speed() const {
    return static_cast<double>(rod().inverse_mass * rod().momentum.linear_W.y());
  }
  void run(double dt, double duration) {
    const int count = static_cast<int>(std::lround(duration / dt));
    for (int i = 0; i < count; ++i) {
      ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
      ASSERT_TRUE(world->report().complete()) << i;
    }
  }
  /// Mean acceleration over a second, after half of one.
  double acceleration(double dt) {
    run(dt, 0.5);
    const double before = speed();
    run(dt, 1);
    return speed() - before;
  }
};

TYPED_TEST(Rest, SlopeBelowTheCriticalAngle_HoldsAndSleeps) {
  for (const double dt : {1e-4, 1e-3, 1.0 / 60, 1.0 / 30}) {
    for (const double share : {0.5, 0.998}) {
      Slope<Settling<TypeParam, test::kFalling>> slope(std::atan(0.5 * share), 0.5, false);
      slope.run(dt, 0.5);
      EXPECT_LE(std::abs(slope.speed()), 1e-6) << dt << ' ' << share;
    }
    Slope<Settling<TypeParam, test::kSleeping>> slope(std::atan(0.45), 0.5, false);
    slope.run(dt, 1);
    EXPECT_TRUE(slope.world->is_asleep(slope.id)) << dt;
  }
}

// a = g (sin - mu cos); it begins to slide within 0.5 % of the tangent.
TYPED_TEST(Rest, SlopeAboveTheCriticalAngle_SlidesAsCoulombSays) {
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double tangent : {0.505, 0.6}) {
      const double angle = std::atan(tangent);
      Slope<Settling<TypeParam, test::kFalling>> slope(angle, 0.5, false);
      const double want = kG * (std::sin(angle) - 0.5 * std::cos(angle));
      EXPECT_NEAR(slope.acceleration(dt), want, 0.01 * want) << dt << ' ' << tangent;
    }
  }
}

// a = g sin / (1 + I / (m r^2)): 3/2 for a long rod, and its hemispheres make that a little less.
TYPED_TEST(Rest, RodThatRolls_IsAsSlowAsItsInertiaMakesIt) {
  const double angle = 0.2;
  for (const double dt : {1e-3, 1.0 / 60}) {
    Slope<Settling<TypeParam, test::kFalling>> slope(angle, 0.5, true);
    const auto& body = slope.rod();
    const double radius = 0.01;
    const double inertia =
        static_cast<double>(body.inverse_mass / body.inverse_moments.z()) / (radius * radius);
    EXPECT_NEAR(inertia, 0.5, 0.01);
    const double want = kG * std::sin(angle) / (1 + inertia);
    EXPECT_NEAR(slope.acceleration(dt), want, 0.012 * want) << dt;
  }
}

// A rod on rails rolls where the slope is steeper than lever / radius: a = g (sin - lever / r cos)
// / (1 + I / (m r^2)). Below that it stands.
TYPED_TEST(Rest, RollingResistance_HoldsUpToItsCriticalAngle) {
  using SceneT = Settling<TypeParam, test::kRollingAwake>;
  for (const double lever : {3e-4, 1e-3}) {
    const double critical = lever / 0.01;
    for (const double dt : {1e-4, 1e-3, 1.0 / 60}) {
      for (const double share : {0.2, 0.9}) {
        Slope<SceneT> slope(std::atan(share * critical), 0.5, true, lever);
        slope.run(dt, 1);
        EXPECT_LE(std::abs(slope.speed()), 1e-6) << lever << ' ' << dt << ' ' << share;
      }
    }
    for (const double dt : {1e-3, 1.0 / 60}) {
      const double angle = std::atan(3 * critical);
      Slope<SceneT> slope(angle, 0.6, true, lever);
      const double want = kG * (std::sin(angle) - critical * std::cos(angle)) / 1.5;
      EXPECT_NEAR(slope.acceleration(dt), want, 0.015 * want) << lever << ' ' << dt;
    }
  }
}

/// What a rod that is dropped came to.
struct Lying {
  double asleep = -1;
  long begins = 0;
  long incomplete = 0;
  double gain = 0;  ///< the most that a step added to the energy, J
};
template <class SceneT>
Lying lie(World<SceneT>& world, typename World<SceneT>::BodyId id, double dt, double duration) {
  Lying lying;
  const int count = static_cast<int>(std::lround(duration / dt));
  for (int i = 0; i < count && lying.asleep < 0; ++i) {
    EXPECT_EQ(world.step(static_cast<typename SceneT::Scalar>(dt)), Status::kOk);
    for (const auto& event : world.events()) {
      lying.begins += event.kind == EventKind::kBegin ? 1 : 0;
    }
    lying.incomplete += world.report().complete() ? 0 : 1;
    if (world.is_asleep(id)) lying.asleep = dt * i;
  }
  return lying;
}

/// A rod of 0.3 m, dropped from 0.3 m, tilted by 0.3.
template <class SceneT>
Actor<SceneT> dropped_rod(double yaw, double tilt, double height, double restitution) {
  using S = typename SceneT::Scalar;
  auto rod = test::solid_rod<SceneT>(
      0.3, 0.03, {0.01, 0, height},
      test::about(Vector::UnitZ(), yaw) * test::about(Vector::UnitY(), tilt) * test::along_x(),
      700);
  rod.restitution = static_cast<S>(restitution);
  rod.friction = S(0.5);
  if constexpr (SceneT::kRollingResistance) rod.rolling_resistance = S(3e-4);
  return rod;
}

TYPED_TEST(Rest, RodAlongARoundFloor_SleepsAfterAFewTouches) {
  using SceneT = Settling<TypeParam, test::kRolling>;
  for (const double R : {0.05, 2.0, 100.0, 1000.0}) {
    for (const double dt : {1e-3, 1.0 / 60, 1.0 / 30}) {
      auto world = std::make_unique<World<SceneT>>();
      auto floor = test::fixed_rod<SceneT>(10, R, {0, 0, -R}, test::along_x());
      floor.friction = TypeParam(0.5);
      floor.restitution = TypeParam(0.3);
      (void)world->add(floor);
      auto rod = dropped_rod<SceneT>(0, 0.3, 0.3, 0.3);
      rod.body.X_WB.p_W.x() = 0;
      const auto id = world->add(rod).value;
      const Lying lying = lie(*world, id, dt, 3);
      EXPECT_GE(lying.asleep, 0) << R << ' ' << dt;
      EXPECT_LE(lying.asleep, 1.5) << R << ' ' << dt;
      EXPECT_LE(lying.begins, 12) << R << ' ' << dt;
      EXPECT_EQ(lying.incomplete, 0) << R << ' ' << dt;
    }
  }
}

TYPED_TEST(Rest, RodInAGroove_SleepsAfterAFewTouches) {
  using SceneT = Settling<TypeParam, test::kRolling>;
  for (const double yaw : {0.2, 0.7, 1.57}) {
    for (const double dt : {1e-3, 4e-3, 1.0 / 60}) {
      auto world = std::make_unique<World<SceneT>>();
      for (int i = -8; i < 8; ++i) {
        auto log = test::fixed_rod<SceneT>(3, 0.06, {0.1 * (i + 0.5), 0, -0.06}, test::along_y());
        log.friction = TypeParam(0.5);
        log.restitution = TypeParam(0.2);
        (void)world->add(log);
      }
      const auto id = world->add(dropped_rod<SceneT>(yaw, 0.05, 0.15, 0.2)).value;
      const Lying lying = lie(*world, id, dt, 3);
      EXPECT_GE(lying.asleep, 0) << yaw << ' ' << dt;
      EXPECT_LE(lying.begins, 12) << yaw << ' ' << dt;
      EXPECT_EQ(lying.incomplete, 0) << yaw << ' ' << dt;
    }
  }
}

/// Ten layers of two rods, each across the one below. @returns how the top has moved, m
template <class SceneT>
Vector stand(double dt, double duration, double& deepest, long& incomplete) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  for (const double x : {-0.2, 0.2}) {
    auto rail = test::fixed_rod<SceneT>(1, 0.03, {x, 0, -0.03}, test::along_y());
    rail.friction = S(0.5);
    (void)world->add(rail);
  }
  typename World<SceneT>::BodyId top;
  for (int layer = 0; layer < 10; ++layer) {
    for (const double side : {-0.2, 0.2}) {
      const double z = 0.03 + 0.06 * layer + 5e-5 * (layer + 1);
      const bool is_even = layer % 2 == 0;
      auto rod =
          test::solid_rod<SceneT>(0.6, 0.03, is_even ? Vector(0, side, z) : Vector(side, 0, z),
                                  is_even ? test::along_x() : test::along_y(), 700);
      rod.friction = S(0.5);
      if constexpr (SceneT::kRollingResistance) rod.rolling_resistance = S(3e-4);
      top = world->add(rod).value;
    }
  }
  const auto place = [&] {
    return Vector(std::as_const(*world).get(top)->body.X_WB.p_W.template cast<double>());
  };
  const Vector start = place();
  const int count = static_cast<int>(std::lround(duration / dt));
  for (int i = 0; i < count; ++i) {
    EXPECT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    incomplete += world->report().complete() ? 0 : 1;
    if (i % 16 == 0) deepest = std::min(deepest, test::smallest_gap(*world));
  }
  return place() - start;
}

TYPED_TEST(Rest, TenCrossedLayers_Stand) {
  for (const double dt : {1e-3, 1.0 / 60}) {
    double deepest = 1;
    long incomplete = 0;
    const Vector moved = stand<Settling<TypeParam, test::kRolling>>(dt, 60, deepest, incomplete);
    // Ten gaps of 5e-5 m open to 0.6 D at most, D = max(1e-4 m, g dt^2 / 4): so much it may rise.
    const double rise = 10 * (0.6 * max_of(1e-4, kG * dt * dt / 4) - 5e-5);
    // With long steps gaps that open take it aside, by no more than they rise.
    EXPECT_LT(std::hypot(moved.x(), moved.y()), dt < 2e-3 ? 1e-3 : rise) << dt;
    EXPECT_LT(moved.z(), min_of(rise, dt < 2e-3 ? 1e-3 : rise)) << dt;
    EXPECT_GT(moved.z(), -1e-3) << dt;
    // What the search cannot tell from contact, twice, between rods whose lengths and distance come
    // to 2 m at most (src/world/detail/margin.md).
    const double margin = 2 * (1e-6 + 72 * static_cast<double>(kRoundOff<TypeParam>)) * 2;
    EXPECT_GT(deepest, dt < 2e-3 ? 0 : -margin) << dt;
    EXPECT_EQ(incomplete, 0) << dt;
  }
}

}  // namespace
}  // namespace batuta
