// SPDX-License-Identifier: MIT
// Bodies that go on together (src/world/world.md, "Together"), by hand: who leads, who stands, and
// that what nobody holds is one rigid body. Sums, and the turn of a rigid body, in long double.

#include "weld_rig.hpp"

namespace batuta {
namespace {

using namespace test;

template <int kBodies, bool kFalls>
constexpr SceneOptions free_options() {
  SceneOptions scene;
  scene.max_bodies = kBodies;
  scene.max_pairs = kBodies * (kBodies - 1) / 2;
  scene.resting = RestingContact::kNone;
  scene.gravity = kFalls;
  return scene;
}
template <class S, int kBodies, bool kFalls = false>
using FreeScene = Scene<free_options<kBodies, kFalls>, Advancement<S>>;

template <class S>
class Weld : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Weld, Scalars);

template <class S>
constexpr Exact u = kRoundOff<S>;

/// P and L as they were; the centre where it would be; nobody nearer to or turned against another;
/// every velocity that of its place, with the least energy there is for P and L.
template <class S>
void expect_one_rigid_body(const std::vector<Body<S>>& before, const std::vector<Body<S>>& after,
                           Exact time) {
  const Whole was = whole_of(before), is = whole_of(after);
  const Exact slack = 32 * u<S> * (was.size + is.size);
  EXPECT_LE((is.momentum - was.momentum).norm(), 32 * u<S> * (was.size + is.size));
  const ExactVec way = time * was.momentum / was.mass;
  EXPECT_LE((is.about_origin() - was.about_origin()).norm(), slack * (1 + way.norm()));
  EXPECT_LE((is.center - was.center - way).norm(), 32 * u<S> * (1 + way.norm()));
  const ExactVec w = solve(is.inertia, is.spin);
  const ExactMat turn =
      rotation_of(after[0].X_WB.q_WB) * rotation_of(before[0].X_WB.q_WB).transpose();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const ExactVec r = exact(after[i].X_WB.p_W) - is.center;
    const ExactVec r0 = exact(before[i].X_WB.p_W) - was.center;
    EXPECT_LE((r - turn * r0).norm(), 64 * u<S> * (1 + way.norm())) << i;
    const ExactMat own = turn * rotation_of(before[i].X_WB.q_WB);
    EXPECT_LE((rotation_of(after[i].X_WB.q_WB) - own).norm(), 64 * u<S>) << i;
    const auto twist = twist_of(after[i]);
    const ExactVec v = is.momentum / is.mass + w.cross(r);
    EXPECT_LE((exact(twist.v_W) - v).norm(), 1e4L * u<S> * (v.norm() + w.norm())) << i;
    EXPECT_LE((exact(twist.w_W) - w).norm(), 1e4L * u<S> * (v.norm() + w.norm())) << i;
  }
  const Exact least = is.momentum.squaredNorm() / is.mass / 2 + is.spin.dot(w) / 2;
  EXPECT_NEAR(double(is.energy / least), 1, double(1e4L * u<S>));
}

template <class S, int kBodies>
void weld_all(std::mt19937_64& random, double heaviest) {
  constexpr double kStep = 0.01;
  WeldRig<FreeScene<S, kBodies>> rig;
  for (int i = 0; i < kBodies; ++i) {
    rig.add(random_body<S>(random, i == 0 ? heaviest : 1, 2, 10));
  }
  rig.begin(kStep);
  rig.bodies.now = S(kStep / 4);  // first a pair, then one more each time
  for (std::size_t i = 1; i < kBodies; ++i) rig.bodies.weld(i - 1, i, rig.bodies.dt);
  const auto before = rig.all();
  const Exact least = whole_of(before).energy;
  rig.finish();
  expect_one_rigid_body(before, rig.all(), Exact(rig.bodies.dt) - Exact(S(kStep / 4)));
  EXPECT_LE(whole_of(rig.all()).energy, least * (1 + 64 * u<S>))
      << "of other motions with these sums";
  EXPECT_GT(rig.bodies.report.time_held, S(0));
}

TYPED_TEST(Weld, OfBodiesThatNobodyHolds_IsOneRigidBody) {
  std::mt19937_64 random(14);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    weld_all<TypeParam, 2>(random, i % 2 == 0 ? 1 : 1000);
    weld_all<TypeParam, 3>(random, 1);
    weld_all<TypeParam, 5>(random, i % 2 == 0 ? 3 : 0.01);
    if (this->HasFailure()) return;
  }
}

