// SPDX-License-Identifier: MIT
// The paper's f(D) on what is fixed or led: for that time a body stands still, and then goes on as
// before. So in the time that was its own it slides, tips and turns as mechanics has it.
#include <gtest/gtest.h>

#include "batuta/world/any_controller.hpp"
#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Vector;

constexpr double kG = 9.81;
constexpr double kD = 1e-4;
constexpr double kSteps[] = {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30};

constexpr SceneOptions held_options() {
  SceneOptions scene;
  scene.max_bodies = 8;
  scene.max_pairs = 16;
  scene.max_contacts = 64;
  scene.max_events = 512;
  scene.gravity = true;
  return scene;
}
template <class S>
using HeldScene = Scene<held_options, Advancement<S>, AnyController<S, FreeFlight<S>, Hand<S>>>;

template <class S>
class Held : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Held, Scalars);

/// What a body did, and how much of the time it was held.
template <class SceneT>
struct Rig {
  using S = typename SceneT::Scalar;
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;
  double dt;
  double time = 0;
  double held = 0;
  int separations = 0;
  bool is_complete = true;  ///< every step is complete

  explicit Rig(double step_s) : dt(step_s) {
    auto settings = world->settings();
    settings.gravity_W = Vec3<S>(0, 0, static_cast<S>(-kG));
    settings.separation = static_cast<S>(kD);
    EXPECT_EQ(world->configure(settings), Status::kOk);
  }
  const Body<S>& body() const { return std::as_const(*world).get(id)->body; }
  Vector velocity() const { return twist_of(body()).v_W.template cast<double>(); }
  Vector spin() const { return twist_of(body()).w_W.template cast<double>(); }
  Vector place() const { return body().X_WB.p_W.template cast<double>(); }
  /// @returns whether a body was held but once
  bool step() {
    EXPECT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    const auto& report = std::as_const(*world).report();
    EXPECT_TRUE(report.complete() || !is_complete) << time;
    time += dt;
    held += static_cast<double>(report.time_held);
    separations += report.separations;
    return report.separations <= 1;
  }
};

/// How far two are moved apart, and so how long at most a body falls freely from one f(D) to the
/// next, where the point that it rests on falls as it does (src/world/world.md, "One length").
double gap_of(double dt) {
  return 1.05 * std::max(kD, kG * dt * dt / 4);
}
double fall_of(double dt) {
  return std::sqrt(2 * gap_of(dt) / kG) + dt;
}

TYPED_TEST(Held, BallOnAFloorWithoutFriction_KeepsItsSpeedAndItsSpin) {
  using SceneT = HeldScene<TypeParam>;
  constexpr double kSpeed = 0.5;
  const double rounding = std::is_same_v<TypeParam, float> ? 1e-4 : 1e-11;
  for (const double dt : kSteps) {
    Rig<SceneT> rig(dt);
    (void)rig.world->add(test::fixed_rod<SceneT>(4, 0.05, {0, 0, 0}, test::along_x()));
    auto ball = test::solid_ball<SceneT>(0.05, {0, 0, 0.1});
    test::throw_body(ball, {kSpeed, 0, 0}, {1, 2, 3});
    rig.id = rig.world->add(ball).value;
    bool is_told = true;
    while (rig.time < 1) is_told = rig.step() && is_told;
    EXPECT_GT(rig.separations, 3) << dt;  // it rested
    EXPECT_NEAR(rig.velocity().x(), kSpeed, rounding) << dt;
    EXPECT_LE((rig.spin() - Vector(1, 2, 3)).norm(), rounding) << dt;
    EXPECT_GE(rig.place().z(), 0.1 - 1e-5) << dt;
    EXPECT_LE(rig.place().z(), 0.1 + gap_of(dt)) << dt;
    const double own = kSpeed * (rig.time - rig.held);
    EXPECT_GE(rig.place().x(), 0.3) << dt;
    EXPECT_LE(rig.place().x(), own + rounding) << dt;
    if (is_told) {
      EXPECT_GE(rig.place().x(), own - rounding) << dt;
    }
  }
}

