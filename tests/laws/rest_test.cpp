// SPDX-License-Identifier: MIT
// Law 5: slopes, rolling and stacks. Formulas stand beside their tests; none is from the library's
// own output. Floors, grooves and piles: lying_test.cpp.
#include <gtest/gtest.h>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Settling;
using test::Vector;

constexpr double kG = 9.81;
const double kPi = std::acos(-1.0);

template <class S>
class Rest : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Rest, Scalars);

/// Something that may slide along y, as gravity is tilted by `angle`.
template <class SceneT>
struct Tilted {
  using S = typename SceneT::Scalar;
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;

  explicit Tilted(double angle, double separation = 1e-4) {
    auto settings = world->settings();
    settings.separation = static_cast<S>(separation);
    settings.gravity_W = Vector(0, kG * std::sin(angle), -kG * std::cos(angle)).template cast<S>();
    EXPECT_EQ(world->configure(settings), Status::kOk);
  }
  void add_rail(double radius, double x, double z, double mu, double lever = 0) {
    auto rail = test::fixed_rod<SceneT>(8, radius, {x, 2, z}, test::along_y());
    rail.friction = static_cast<S>(mu);
    if constexpr (SceneT::kRollingResistance) rail.rolling_resistance = static_cast<S>(lever);
    (void)world->add(rail);
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
  /// Until it is at rest, or slides: each step's impulses are those of the one before, put right,
  /// so that near the critical angle friction is exact after some fifty steps.
  void settle(double dt) { run(dt, max_of(0.5, 64 * dt)); }
  /// Mean acceleration over `duration`, after `start`, s.
  double acceleration(double dt, double start = 0.5, double duration = 1) {
    run(dt, start);
    const double before = speed();
    run(dt, duration);
    return (speed() - before) / (static_cast<double>(std::lround(duration / dt)) * dt);
  }
};

/// A rod across two rails.
template <class SceneT>
struct Slope : Tilted<SceneT> {
  using S = typename SceneT::Scalar;

  /// @param rolls  else it cannot turn about its own axis
  /// @param lever  of the rolling resistance, m
  Slope(double angle, double mu, bool rolls, double lever = 0, double separation = 1e-4)
      : Tilted<SceneT>(angle, separation) {
    for (const double x : {-0.35, 0.35}) this->add_rail(0.01, x, 0, mu, lever);
    auto rod = test::solid_rod<SceneT>(1, 0.01, {0, -0.8, 0.02 + 5e-5}, test::along_x());
    if (!rolls) rod.body.inverse_moments.z() = 0;
    rod.friction = static_cast<S>(mu);
    if constexpr (SceneT::kRollingResistance) rod.rolling_resistance = static_cast<S>(lever);
    this->id = this->world->add(rod).value;
  }
};

/// A rod along two rails that wedge it: the planes that touch it are `half` off the upright one, so
/// each rail presses with m g cos(angle) / (2 sin(half)), and friction is mu / sin(half) of the
/// weight. Its gaps are those of rest, D / 2.
template <class SceneT>
struct Wedge : Tilted<SceneT> {
  using S = typename SceneT::Scalar;

