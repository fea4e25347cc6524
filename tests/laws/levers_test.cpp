// SPDX-License-Identifier: MIT
// What turns about an axle, between what lies on it and what it lies on itself: levers, tilted
// rollers, loads that slide along it, loads that are struck off it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Vector;

constexpr double kGravity = 9.81;  // m/s^2
constexpr double kMu = 0.5;

/// D of these bodies, m.
double gap_of_rest(double dt) {
  return max_of(1e-4, kGravity * dt * dt / 4);
}

/// Goes nowhere, and turns about one axis of its own. @param axis  0: x, 2: z
template <class SceneT>
void put_on_axle(Actor<SceneT>& actor, int axis) {
  const auto inverse_moment = actor.body.inverse_moments[axis];
  actor.body.inverse_mass = 0;
  actor.body.inverse_moments.setZero();
  actor.body.inverse_moments[axis] = inverse_moment;
}

template <class SceneT>
void let_fall(World<SceneT>& world, const Vector& gravity_W) {
  auto settings = world.settings();
  settings.gravity_W = gravity_W.cast<typename SceneT::Scalar>();
  EXPECT_EQ(world.configure(settings), Status::kOk);
}

template <class SceneT>
double gap_between(const World<SceneT>& world, typename World<SceneT>::BodyId a,
                   typename World<SceneT>::BodyId b) {
  const auto& A = *world.get(a);
  const auto& B = *world.get(b);
  return static_cast<double>(
      capsule_gap(to_world(A.body.X_WB, A.capsule_B), to_world(B.body.X_WB, B.capsule_B)).gap);
}

template <class S>
class Levers : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Levers, Scalars);

/// A lever of 1 m on an axle along x, a fixed rod 0.2 mm below its one end, and a rod across it.
template <class SceneT>
struct HeldLever {
  using S = typename SceneT::Scalar;
  using Id = typename World<SceneT>::BodyId;

  explicit HeldLever(double load) {
    let_fall(world, {0, 0, -kGravity});
    auto beam = test::solid_rod<SceneT>(1, 0.02, Vector::Zero(), test::along_y());
    put_on_axle(beam, 0);
    auto below = test::fixed_rod<SceneT>(1, 0.05, {0, -0.45, -0.0702}, test::along_x());
    auto above = test::solid_rod<SceneT>(0.3, 0.05, {0, -0.3, 0.0701}, test::along_x());
    const S scale = static_cast<S>(1 / (load * static_cast<double>(above.body.inverse_mass)));
    above.body.inverse_mass *= scale;
    above.body.inverse_moments *= scale;
    beam.friction = below.friction = above.friction = static_cast<S>(kMu);
    lever = world.add(beam).value;
    support = world.add(below).value;
    rod = world.add(above).value;
  }

  World<SceneT> world;
  Id lever, support, rod;
};

// Between two that go nowhere no mass tells how much an impulse changes: what turns does.
TYPED_TEST(Levers, BetweenASupportAndALoad_Sleep) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double load : {0.5, 5.0, 50.0}) {  // kg, on a lever of 1.2 kg
      HeldLever<SceneT> held(load);
      for (int i = 0; i < std::lround(1 / dt); ++i) {
        ASSERT_EQ(held.world.step(static_cast<TypeParam>(dt)), Status::kOk);
        ASSERT_TRUE(held.world.report().complete()) << load << ' ' << dt << ' ' << i;
      }
      EXPECT_EQ(held.world.report().asleep, 2U) << load << ' ' << dt;
      for (const double gap : {gap_between(held.world, held.lever, held.support),
                               gap_between(held.world, held.lever, held.rod)}) {
        EXPECT_GT(gap, 0) << load << ' ' << dt;
        EXPECT_LT(gap, gap_of_rest(dt)) << load << ' ' << dt;
      }
    }
  }
}

/// Two rollers about the direction of `yaw` in the level plane, and a rod between them.
struct CradlePlan {
  double yaw = 0;
  double length = 3;   ///< of a roller, m
  double R = 0.05;     ///< its radius, m
  double r = 0.03;     ///< the rod's, m
  double density = 0;  ///< its, kg/m^3
  double off = 0;      ///< its middle off that of the rollers, m
  double spin = 0;     ///< of the rollers, rad/s