/// A rod of length L, d off the middle on a fixed ball: at first it tips with g d / (I / m + d^2).
TYPED_TEST(Held, RodOffItsMiddle_Tips) {
  using SceneT = HeldScene<TypeParam>;
  constexpr double kOff = 0.2;
  for (const double dt : kSteps) {
    Rig<SceneT> rig(dt);
    (void)rig.world->add(test::fixed_rod<SceneT>(0, 0.05, {0, 0, 0}));
    const auto rod = test::solid_rod<SceneT>(1, 0.02, {kOff, 0, 0.07}, test::along_x());
    rig.id = rig.world->add(rod).value;
    const auto of_mass = static_cast<double>(rod.body.inverse_mass / rod.body.inverse_moments.x());
    const double tips = kG * kOff / (of_mass + kOff * kOff);
    // Until it has turned by 2 degrees.
    for (bool is_told = true; rig.time < 0.07;) {
      is_told = rig.step() && is_told;
      const double own = rig.time - rig.held;
      EXPECT_LE(rig.spin().norm(), 1.01 * tips * own + 1e-6) << dt << " at " << rig.time;
      if (!is_told) continue;
      EXPECT_GE(rig.spin().norm(), 0.99 * tips * (own - fall_of(dt))) << dt << " at " << rig.time;
    }
    EXPECT_GT(rig.spin().norm(), tips * 0.02) << dt;
  }
}

/// Its middle on a fixed ball it turns about the vertical for ever.
TYPED_TEST(Held, SwordThatSwingsOnABall_GoesOn) {
  using SceneT = HeldScene<TypeParam>;
  constexpr double kTurn = 20;
  for (const double dt : kSteps) {
    Rig<SceneT> rig(dt);
    (void)rig.world->add(test::fixed_rod<SceneT>(0, 0.05, {0, 0, 0}));
    auto sword = test::solid_rod<SceneT>(1, 0.02, {0, 0, 0.07}, test::along_x());
    test::throw_body(sword, {0, 0, 0}, {0, 0, kTurn});
    rig.id = rig.world->add(sword).value;
    while (rig.time < 0.5) (void)rig.step();
    EXPECT_GT(rig.separations, 3) << dt;
    EXPECT_NEAR(rig.spin().z(), kTurn, 0.02 * kTurn) << dt;
  }
}

/// Down a slope: g sin of its own time.
TYPED_TEST(Held, BallOnASlope_SlidesInItsOwnTime) {
  using SceneT = HeldScene<TypeParam>;
  constexpr double kSlope = 0.5;
  for (const double dt : kSteps) {
    Rig<SceneT> rig(dt);
    const Vector down(std::cos(kSlope), 0, -std::sin(kSlope));
    const Vector up(std::sin(kSlope), 0, std::cos(kSlope));
    const auto along = test::about(Vector::UnitY(), std::acos(-1.0) / 2 + kSlope);
    (void)rig.world->add(test::fixed_rod<SceneT>(10, 0.05, {0, 0, 0}, along));
    rig.id = rig.world->add(test::solid_ball<SceneT>(0.05, 0.1 * up)).value;
    bool is_told = true;
    while (rig.time < 0.5) is_told = rig.step() && is_told;
    const double own = kG * std::sin(kSlope) * (rig.time - rig.held);
    const double speed = rig.velocity().dot(down);
    EXPECT_GT(rig.separations, 3) << dt;
    EXPECT_GT(speed, kG * std::sin(kSlope) * 0.3) << dt;
    EXPECT_LE(speed, own * 1.0001) << dt;
    if (is_told) {
      EXPECT_GE(speed, own * 0.9999) << dt;
    }
  }
}