  Wedge(double angle, double mu, double half, double dt) : Tilted<SceneT>(angle) {
    constexpr double kRadius = 0.05;
    const double apart = 2 * kRadius + max_of(1e-4, kG * dt * dt / 4) / 2;
    for (const double side : {-1.0, 1.0}) {
      this->add_rail(kRadius, side * apart * std::cos(half), -apart * std::sin(half), mu);
    }
    auto rod = test::solid_rod<SceneT>(0.5, kRadius, {0, -0.8, 0}, test::along_y());
    rod.friction = static_cast<S>(mu);
    this->id = this->world->add(rod).value;
  }
  /// That of the half angle, where the rod is now.
  double sine() const {
    const auto place = [this](std::uint16_t slot) {
      return std::as_const(*this->world).get(this->world->id_at(slot))->body.X_WB.p_W;
    };
    const Vec3<S> way = place(2) - place(0);
    return static_cast<double>(way.z() / std::hypot(way.x(), way.z()));
  }
};

TYPED_TEST(Rest, SlopeBelowTheCriticalAngle_HoldsAndSleeps) {
  for (const double dt : {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30}) {
    for (const double mu : {0.2, 0.5}) {
      for (const double share : {0.5, 0.998}) {
        Slope<Settling<TypeParam, test::kFalling>> slope(std::atan(mu * share), mu, false);
        slope.settle(dt);
        EXPECT_LE(std::abs(slope.speed()), 1e-6) << dt << ' ' << mu << ' ' << share;
      }
      for (const double D : {1e-5, 1e-4, 1e-3}) {
        Slope<Settling<TypeParam, test::kSleeping>> slope(std::atan(0.9 * mu), mu, false, 0, D);
        slope.run(dt, 1);
        EXPECT_TRUE(slope.world->is_asleep(slope.id)) << dt << ' ' << mu << ' ' << D;
      }
    }
  }
}

// a = g (sin - mu cos); it begins to slide within 0.5 % of the tangent.
TYPED_TEST(Rest, SlopeAboveTheCriticalAngle_SlidesAsCoulombSays) {
  for (const double dt : {1e-3, 1e-2, 1.0 / 60, 1.0 / 30}) {
    for (const double mu : {0.2, 0.5}) {
      for (const double share : {1.004, 1.2}) {
        const double angle = std::atan(mu * share);
        Slope<Settling<TypeParam, test::kFalling>> slope(angle, mu, false);
        const double want = kG * (std::sin(angle) - mu * std::cos(angle));
        slope.settle(dt);
        EXPECT_NEAR(slope.acceleration(dt, 0), want, 0.01 * want)
            << dt << ' ' << mu << ' ' << share;
      }
    }
  }
}

// It begins to slide where tan = mu / sin(half), within 1 % of it, and then by
// a = g (sin - mu / sin(half) cos), with the half angle that the sway of its gaps makes of it.
TYPED_TEST(Rest, RodWedgedByTwoRails_HoldsAndSlidesByTheFrictionOfAGroove) {
  for (const double dt : {1e-3, 1e-2, 1.0 / 60, 1.0 / 30}) {
    for (const double half : {kPi / 6, kPi / 3}) {
      SCOPED_TRACE(::testing::Message() << dt << " s, half angle " << half);
      const double mu = 0.3;
      const double critical = mu / std::sin(half);
      for (const double share : {0.5, 0.99}) {
        Wedge<Settling<TypeParam, test::kFalling>> wedge(std::atan(share * critical), mu, half, dt);
        wedge.settle(dt);
        EXPECT_LE(std::abs(wedge.speed()), 1e-5) << share;
      }
      Wedge<Settling<TypeParam, test::kSleeping>> sleeper(std::atan(0.9 * critical), mu, half, dt);
      sleeper.run(dt, 1);
      EXPECT_TRUE(sleeper.world->is_asleep(sleeper.id));
      for (const double share : {1.01, 1.2}) {
        const double angle = std::atan(share * critical);
        Wedge<Settling<TypeParam, test::kFalling>> wedge(angle, mu, half, dt);
        wedge.settle(dt);
        const double before = wedge.speed();
        double want = 0;
        for (double t = 0; t < 1; t += dt) {
          want += kG * (std::sin(angle) - mu / wedge.sine() * std::cos(angle)) * dt;
          wedge.run(dt, dt);
        }
        const double friction = kG * critical * std::cos(angle);  // in a second, known to 0.2 %
        EXPECT_NEAR(wedge.speed() - before, want, 0.01 * want + 2e-3 * friction) << share;
      }
    }
  }
}

/// A ball between a floor and an upright wall, rods of 5 cm along y.
template <class SceneT>
struct Corner {
  using S = typename SceneT::Scalar;
  static constexpr double kRadius = 0.1;
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;