  double aside() const { return 0.7 * (R + r); }
  Vector along() const { return {std::cos(yaw), std::sin(yaw), 0}; }
};
template <class SceneT>
struct Cradle {
  using S = typename SceneT::Scalar;
  using Id = typename World<SceneT>::BodyId;
  static constexpr double kRodLength = 0.25;  // m

  Cradle(const CradlePlan& plan, double dt) {
    const Vector along = plan.along();
    const Vector aside = plan.aside() * Vector::UnitZ().cross(along);
    const test::Rotation q_WB = test::about(Vector::UnitZ(), plan.yaw) * test::along_x();
    for (std::size_t i = 0; i < 2; ++i) {
      auto actor = test::solid_rod<SceneT>(plan.length, plan.R, i == 0 ? -aside : aside, q_WB);
      put_on_axle(actor, 2);
      const double moment = 1 / static_cast<double>(actor.body.inverse_moments.z());
      actor.body.momentum.angular_W = (moment * plan.spin * along).template cast<S>();
      actor.friction = static_cast<S>(kMu);
      rollers[i] = world.add(actor).value;
    }
    const double apart = plan.R + plan.r + gap_of_rest(dt) / 2;
    const Vector up(0, 0, std::sqrt(apart * apart - plan.aside() * plan.aside()));
    auto resting =
        test::solid_rod<SceneT>(kRodLength, plan.r, up + plan.off * along, q_WB, plan.density);
    resting.friction = static_cast<S>(kMu);
    rod = world.add(resting).value;
  }
  void run(double seconds, double dt) {
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
      ASSERT_EQ(world.step(static_cast<S>(dt)), Status::kOk);
      ASSERT_TRUE(world.report().complete()) << i;
    }
  }
  Twist<double> twist_of_body(Id id) const {
    const auto twist = twist_of(world.get(id)->body);
    return {twist.v_W.template cast<double>(), twist.w_W.template cast<double>()};
  }

  World<SceneT> world;
  std::array<Id, 2> rollers;
  Id rod;
};

// Across an axle rollers give way, along it they do not: friction has to find that out. The normals
// stand at an angle A to the vertical, so that friction brakes with mu cos / cos A.
TYPED_TEST(Levers, ALoadThatSlidesAlongAxles_IsBrakedByFriction) {
  using SceneT = test::Settling<TypeParam, test::kFalling>;
  const double part = std::sqrt(0.5);  // of a slope of 45 degrees
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double density : {1e3, 1e5, 1e6}) {  // up to 480 times the rollers' inertia
      CradlePlan plan;
      plan.density = density;
      Cradle<SceneT> cradle(plan, dt);
      let_fall(cradle.world, kGravity * Vector(-part, 0, -part));
      const double time = 0.3;
      ASSERT_NO_FATAL_FAILURE(cradle.run(time, dt));
      const double cos_A = std::sqrt(1 - 0.7 * 0.7);
      const double right = kGravity * part * (1 - kMu / cos_A) * std::round(time / dt) * dt;
      EXPECT_NEAR(-cradle.twist_of_body(cradle.rod).v_W.x() / right, 1, 0.015)
          << density << ' ' << dt;
    }
  }
}

// The bearings take some 40 N m each second here, which is no part of the spin.
TYPED_TEST(Levers, ALoadOffTheMiddleOfTurnedRollers_SharesTheirSpin) {
  using SceneT = test::Settling<TypeParam, test::kFalling>;
  for (const double yaw : {0.0, 0.6}) {
    const CradlePlan plan = {yaw, 1, 0.03, 0.05, 7800, 0.35, 5};
    Cradle<SceneT> cradle(plan, 1e-3);
    let_fall(cradle.world, {0, 0, -kGravity});
    ASSERT_NO_FATAL_FAILURE(cradle.run(2, 1e-3));
    const auto inverse_of = [&](auto id) {
      return static_cast<double>(cradle.world.get(id)->body.inverse_moments.z());
    };
    const double ratio = plan.R / plan.r;
    const double w = plan.spin / (1 + inverse_of(cradle.rollers[0]) / inverse_of(cradle.rod) *
                                          ratio * ratio / 2);
    for (const auto& id : cradle.rollers) {
      EXPECT_NEAR(cradle.twist_of_body(id).w_W.dot(plan.along()) / w, 1, 0.01) << yaw;
    }
  }
}