/// On a lift that is a belt as well it goes up with it, and along with it only while it is held.
TYPED_TEST(Held, BallOnWhatIsLed_RisesAndSlides) {
  using SceneT = HeldScene<TypeParam>;
  const double rounding = std::is_same_v<TypeParam, float> ? 1e-4 : 1e-11;
  for (const double dt : kSteps) {
    Rig<SceneT> rig(dt);
    auto floor = test::fixed_rod<SceneT>(4, 0.05, {0, 0, 0}, test::along_x());
    floor.owner = 1;
    floor.controller = Hand<TypeParam>{};
    const auto lift = rig.world->add(floor).value;
    rig.id = rig.world->add(test::solid_ball<SceneT>(0.05, {0, 0, 0.1})).value;
    const Vector speed(0.3, 0, 0.2);
    bool is_told = true;
    while (rig.time < 0.5) {
      auto* actor = rig.world->get(lift);
      auto* hand = actor->controller.template as<Hand<TypeParam>>();
      hand->step = static_cast<TypeParam>(dt);
      hand->target_W = actor->body.X_WB;
      hand->target_W.p_W = ((rig.time + dt) * speed).template cast<TypeParam>();
      is_told = rig.step() && is_told;
    }
    EXPECT_NEAR(rig.velocity().x(), 0, rounding) << dt;
    EXPECT_NEAR(rig.velocity().z(), speed.z(), kG * fall_of(dt)) << dt;
    EXPECT_GE(rig.place().z(), 0.1 + speed.z() * rig.time - 1e-5) << dt;
    EXPECT_LE(rig.place().z(), 0.1 + speed.z() * rig.time + 4 * gap_of(dt)) << dt;
    if (is_told) {
      EXPECT_NEAR(rig.place().x(), speed.x() * rig.held, 1e-4) << dt;
    }
  }
}

/// Between two rails that lean steeply there is no room to move it away from either: it is not
/// held, and slides on. Where the answers of a step do not suffice, that is told, and its time
/// stands still for the rest of that step alone.
TYPED_TEST(Held, BallInASteepGroove_SlidesOn) {
  using SceneT = HeldScene<TypeParam>;
  const double rounding = std::is_same_v<TypeParam, float> ? 2e-4 : 1e-10;
  for (const double leans : {50.0, 60.0, 70.0}) {
    for (const double dt : {1e-4, 1e-3}) {
      Rig<SceneT> rig(dt);
      rig.is_complete = leans < 65;
      const double angle = leans * std::acos(-1.0) / 180;
      for (const double side : {-0.1, 0.1}) {
        const Vector place(0, side * std::sin(angle), -0.1 * std::cos(angle));
        (void)rig.world->add(test::fixed_rod<SceneT>(0.5, 0.05, place, test::along_x()));
      }
      auto ball = test::solid_ball<SceneT>(0.05, {-0.125, 0, 1e-3});
      test::throw_body(ball, {1, 0, 0});
      rig.id = rig.world->add(ball).value;
      while (rig.time < 0.25) (void)rig.step();
      EXPECT_NEAR(rig.velocity().x(), 1, rounding) << leans << ' ' << dt;
      const double own = rig.time - rig.held;
      EXPECT_NEAR(rig.place().x(), own - 0.125, rounding) << leans << ' ' << dt;
      EXPECT_GE(own, 0.2) << leans << ' ' << dt;
    }
  }
}