/// Two groups of two, then all four: by another order the same.
TYPED_TEST(Weld, OfGroups_IsAGroup) {
  using S = TypeParam;
  std::mt19937_64 random(3);
  WeldRig<FreeScene<S, 4>> rig;
  for (int i = 0; i < 4; ++i) rig.add(random_body<S>(random, 1, 2, 10));
  rig.begin(0.01);
  const Whole was = whole_of(rig.all());
  rig.bodies.weld(0, 3, rig.bodies.dt);
  rig.bodies.weld(2, 1, rig.bodies.dt);
  EXPECT_EQ(rig.bodies.states[3].group, 0);
  EXPECT_EQ(rig.bodies.states[2].group, 1);
  rig.bodies.now = S(0.002);
  rig.bodies.weld(3, 2, rig.bodies.dt);
  for (const auto& state : rig.bodies.states) EXPECT_EQ(state.group, 0);
  const auto before = rig.all();
  rig.finish();
  expect_one_rigid_body(before, rig.all(), Exact(rig.bodies.dt) - Exact(S(0.002)));
  const Whole is = whole_of(rig.all());
  EXPECT_LE((is.about_origin() - was.about_origin()).norm(), 64 * u<S> * (is.size + was.size));
  for (const auto& state : rig.bodies.states) EXPECT_EQ(state.group, rig.bodies.kAlone);
}

/// A momentum is that of the step's end: who falls is half of what gravity gives in the step behind
/// it. A group of which something carries one does not fall.
TYPED_TEST(Weld, OfWhoIsCarried_DoesNotFall) {
  using S = TypeParam;
  constexpr double kStep = 0.01;
  const Vec3<S> gravity_W(0, 0, S(-10));
  for (const bool is_carried : {false, true}) {
    std::mt19937_64 random(5);
    WeldRig<FreeScene<S, 2, true>> rig;
    rig.bodies.settings.gravity_W = gravity_W;
    for (int i = 0; i < 2; ++i) rig.add(random_body<S>(random, 1, 2, 10));
    rig.begin(kStep);
    rig.bodies.states[1].loaded = is_carried;
    const Whole was = whole_of(rig.all());
    rig.bodies.weld(0, 1, rig.bodies.dt);
    rig.finish();
    const ExactVec behind = exact(Vec3<S>(S(kStep * kStep / 2) * gravity_W));
    const ExactVec way =
        Exact(kStep) * was.momentum / was.mass - (is_carried ? ExactVec(ExactVec::Zero()) : behind);
    EXPECT_LE((whole_of(rig.all()).center - was.center - way).norm(), 32 * u<S>) << is_carried;
  }
}

/// How far the turn of a group of three is off that of a rigid body, rad.
template <class S>
Exact turn_error(double time) {
  std::mt19937_64 random(7);
  WeldRig<FreeScene<S, 3>> rig;
  for (int i = 0; i < 3; ++i) rig.add(random_body<S>(random, 1, 3, 10));
  rig.begin(time);
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.bodies.weld(0, 2, rig.bodies.dt);
  const auto before = rig.all();
  rig.finish();
  const ExactMat made =
      rotation_of(rig.body(0).X_WB.q_WB) * rotation_of(before[0].X_WB.q_WB).transpose();
  return (made - free_turn(whole_of(before), time)).norm();
}

TYPED_TEST(Weld, TurnsAsARigidBodyDoes_ToTheSecondOrder) {
  const Exact at_40 = turn_error<TypeParam>(0.04), at_20 = turn_error<TypeParam>(0.02);
  EXPECT_LT(at_40, 1e-3L);
  if constexpr (std::is_same_v<TypeParam, double>) {
    EXPECT_GT(at_40, 1e-7L) << "or nothing is seen";
    EXPECT_NEAR(double(at_40 / at_20), 8, 1.5) << "an error of third order in each step";
  } else {
    EXPECT_LT(at_20, at_40 / 4 + 64 * u<TypeParam>);
  }
}

