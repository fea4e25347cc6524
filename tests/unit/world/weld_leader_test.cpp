// SPDX-License-Identifier: MIT
// Bodies that go on together with what holds them: fixed bodies, driven ones, sleepers; and under
// gravity (src/world/world.md, "Together").

#include "weld_rig.hpp"

namespace batuta {
namespace {

using namespace test;

enum class Asks { kNothing, kGravity, kSleep };
template <int kBodies, Asks kAsks>
constexpr SceneOptions leader_options() {
  SceneOptions scene;
  scene.max_bodies = kBodies;
  scene.max_pairs = kBodies * (kBodies - 1) / 2;
  scene.gravity = kAsks != Asks::kNothing;
  scene.sleep = kAsks == Asks::kSleep;
  if (scene.sleep) scene.resting = RestingContact::kSettling;
  return scene;
}
/// A hand that was struck lets its body fly: so a scene of hands has free bodies, too.
template <class S, int kBodies>
using HandScene = Scene<leader_options<kBodies, Asks::kNothing>, Advancement<S>, Hand<S>>;
template <class S, int kBodies>
using FallScene = Scene<leader_options<kBodies, Asks::kGravity>, Advancement<S>>;
template <class S, int kBodies>
using SleepScene = Scene<leader_options<kBodies, Asks::kSleep>, Advancement<S>>;

constexpr double kStep = 0.01;

template <class S>
class WeldLeader : public ::testing::Test {
 protected:
  template <class SceneT>
  std::size_t add_free(WeldRig<SceneT>& rig) {
    typename SceneT::Controller controller;
    if constexpr (std::is_same_v<typename SceneT::Controller, Hand<S>>) controller.struck = true;
    return rig.add(random_body<S>(random_, 1, 2, 10), controller);
  }
  /// Carried by 0.02 m and 0.3 rad in the step.
  template <class SceneT>
  std::size_t add_driven(WeldRig<SceneT>& rig, bool is_heavy = false) {
    Body<S> body = random_body<S>(random_, 1, 2, 10);
    if (is_heavy) {
      body.inverse_mass = 0;
      body.inverse_moments.setZero();
    }
    Hand<S> hand;
    hand.step = S(kStep);
    hand.target_W = body.X_WB;
    hand.target_W.p_W += Vec3<S>(S(0.02), S(0.01), 0);
    hand.target_W.q_WB = exp_map(Vec3<S>(S(0.1), S(0.2), S(0.3))) * body.X_WB.q_WB;
    return rig.add(body, hand);
  }
  template <class SceneT>
  std::size_t add_wall(WeldRig<SceneT>& rig) {
    Body<S> body = random_body<S>(random_, 1, 0, 0);
    body.inverse_mass = 0;
    body.inverse_moments.setZero();
    typename SceneT::Controller controller;
    if constexpr (std::is_same_v<typename SceneT::Controller, Hand<S>>) controller.struck = true;
    return rig.add(body, controller);
  }
  static void expect_same_place(const Body<S>& is, const Body<S>& was) {
    EXPECT_EQ(is.X_WB.p_W, was.X_WB.p_W);
    EXPECT_EQ(is.X_WB.q_WB.coeffs(), was.X_WB.q_WB.coeffs());
  }
  static void expect_at_rest(const Body<S>& body) {
    EXPECT_EQ(body.momentum.linear_W, Vec3<S>(Vec3<S>::Zero()));
    EXPECT_EQ(body.momentum.angular_W, Vec3<S>(Vec3<S>::Zero()));
  }
  std::mt19937_64 random_{21};
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WeldLeader, Scalars);

template <class S, int kBodies, class Fixture>
void follow(Fixture add_bodies, bool is_heavy) {
  WeldRig<HandScene<S, kBodies>> rig;
  add_bodies(rig, is_heavy);
  rig.begin(kStep);
  const auto was = rig.all();
  rig.bodies.weld(0, 1, rig.bodies.dt);
  if (kBodies > 2) rig.bodies.weld(1, 2, rig.bodies.dt);
  const auto target = rig.bodies.actor(1).controller.target_W;
  rig.finish();
  const auto is = rig.all();
  const Exact small = 64 * Exact(kRoundOff<S>);
  EXPECT_LE((exact(is[1].X_WB.p_W) - exact(target.p_W)).norm(), small) << "as if alone";
  const ExactMat turn = rotation_of(target.q_WB) * rotation_of(was[1].X_WB.q_WB).transpose();
  const ExactVec w = ExactVec(0.1L, 0.2L, 0.3L) / kStep, v = ExactVec(0.02L, 0.01L, 0) / kStep;
  for (std::size_t i = 0; i < kBodies; ++i) {
    const ExactVec r = turn * (exact(was[i].X_WB.p_W) - exact(was[1].X_WB.p_W));
    EXPECT_LE((exact(is[i].X_WB.p_W) - exact(target.p_W) - r).norm(), small) << i;
    const ExactMat own = turn * rotation_of(was[i].X_WB.q_WB);
    EXPECT_LE((rotation_of(is[i].X_WB.q_WB) - own).norm(), small) << i;
    if (i == 1) continue;
    const auto twist = twist_of(is[i]);
    EXPECT_LE((exact(twist.v_W) - v - w.cross(r)).norm(), 100 * small) << i;
    EXPECT_LE((exact(twist.w_W) - w).norm(), 1000 * small) << i;
  }
  EXPECT_EQ(is[1].momentum.linear_W, was[1].momentum.linear_W) << "the hand's matter is the hand's";
}

// Its controller is asked once a step, whatever it answers later; again where it has gone together
// with others, and is off its way.
TYPED_TEST(WeldLeader, DrivenAlone_KeepsItsCourse) {
  using S = TypeParam;
  for (const bool was_held : {false, true}) {
    WeldRig<HandScene<S, 2>> rig;
    const std::size_t driven = this->add_driven(rig, true);
    rig.begin(kStep);
    const Vec3<S> v_W = rig.bodies.states[driven].plan.motion.twist.v_W;
    rig.bodies.now = S(kStep / 2);
    rig.bodies.advance_to_now(driven);
    rig.bodies.actor(driven).controller.target_W.p_W += Vec3<S>(0, 0, S(0.1));
    if (was_held) rig.bodies.states[driven].held_until = rig.bodies.now;
    rig.bodies.plan(driven);
    const Vec3<S>& planned_W = rig.bodies.states[driven].plan.motion.twist.v_W;
    EXPECT_EQ(planned_W == v_W, !was_held);
  }
}

TYPED_TEST(WeldLeader, DrivenBody_TakesTheOthersAlong) {
  for (const bool is_heavy : {false, true}) {
    const auto add = [this](auto& rig, bool heavy) {
      this->add_free(rig);
      this->add_driven(rig, heavy);
      if (rig.bodies.states.size() > 2) this->add_free(rig);
    };
    follow<TypeParam, 2>(add, is_heavy);
    follow<TypeParam, 3>(add, is_heavy);
  }
}

// f(D): it is taken along, and its momenta stay; as the driven one sees it the angular one does, so
// that its turn has the same energy.
TYPED_TEST(WeldLeader, HeldByADrivenBody_GoesAlongAndKeepsItsMomenta) {
  using S = TypeParam;
  const Exact small = 64 * Exact(kRoundOff<S>);
  for (const bool is_heavy : {false, true}) {
    WeldRig<HandScene<S, 2>> rig;
    this->add_free(rig);
    this->add_driven(rig, is_heavy);
    rig.begin(kStep);
    const auto was = rig.all();
    rig.bodies.hold(0, 1, rig.bodies.dt);
    const auto target = rig.bodies.actor(1).controller.target_W;
    rig.finish();
    const auto is = rig.all();
    const ExactMat turn = rotation_of(target.q_WB) * rotation_of(was[1].X_WB.q_WB).transpose();
    const ExactVec r = turn * (exact(was[0].X_WB.p_W) - exact(was[1].X_WB.p_W));
    EXPECT_LE((exact(is[0].X_WB.p_W) - exact(target.p_W) - r).norm(), small);
    EXPECT_EQ(is[0].momentum.linear_W, was[0].momentum.linear_W);
    const ExactVec L = turn * exact(was[0].momentum.angular_W);
    EXPECT_GT(L.norm(), 0.01L);
    EXPECT_LE((exact(is[0].momentum.angular_W) - L).norm(), small * L.norm());
    EXPECT_EQ(is[1].momentum.linear_W, was[1].momentum.linear_W);
  }
}

TYPED_TEST(WeldLeader, TwoDrivenBodies_Stand_AndWhoIsWithThem) {
  WeldRig<HandScene<TypeParam, 3>> rig;
  this->add_driven(rig);
  this->add_free(rig);
  this->add_driven(rig);
  rig.begin(kStep);
  const auto was = rig.all();
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.bodies.weld(1, 2, rig.bodies.dt);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(rig.bodies.is_wall(i)) << "nothing pushes them";
  rig.finish();
  for (std::size_t i = 0; i < 3; ++i) this->expect_same_place(rig.body(i), was[i]);
  this->expect_at_rest(rig.body(1));
  EXPECT_EQ(rig.bodies.report.time_held, rig.bodies.dt);
}

// Twice two: in a scene of two bodies as well.
TYPED_TEST(WeldLeader, TwoDrivenBodiesAlone_Stand) {
  WeldRig<HandScene<TypeParam, 2>> rig;
  this->add_driven(rig);
  this->add_driven(rig);
  rig.begin(kStep);
  const auto was = rig.all();
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.finish();
  for (std::size_t i = 0; i < 2; ++i) this->expect_same_place(rig.body(i), was[i]);
}

// What else meets the wall is not stopped by it.
TYPED_TEST(WeldLeader, FixedBody_Stops_ButIsNoMember) {
  WeldRig<HandScene<TypeParam, 4>> rig;
  this->add_free(rig);
  this->add_wall(rig);
  this->add_driven(rig);
  this->add_free(rig);
  rig.begin(kStep);
  const auto was = rig.all();
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.bodies.weld(2, 1, rig.bodies.dt);
  EXPECT_EQ(rig.bodies.states[1].group, rig.bodies.kAlone);
  EXPECT_NE(rig.bodies.states[0].group, rig.bodies.states[2].group);
  rig.finish();
  for (std::size_t i = 0; i < 3; ++i) this->expect_same_place(rig.body(i), was[i]);
  this->expect_at_rest(rig.body(0));
  EXPECT_EQ(rig.body(2).momentum.linear_W, was[2].momentum.linear_W);
  EXPECT_GT((rig.body(3).X_WB.p_W - was[3].X_WB.p_W).norm(), TypeParam(1e-4)) << "nobody's";
}

// A group that stands, met by one that moves: that stands as well. After it parts, all go on.
TYPED_TEST(WeldLeader, GroupThatStands_StopsWhatMeetsIt) {
  WeldRig<FallScene<TypeParam, 3>> rig;
  this->add_free(rig);
  this->add_wall(rig);
  this->add_free(rig);
  WorldSettings<FallScene<TypeParam, 3>> settings;
  settings.gravity_W.setZero();
  rig.bodies.settings = settings;
  rig.begin(kStep);
  rig.bodies.weld(0, 1, rig.bodies.dt);
  const auto was = rig.all();
  rig.bodies.now = TypeParam(0.004);
  rig.bodies.weld(0, 2, rig.bodies.dt);
  const auto met = rig.all();
  rig.finish();
  this->expect_same_place(rig.body(0), was[0]);
  this->expect_same_place(rig.body(2), met[2]);
  EXPECT_NE(met[2].X_WB.p_W, was[2].X_WB.p_W);
  this->expect_at_rest(rig.body(2));
}

// Nobody holds them: their centre is on its parabola, and all of gravity is in their momentum. They
// were thrown before the step, and welded in its middle.
TYPED_TEST(WeldLeader, GroupThatFalls_IsOnItsParabola) {
  using S = TypeParam;
  WeldRig<FallScene<S, 3>> rig;
  for (int i = 0; i < 3; ++i) this->add_free(rig);
  const Whole was = whole_of(rig.all());
  rig.begin(kStep);
  rig.bodies.now = S(0.003);
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.bodies.now = S(0.006);
  rig.bodies.weld(1, 2, rig.bodies.dt);
  rig.finish();
  const Whole is = whole_of(rig.all());
  const Exact dt = Exact(rig.bodies.dt), u = kRoundOff<S>;
  const ExactVec g = exact(rig.bodies.settings.gravity_W);
  EXPECT_LE((is.momentum - was.momentum - was.mass * dt * g).norm(), 64 * u * is.size);
  const ExactVec way = dt * was.momentum / was.mass + dt * dt / 2 * g;
  EXPECT_LE((is.center - was.center - way).norm(), 64 * u);
  const ExactVec spin =
      was.about_origin() + was.mass * dt * (was.center + dt / 2 * was.momentum / was.mass).cross(g);
  EXPECT_LE((is.about_origin() - spin).norm(), 64 * u * is.size);
}

// Carried while it stood, it begins to fall when it parts.
TYPED_TEST(WeldLeader, GroupThatStood_FallsFromWhenItParts) {
  using S = TypeParam;
  WeldRig<FallScene<S, 2>> rig;
  this->add_free(rig);
  this->add_wall(rig);
  rig.begin(kStep);
  const auto was = rig.all();
  rig.bodies.weld(0, 1, S(0.004));
  rig.bodies.now = S(0.004);
  rig.bodies.part_group(0);
  this->expect_same_place(rig.body(0), was[0]);
  rig.bodies.plan(0);
  rig.finish();
  const Exact fallen = Exact(rig.bodies.dt) - Exact(S(0.004));
  const ExactVec g = exact(rig.bodies.settings.gravity_W);
  const ExactVec p = exact(rig.body(0).momentum.linear_W) * Exact(rig.body(0).inverse_mass);
  EXPECT_LE((p - fallen * g).norm(), 8 * Exact(kRoundOff<S>));
  const ExactVec way = exact(rig.body(0).X_WB.p_W) - exact(was[0].X_WB.p_W);
  EXPECT_LE((way - fallen * fallen / 2 * g).norm(), 8 * Exact(kRoundOff<S>));
}

// Held, its time stands still: it goes on its parabola from then on, as fast as before.
TYPED_TEST(WeldLeader, HeldByAWall_GoesOnAsFastAsBefore) {
  using S = TypeParam;
  WeldRig<FallScene<S, 3>> rig;
  this->add_free(rig);
  this->add_wall(rig);
  this->add_free(rig);
  rig.begin(kStep);
  const auto was = rig.all();
  rig.bodies.hold(0, 1, S(0.004));
  rig.bodies.hold(2, 1, S(0.007));
  const Exact until[] = {Exact(S(0.004)), 0, Exact(S(0.007))};
  for (const std::size_t slot : {std::size_t(0), std::size_t(2)}) {
    EXPECT_EQ(Exact(rig.bodies.goes_until(slot)), until[slot]) << "each has its own";
    rig.bodies.now = static_cast<S>(until[slot]);
    rig.bodies.part_group(slot);
    this->expect_same_place(rig.body(slot), was[slot]);
    rig.bodies.plan(slot);
  }
  rig.finish();
  const ExactVec g = exact(rig.bodies.settings.gravity_W);
  for (const std::size_t slot : {std::size_t(0), std::size_t(2)}) {
    const Exact softness = Exact(was[slot].inverse_mass);
    const Exact u = Exact(kRoundOff<S>);
    // The rig's step has given it the fall of the whole step before.
    const ExactVec p = exact(was[slot].momentum.linear_W) * softness - until[slot] * g;
    const Exact scale = 1 + p.norm();
    EXPECT_LE((exact(rig.body(slot).momentum.linear_W) * softness - p).norm(), 8 * u * scale);
    EXPECT_EQ(rig.body(slot).momentum.angular_W, was[slot].momentum.angular_W);
    const Exact own = Exact(rig.bodies.dt) - until[slot];
    const ExactVec way = exact(rig.body(slot).X_WB.p_W) - exact(was[slot].X_WB.p_W);
    EXPECT_LE((way - own * p + own * own / 2 * g).norm(), 16 * u * scale);
  }
}

// A sleeper is as a wall: who sleeps stays asleep and in its place.
TYPED_TEST(WeldLeader, SleepingBody_Stops_AndSleepsOn) {
  WeldRig<SleepScene<TypeParam, 3>> rig;
  this->add_free(rig);
  this->add_free(rig);
  rig.body(1).momentum = {};
  rig.bodies.states[1].asleep = true;
  rig.begin(kStep);
  const auto was = rig.all();
  rig.bodies.weld(0, 1, rig.bodies.dt);
  EXPECT_EQ(rig.bodies.states[1].group, rig.bodies.kAlone);
  rig.finish();
  for (std::size_t i = 0; i < 2; ++i) {
    this->expect_same_place(rig.body(i), was[i]);
    this->expect_at_rest(rig.body(i));
  }
  EXPECT_TRUE(rig.bodies.states[1].asleep);
}

// A group that is led has no flight: there is nothing that it could be off.
TYPED_TEST(WeldLeader, GroupThatIsLed_IsNotOffItsFlight) {
  WeldRig<HandScene<TypeParam, 3>> rig;
  const auto first = this->add_free(rig);
  const auto second = this->add_free(rig);
  const auto driven = this->add_driven(rig);
  rig.begin(kStep);
  rig.bodies.weld(first, second, rig.bodies.dt);
  EXPECT_NE(rig.bodies.group_off_flight(first, TypeParam(0.75 * kStep)), TypeParam(0));
  rig.bodies.weld(first, driven, rig.bodies.dt);
  EXPECT_EQ(rig.bodies.group_off_flight(first, TypeParam(0.75 * kStep)), TypeParam(0));
}

}  // namespace
}  // namespace batuta