/// What a hold took is told, also where a blow ended it: by what gravity along the floor has given.
TYPED_TEST(Held, StruckMeanwhile_TellsTheTimeThatItWasHeld) {
  using SceneT = HeldScene<TypeParam>;
  constexpr double kStep = 1e-2;
  constexpr double kAlong = 3;  // m/s^2
  Rig<SceneT> rig(kStep);
  auto settings = rig.world->settings();
  settings.gravity_W.x() = TypeParam(kAlong);
  settings.separation = TypeParam(1e-3);
  EXPECT_EQ(rig.world->configure(settings), Status::kOk);
  (void)rig.world->add(test::fixed_rod<SceneT>(6, 0.05, {0, 0, 0}, test::along_x()));
  rig.id = rig.world->add(test::solid_ball<SceneT>(0.05, {0, 0, 0.1})).value;
  auto pellet = test::solid_ball<SceneT>(0.01, {0, 0, 0.16 + 0.004});
  test::throw_body(pellet, {0, 0, -1});
  (void)rig.world->add(pellet);
  (void)rig.step();
  const double held = kStep - rig.velocity().x() / kAlong;
  EXPECT_LT(held, 0.4 * kStep);
  EXPECT_NEAR(rig.held, held, 1e-3 * kStep);  // the pellet meets it 3 um off its middle
}

/// A roller on an axle that another one rests on: who is struck off it leaves it where it is.
TYPED_TEST(Held, RollerUnderTwo_StaysOnItsAxle) {
  using SceneT = HeldScene<TypeParam>;
  constexpr double kStep = 1.0 / 30;
  for (int i = 0; i < 20; ++i) {
    Rig<SceneT> rig(kStep);
    auto roller = test::solid_rod<SceneT>(2, 0.05, {0, 0, 0}, test::along_x());
    roller.body.inverse_mass = 0;
    roller.body.inverse_moments.x() = roller.body.inverse_moments.y() = 0;
    roller.owner = 7;
    rig.id = rig.world->add(roller).value;
    auto sliding = test::solid_ball<SceneT>(0.05, {0, 0, 0.102});
    test::throw_body(sliding, {1, 0, -0.3});
    (void)rig.world->add(sliding);
    auto resting = test::solid_ball<SceneT>(0.05, {-0.5, 0, 0.10001});
    test::throw_body(resting, {0, 0, -0.001});
    (void)rig.world->add(resting);
    auto post = test::fixed_rod<SceneT>(0.2, 0.05, {0.108 + i * 1e-3, 0, 0.1});
    post.owner = 7;
    (void)rig.world->add(post);
    rig.is_complete = false;
    while (rig.time < 1) (void)rig.step();
    const Vec3<TypeParam> axis = rig.body().X_WB.q_WB * Vec3<TypeParam>::UnitZ();
    EXPECT_EQ(rig.place(), Vector(0, 0, 0)) << i;
    EXPECT_NEAR(static_cast<double>(axis.x()), 1, 1e-6) << i;
  }
}

/// Each on a floor has its own f(D), and who strikes another gives it what mechanics says: all
/// along the floor, but for the little by which their centres are not level.
TYPED_TEST(Held, TwoOnOneFloor_HaveTheirMomenta) {
  using SceneT = HeldScene<TypeParam>;
  const double rounding = std::is_same_v<TypeParam, float> ? 1e-4 : 1e-11;
  for (const double dt : kSteps) {
    Rig<SceneT> rig(dt);
    (void)rig.world->add(test::fixed_rod<SceneT>(4, 0.05, {0, 0, 0}, test::along_x()));
    auto first = test::solid_ball<SceneT>(0.05, {0, 0, 0.1});
    auto second = test::solid_ball<SceneT>(0.05, {-0.2, 0, 0.1});
    first.restitution = second.restitution = 1;
    test::throw_body(first, {0.5, 0, 0});
    test::throw_body(second, {1, 0, 0});
    rig.id = rig.world->add(first).value;
    const auto other = rig.world->add(second).value;
    while (rig.time < 1) (void)rig.step();
    const auto v = twist_of(std::as_const(*rig.world).get(other)->body).v_W;
    EXPECT_NEAR(rig.velocity().x() + static_cast<double>(v.x()), 1.5, rounding) << dt;
    EXPECT_NEAR(rig.velocity().x(), 1, 2e-3) << dt;
  }
}

}  // namespace
}  // namespace batuta