/// Bodies that turn as one, welded in each step. @param turn  in a step, rad  @param part  share of
/// a step after which they part
template <class S, int kBodies>
void expect_no_energy_won(double turn, double part) {
  constexpr double kStep = 0.01;
  constexpr int kSteps = 200;
  constexpr Exact kRounding = 512;  // of momenta that are summed and shared out again
  std::mt19937_64 random(static_cast<std::uint64_t>(1000 * turn) + kBodies);
  WeldRig<FreeScene<S, kBodies>> rig;
  const auto like = random_body<S>(random, 1, 0, turn / kStep);
  const Vec3<S> w_W = S(turn / kStep) * twist_of(like).w_W.normalized();
  for (int i = 0; i < kBodies; ++i) {
    auto body = random_body<S>(random, 1, 0, 0);
    body.momentum = momentum_of(body, Twist<S>{w_W.cross(body.X_WB.p_W), w_W});
    rig.add(body);
  }
  for (int i = 0; i < kSteps && !::testing::Test::HasFailure(); ++i) {
    rig.begin(kStep);
    for (std::size_t k = 1; k < kBodies; ++k) rig.bodies.weld(0, k, rig.bodies.dt);
    const Exact before = whole_of(rig.all()).energy;
    const Quat<S> placed = rig.body(0).X_WB.q_WB;
    rig.bodies.now = S(part) * rig.bodies.dt;
    rig.bodies.part_group(0);
    const Exact after = whole_of(rig.all()).energy;
    EXPECT_LE(after, before * (1 + kRounding * u<S>)) << turn << " rad, " << part << ", step " << i;
    EXPECT_GE(after, before * 0.5L) << turn << " rad, " << part << ", step " << i;
    if (turn < 0.5) {
      EXPECT_NE(rig.body(0).X_WB.q_WB.coeffs(), placed.coeffs()) << "kept by no turn at all";
    }
  }
}

// However far it turns, and whenever it parts: that the axis is the one of the middle of the time
// to first order alone let eight rods have 3.3 times their energy after a minute.
TYPED_TEST(Weld, ThatTurns_WinsNoEnergy) {
  for (const double turn : {1e-3, 0.01, 0.1, 0.33, 1.0, 3.0}) {
    for (const double part : {1.0, 0.999, 0.9, 0.5, 0.1}) {
      expect_no_energy_won<TypeParam, 2>(turn, part);
      expect_no_energy_won<TypeParam, 3>(turn, part);
      expect_no_energy_won<TypeParam, 8>(turn, part);
    }
  }
}

template <int kBodies>
constexpr SceneOptions parting_options() {
  SceneOptions scene = free_options<kBodies, false>();
  scene.resting = RestingContact::kSeparation;
  return scene;
}

/// Three that turn as one, `scale` times the mass. @returns what its turn is off a flight, as a
/// share of its energy, late in the step
template <class S>
S off_flight_of(double scale) {
  constexpr double kTurn = 0.3, kStep = 0.01;
  std::mt19937_64 random(7);
  WeldRig<Scene<parting_options<3>, Advancement<S>>> rig;
  const Vec3<S> w_W = S(kTurn / kStep) * Vec3<S>(S(1), S(2), S(-1)).normalized();
  for (int i = 0; i < 3; ++i) {
    auto body = random_body<S>(random, scale, 0, 0);
    body.momentum = momentum_of(body, Twist<S>{w_W.cross(body.X_WB.p_W), w_W});
    rig.add(body);
  }
  rig.begin(kStep);
  for (std::size_t k = 1; k < 3; ++k) rig.bodies.weld(0, k, rig.bodies.dt);
  return rig.bodies.group_off_flight(0, S(0.75 * kStep));
}

// Masses say nothing: the same bits, whether the energy is a megajoule or a millionth of a joule.
TYPED_TEST(Weld, OffItsFlight_IsAShareOfItsEnergy) {
  const TypeParam share = off_flight_of<TypeParam>(1);
  EXPECT_GT(std::abs(share), TypeParam(1e-5)) << "or nothing is seen";
  for (const double scale : {1048576.0, 1.0 / 1073741824.0}) {
    EXPECT_EQ(off_flight_of<TypeParam>(scale), share) << scale;
  }
}

// Two that fly past each other: their common turn would be more than half a one.
TYPED_TEST(Weld, OfHalfATurnOrMore_GoesOnWithoutATurn_AndKeepsItsSpin) {
  using S = TypeParam;
  std::mt19937_64 random(5);
  WeldRig<FreeScene<S, 2>> rig;
  for (int i = 0; i < 2; ++i) rig.add(random_body<S>(random, 1, 0, 0));
  const Vec3<S> apart = rig.body(1).X_WB.p_W - rig.body(0).X_WB.p_W;
  const Vec3<S> across = apart.cross(Vec3<S>(S(0.3), S(-0.5), S(0.8)));
  rig.body(0).momentum.linear_W = Vec3<S>(1, 2, 3) - S(100) * across;
  rig.body(1).momentum.linear_W = Vec3<S>(1, 2, 3) + S(100) * across;
  rig.begin(0.1);
  const auto before = rig.all();
  const Whole was = whole_of(before);
  ASSERT_GT(solve(was.inertia, was.spin).norm() * 0.1L, 3.2L);
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.finish();
  const auto after = rig.all();
  expect_one_rigid_body(before, after, Exact(rig.bodies.dt));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LE((after[i].X_WB.q_WB.coeffs() - before[i].X_WB.q_WB.coeffs()).norm(), S(4 * u<S>));
  }
}