/// A ball lies on a lever, and another one strikes it in mid-step, along the axle.
template <class SceneT>
struct StruckLoad {
  using S = typename SceneT::Scalar;

  explicit StruckLoad(double dt) {
    let_fall(world, {0, 0, -kGravity});
    auto beam = test::solid_rod<SceneT>(1, 0.02, Vector::Zero(), test::along_y());
    put_on_axle(beam, 0);
    (void)world.add(beam).value;
    auto load = test::solid_ball<SceneT>(0.05, {0, 0.4, 0.07 + 1e-6});
    load.restitution = 1;
    const auto id = world.add(load).value;
    EXPECT_EQ(world.step(static_cast<S>(dt)), Status::kOk);  // it comes to lie there
    const auto& body = world.get(id)->body;
    const Vector p_W = body.X_WB.p_W.template cast<double>();
    const double falls = static_cast<double>(twist_of(body).v_W.z());
    const double speed = 2;  // m/s
    auto striker =
        test::solid_ball<SceneT>(0.05, p_W + Vector(0.1 + speed * dt / 2, 0, falls * dt / 2));
    test::throw_body(striker, {-speed, 0, falls});
    striker.restitution = 1;
    (void)world.add(striker);
  }
  /// About the axle, of all: angular momentum, N m s; and of what gravity pulls at, sum(m y), kg m.
  std::tuple<double, double> about_axle() const {
    double spin = 0;
    double pull = 0;
    for (std::uint16_t i = 0; i < 3; ++i) {
      const auto& body = world.get(world.id_at(i))->body;
      const Vector x = body.X_WB.p_W.template cast<double>();
      spin += static_cast<double>(body.momentum.angular_W.x());
      if (!(body.inverse_mass > 0)) continue;
      spin += x.cross(body.momentum.linear_W.template cast<double>()).x();
      pull += x.y() / static_cast<double>(body.inverse_mass);
    }
    return {spin, pull};
  }

  World<SceneT> world;
};

/// What the lever took for the rest of the step comes back with what lay on it.
template <class SceneT>
void expect_only_gravity_turns_it(double dt) {
  StruckLoad<SceneT> struck(dt);
  const auto [before, pull] = struck.about_axle();
  ASSERT_EQ(struck.world.step(static_cast<typename SceneT::Scalar>(dt)), Status::kOk);
  ASSERT_TRUE(struck.world.report().complete()) << dt;
  const auto [after, pull_then] = struck.about_axle();
  // The load's own time: while it is held, nothing pulls at it.
  const auto& load = struck.world.get(struck.world.id_at(1))->body;
  const double of_load =
      static_cast<double>(load.X_WB.p_W.y()) / static_cast<double>(load.inverse_mass);
  const double held = static_cast<double>(struck.world.report().time_held);
  const double right = -kGravity * (dt * (pull + pull_then) / 2 - held * of_load);
  EXPECT_NEAR((after - before) / right, 1, 1e-3) << dt;
}

TYPED_TEST(Levers, ALoadThatIsStruckOffThem_GivesBackWhatItWouldHavePressed) {
  for (const double dt : {1e-3, 1.0 / 60}) {
    expect_only_gravity_turns_it<test::LawScene<TypeParam, RestingContact::kNone, test::kFalling>>(
        dt);
    expect_only_gravity_turns_it<
        test::LawScene<TypeParam, RestingContact::kSeparation, test::kFalling>>(dt);
    expect_only_gravity_turns_it<test::Settling<TypeParam, test::kFalling>>(dt);
  }
}

}  // namespace
}  // namespace batuta