  /// @param lean  of gravity, from the floor's side to the wall's
  /// @param spin  about the y axis, rad/s
  Corner(double lean, double mu, double spin) {
    auto settings = world->settings();
    settings.gravity_W = (kG * Vector(-std::sin(lean), 0, -std::cos(lean))).template cast<S>();
    EXPECT_EQ(world->configure(settings), Status::kOk);
    const double apart = kRadius + 0.05 + 5e-5;
    for (const Vector& place : {Vector(0, 0, -apart), Vector(-apart, 0, 0)}) {
      auto rod = test::fixed_rod<SceneT>(1, 0.05, place, test::along_y());
      rod.friction = static_cast<S>(mu);
      (void)world->add(rod);
    }
    auto ball = test::solid_ball<SceneT>(kRadius, {0, 0, 0});
    ball.friction = static_cast<S>(mu);
    test::throw_body(ball, Vector::Zero(), {0, spin, 0});
    id = world->add(ball).value;
  }
  /// The length that rules rest, m.
  static double D(double dt) { return max_of(1e-4, kG * dt * dt / 4); }
  const Body<S>& ball() const { return std::as_const(*world).get(id)->body; }
  double spin() const { return static_cast<double>(twist_of(ball()).w_W.y()); }
  void step(double dt) {
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    ASSERT_TRUE(world->report().complete());
  }
};

// Without friction floor and wall press with m g cos(lean) and m g sin(lean). With it more than one
// answer is right, and it stays where it is as well: it sleeps.
template <class SceneT>
void lean_on_wall(double lean, double mu, double dt) {
  Corner<SceneT> corner(lean, mu, 0);
  const double weight = kG * dt / static_cast<double>(corner.ball().inverse_mass);
  corner.step(dt);
  ASSERT_EQ(corner.world->events().size(), 2);
  for (const auto& event : corner.world->events()) {
    const double upright = std::abs(static_cast<double>(event.contact.normal_BA_W.z()));
    const double want = weight * (upright > 0.5 ? std::cos(lean) : std::sin(lean));
    EXPECT_NEAR(static_cast<double>(event.impulse), want, mu > 0 ? weight : 1e-3 * want);
  }
  for (double t = 0; t < 1; t += dt) corner.step(dt);
  EXPECT_LE(static_cast<double>(corner.ball().X_WB.p_W.norm()), corner.D(dt));
  EXPECT_TRUE(corner.world->is_asleep(corner.id));
}

TYPED_TEST(Rest, BallThatLeansOnAWall_StaysAndSleeps) {
  for (const double dt : {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30}) {
    for (const double mu : {0.0, 0.5}) {
      for (const double lean : {0.1, kPi / 4, 1.4}) {
        SCOPED_TRACE(::testing::Message() << dt << " s, " << mu << ", lean " << lean);
        lean_on_wall<Settling<TypeParam, test::kSleeping>>(lean, mu, dt);
      }
    }
  }
}

// It spins into the corner: the floor's friction mu N presses it on the wall, and the wall's mu^2 N
// lifts it, so N (1 + mu^2) = m g, and both brake it: with I = 2/5 m r^2 by
// 5/2 mu (1 + mu) / (1 + mu^2) g / r.
TYPED_TEST(Rest, BallThatSpinsInACorner_IsBrakedByBothAndStops) {
  using SceneT = Settling<TypeParam, test::kFalling>;
  constexpr double kSpin = -60;
  for (const double dt : {1e-4, 1e-3, 1e-2, 1.0 / 60}) {
    for (const double mu : {0.1, 0.3}) {
      SCOPED_TRACE(::testing::Message() << dt << " s, " << mu);
      Corner<SceneT> corner(0, mu, kSpin);
      const double brake = 2.5 * mu * (1 + mu) / (1 + mu * mu) * kG / corner.kRadius;
      const int count = static_cast<int>(std::lround(0.5 / dt));
      for (int i = 0; i < count; ++i) corner.step(dt);
      EXPECT_NEAR(corner.spin(), kSpin + brake * count * dt, 0.01 * brake * count * dt);
      EXPECT_LE(static_cast<double>(corner.ball().X_WB.p_W.norm()), corner.D(dt));
      const int rest = static_cast<int>(std::lround(-1.1 * kSpin / brake / dt));
      for (int i = count; i < rest; ++i) corner.step(dt);
      EXPECT_LE(std::abs(corner.spin()), brake * dt) << "what a step takes";
    }
  }
}

// a = g sin / (1 + I / (m r^2)): 3/2 for a long rod, and its hemispheres make that a little less.
// At 1/30 s the gap of rest is more than a tenth of this rod's radius; the lever is its radius.
TYPED_TEST(Rest, RodThatRolls_IsAsSlowAsItsInertiaMakesIt) {
  const double angle = 0.2;
  const double radius = 0.01;
  for (const double dt : {1e-4, 1e-3, 1.0 / 60, 1.0 / 30}) {
    Slope<Settling<TypeParam, test::kFalling>> slope(angle, 0.5, true);
    const auto& body = slope.rod();
    const double share =
        static_cast<double>(body.inverse_mass / body.inverse_moments.z()) / (radius * radius);
    EXPECT_NEAR(share, 0.5, 0.01);
    const double got = slope.acceleration(dt, 0.2, 0.4);  // below half a turn a step
    const double want = kG * std::sin(angle) / (1 + share);
    EXPECT_NEAR(got, want, 0.005 * want) << dt;
    // world.md: it is kept within 0.6 D, which is what the fall of a long step asks for.
    const double gap = static_cast<double>(body.X_WB.p_W.z()) - 2 * radius;
    EXPECT_TRUE(dt < 0.01 || gap <= 0.61 * kG * dt * dt / 4) << dt << ' ' << gap;
  }
}

// A ball down one rail: I = 2/5 m r^2, so a = 5/7 g sin, and it turns by v / r.
TYPED_TEST(Rest, BallThatRolls_HasFiveSeventhsOfTheFall) {
  using SceneT = Settling<TypeParam, test::kFalling>;
  const double angle = 0.2;
  const double radius = 0.2;
  for (const double dt : {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30}) {
    World<SceneT> world;
    auto settings = world.settings();
    settings.gravity_W =
        Vector(0, kG * std::sin(angle), -kG * std::cos(angle)).template cast<TypeParam>();
    ASSERT_EQ(world.configure(settings), Status::kOk);
    auto rail = test::fixed_rod<SceneT>(8, 0.05, {0, 2, -0.05}, test::along_y());
    auto ball = test::solid_ball<SceneT>(radius, {0, -0.8, radius + 5e-5});
    rail.friction = ball.friction = TypeParam(0.5);
    ASSERT_TRUE(world.add(rail).ok());
    const auto id = world.add(ball).value;
    const int count = static_cast<int>(std::lround(0.6 / dt));
    for (int i = 0; i < count; ++i) {
      ASSERT_EQ(world.step(static_cast<TypeParam>(dt)), Status::kOk);
      ASSERT_TRUE(world.report().complete()) << dt << ' ' << i;
    }
    const auto twist = twist_of(std::as_const(world).get(id)->body);
    const double v = static_cast<double>(twist.v_W.y());
    const double want = 5.0 / 7 * kG * std::sin(angle) * count * dt;
    EXPECT_NEAR(v, want, 0.01 * want) << dt;
    const double rim = -static_cast<double>(twist.w_W.x()) * radius;
    EXPECT_NEAR(rim, v, 0.01 * v) << dt;
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
      const double arm = 0.01;
      const auto& body = slope.rod();
      const double inertia = static_cast<double>(body.inverse_mass / body.inverse_moments.z());
      const double want =
          kG * (std::sin(angle) - lever / arm * std::cos(angle)) / (1 + inertia / (arm * arm));
      EXPECT_NEAR(slope.acceleration(dt), want, 0.01 * want) << lever << ' ' << dt;
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