// Below half a turn, but not by much: it turns.
TYPED_TEST(Weld, OfNearlyHalfATurn_Turns) {
  using S = TypeParam;
  WeldRig<FreeScene<S, 2>> rig;
  for (int i = 0; i < 2; ++i) {
    const S x = S(i == 0 ? -0.5 : 0.5);
    auto body = make_body<S>({Vec3<S>(x, 0, 0), Quat<S>::Identity()}, 1, Vec3<S>(1, 1, 1)).value;
    body.momentum.linear_W.y() = x * S(30);
    body.momentum.angular_W.z() = S(30);
    rig.add(body);
  }
  rig.begin(0.1);  // 30 rad/s: 3.0 rad
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.finish();
  EXPECT_NEAR(double(rig.body(1).X_WB.p_W.x()), 0.5 * std::cos(3.0), 1e-5);
  EXPECT_NEAR(double(rig.body(1).X_WB.p_W.y()), 0.5 * std::sin(3.0), 1e-5);
}

/// A body that does not turn about an axis, or is held in its place by an axle.
template <class S, class Change>
std::vector<Body<S>> weld_with(const Change& change) {
  std::mt19937_64 random(8);
  WeldRig<FreeScene<S, 2>> rig;
  for (int i = 0; i < 2; ++i) rig.add(random_body<S>(random, 1, 2, 10));
  change(rig.body(0));
  rig.begin(0.01);
  auto list = rig.all();
  rig.bodies.weld(0, 1, rig.bodies.dt);
  rig.finish();
  list.push_back(rig.body(0));
  list.push_back(rig.body(1));
  return list;  // before, and after
}

TYPED_TEST(Weld, WithABodyThatCannotTurn_GoesOnWithoutATurn) {
  using S = TypeParam;
  const auto list = weld_with<S>([](Body<S>& body) {
    body.inverse_moments.y() = 0;
    body.momentum.angular_W.setZero();
  });
  const Vec3<S> way = S(0.01 / 2) * (list[0].momentum.linear_W + list[1].momentum.linear_W);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LE((list[i + 2].X_WB.p_W - list[i].X_WB.p_W - way).norm(), S(8 * u<S>));
    EXPECT_LE(list[i + 2].momentum.angular_W.norm(), S(0));
  }
  const Vec3<S> gained = list[2].momentum.linear_W + list[3].momentum.linear_W -
                         (list[0].momentum.linear_W + list[1].momentum.linear_W);
  EXPECT_LE(gained.norm(), S(16 * u<S>));
}

TYPED_TEST(Weld, WithABodyOnAnAxle_Stands) {
  using S = TypeParam;
  const auto list = weld_with<S>([](Body<S>& body) {
    body.inverse_mass = 0;
    body.momentum.linear_W.setZero();
  });
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(list[i + 2].X_WB.p_W, list[i].X_WB.p_W);
    EXPECT_EQ(list[i + 2].X_WB.q_WB.coeffs(), list[i].X_WB.q_WB.coeffs());
  }
  EXPECT_EQ(list[2].momentum.angular_W, list[0].momentum.angular_W) << "it is its own";
  EXPECT_EQ(list[3].momentum.linear_W, Vec3<S>(Vec3<S>::Zero()));
}

// A speed beyond the numbers is no motion: it stands.
TYPED_TEST(Weld, WhoseMotionOverflows_Stands) {
  using S = TypeParam;
  const auto list = weld_with<S>([](Body<S>& body) {
    body.momentum.linear_W.setConstant(std::numeric_limits<S>::max() / 2);
    body.X_WB.p_W.setConstant(1);
  });
  for (std::size_t i = 2; i < 4; ++i) {
    EXPECT_TRUE(is_finite(list[i].X_WB.p_W));
    EXPECT_TRUE(is_finite(list[i].momentum.linear_W));
  }
}

}  // namespace
}  // namespace batuta
