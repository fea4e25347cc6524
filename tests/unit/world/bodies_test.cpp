// SPDX-License-Identifier: MIT
// Bodies and their clocks, by hand: where one is when it is brought to a time within the step, and
// what becomes of one whose motion is none. Places in long double.

#include "weld_rig.hpp"

namespace batuta {
namespace {

using namespace test;

constexpr SceneOptions falling_options() {
  SceneOptions scene;
  scene.gravity = true;
  return scene;
}
template <class S>
using FallingScene = Scene<falling_options, Advancement<S>>;

template <class S>
class BodiesOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BodiesOf, Scalars);

// Brought to five times of the step and planned anew each time: at the end on its parabola, with
// all of gravity in its momentum; between, on chords.
TYPED_TEST(BodiesOf, FallInPieces_EndsOnTheParabola) {
  using S = TypeParam;
  std::mt19937_64 random(1);
  WeldRig<FallingScene<S>> rig;
  rig.add(random_body<S>(random, 2, 3, 5));
  const Body<S> was = rig.body(0);
  rig.begin(0.1);
  for (const double t : {0.01, 0.035, 0.05, 0.051, 0.09}) {
    rig.bodies.now = S(t);
    rig.bodies.advance_to_now(0);
    EXPECT_EQ(rig.bodies.states[0].start, S(t));
    rig.bodies.plan(0);
  }
  rig.finish();
  const Exact dt = rig.bodies.dt, u = kRoundOff<S>;
  const ExactVec g = exact(rig.bodies.settings.gravity_W);
  const ExactVec v = exact(was.momentum.linear_W) * Exact(was.inverse_mass);
  const ExactVec end = exact(was.X_WB.p_W) + dt * v + dt * dt / 2 * g;
  EXPECT_LE((exact(rig.body(0).X_WB.p_W) - end).norm(), 16 * u);
  const ExactVec gained = exact(rig.body(0).momentum.linear_W) - exact(was.momentum.linear_W);
  EXPECT_LE((gained - dt / Exact(was.inverse_mass) * g).norm(), 16 * u);
  EXPECT_EQ(rig.body(0).momentum.angular_W, was.momentum.angular_W);
}

// At t it is above the chord by g t (T - t) / 2, which it remembers; its matter moves as the
// parabola does there.
TYPED_TEST(BodiesOf, WithinAStep_ItIsOnTheChord_AndKnowsHowFarOff) {
  using S = TypeParam;
  std::mt19937_64 random(2);
  WeldRig<FallingScene<S>> rig;
  rig.add(random_body<S>(random, 2, 3, 5));
  const Body<S> was = rig.body(0);
  rig.begin(0.1);
  rig.bodies.now = S(0.04);
  rig.bodies.advance_to_now(0);
  const Exact t = rig.bodies.now, dt = rig.bodies.dt, u = kRoundOff<S>;
  const ExactVec g = exact(rig.bodies.settings.gravity_W);
  const ExactVec v = exact(was.momentum.linear_W) * Exact(was.inverse_mass);
  const ExactVec on_parabola = exact(was.X_WB.p_W) + t * v + t * t / 2 * g;
  const ExactVec off = -t * (dt - t) / 2 * g;
  EXPECT_LE((exact(rig.bodies.states[0].off_W) - off).norm(), 16 * u);
  EXPECT_LE((exact(rig.body(0).X_WB.p_W) + off - on_parabola).norm(), 16 * u);
  EXPECT_LE((exact(rig.bodies.twist_now(0).v_W) - v - t * g).norm(), 32 * u);
}

TYPED_TEST(BodiesOf, SpoiledOrientation_GoesOnWithoutATurn_AndIsCounted) {
  using S = TypeParam;
  std::mt19937_64 random(3);
  WeldRig<FallingScene<S>> rig;
  rig.add(random_body<S>(random, 2, 3, 5));
  rig.body(0).X_WB.q_WB.w() = 3;
  rig.bodies.settings.gravity_W.setZero();
  const Body<S> was = rig.body(0);
  rig.begin(0.1);
  EXPECT_EQ(rig.bodies.report.plans_invalid, 1U);
  EXPECT_EQ(rig.bodies.report.time_held, S(0));
  rig.finish();
  const Vec3<S> way = rig.bodies.dt * was.inverse_mass * was.momentum.linear_W;
  EXPECT_LE((rig.body(0).X_WB.p_W - was.X_WB.p_W - way).norm(), 4 * kRoundOff<S>);
  EXPECT_EQ(rig.body(0).X_WB.q_WB.coeffs(), was.X_WB.q_WB.coeffs());
}

// Who can be planned by its momenta, and who cannot: within the step, for what is left of it.
TYPED_TEST(BodiesOf, PlannedWithinAStep_GoesForWhatIsLeft) {
  using S = TypeParam;
  for (const bool is_spoilt : {false, true}) {
    std::mt19937_64 random(5);
    WeldRig<FallingScene<S>> rig;
    rig.add(random_body<S>(random, 2, 3, 5));
    rig.begin(0.125);
    rig.bodies.now = S(0.03125);
    rig.bodies.advance_to_now(0);
    if (is_spoilt) rig.body(0).X_WB.q_WB.w() = 3;
    rig.bodies.plan(0);
    EXPECT_EQ(rig.bodies.report.plans_invalid, is_spoilt ? 1U : 0U);
    EXPECT_EQ(rig.bodies.states[0].plan.motion.duration, S(0.09375)) << is_spoilt;
  }
}

TYPED_TEST(BodiesOf, SpeedBeyondTheNumbers_Stands_AndIsTold) {
  using S = TypeParam;
  std::mt19937_64 random(4);
  WeldRig<FallingScene<S>> rig;
  rig.add(random_body<S>(random, 0.01, 3, 5));
  rig.bodies.settings.gravity_W.setZero();
  rig.body(0).momentum.linear_W.setConstant(std::numeric_limits<S>::max() / 2);
  const Body<S> was = rig.body(0);
  rig.begin(0.1);
  EXPECT_EQ(rig.bodies.report.plans_invalid, 1U);
  EXPECT_EQ(rig.bodies.report.time_held, rig.bodies.dt);
  rig.finish();
  EXPECT_EQ(rig.body(0).X_WB.p_W, was.X_WB.p_W);
  EXPECT_EQ(rig.body(0).momentum.linear_W, was.momentum.linear_W);
}

}  // namespace
}  // namespace batuta
