// SPDX-License-Identifier: MIT
// What textbooks work out: a cradle, a rod that tips over an edge, the free symmetric top, and
// compounds that tumble against a post. Formulas stand beside their tests.
#include <gtest/gtest.h>

#include <random>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::LawScene;
using test::Rotation;
using test::Vector;

template <class S>
class Classics : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Classics, Scalars);

// Equal balls, C = 1: each blow hands the velocity on, so the last one leaves with all of it.
template <class SceneT>
void swing_cradle(double gap, double dt) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  for (int i = 0; i < 5; ++i) {
    auto ball = test::solid_ball<SceneT>(0.05, {(0.1 + gap) * i - (i == 0 ? 0.2 : 0), 0, 0});
    ball.restitution = S(1);
    if (i == 0) test::throw_body(ball, {1, 0, 0});
    ASSERT_TRUE(world->add(ball).ok());
  }
  const int count = static_cast<int>(std::lround(0.5 / dt));
  for (int i = 0; i < count; ++i) {
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    ASSERT_TRUE(world->report().complete()) << i;
  }
  for (std::uint16_t i = 0; i < 5; ++i) {
    const auto& body = std::as_const(*world).get(world->id_at(i))->body;
    const double v = static_cast<double>(body.inverse_mass * body.momentum.linear_W.x());
    EXPECT_NEAR(v, i == 4 ? 1 : 0, 0.01) << "ball " << i << ", gap " << gap << ", " << dt << " s";
  }
}

TYPED_TEST(Classics, CradleOfFive_LastBallTakesItAll) {
  for (const double gap : {1e-3, 1e-5, 0.0}) {
    for (const double dt : {1e-3, 1e-2, 1.0 / 60}) {
      swing_cradle<LawScene<TypeParam, RestingContact::kNone, test::kFloating>>(gap, dt);
      swing_cradle<LawScene<TypeParam, RestingContact::kSeparation, test::kFloating>>(gap, dt);
      swing_cradle<LawScene<TypeParam, RestingContact::kSettling, test::kFloating>>(gap, dt);
    }
  }
}

// A rod across an edge, its centre d beyond it and r above it, turns about the edge:
// w = m g d t / (I + m (d^2 + r^2)) as long as the angle, w t / 2, is small (0.05: its cosine and
// the way that the contact rolls change the lever by 0.3 %).
TYPED_TEST(Classics, RodOverAnEdge_TipsAsItsInertiaLetsIt) {
  using SceneT = LawScene<TypeParam, RestingContact::kSettling, test::kFalling>;
  constexpr double kBeyond = 0.2;
  constexpr double kRadius = 0.002;
  for (const double dt : {1e-4, 1e-3, 1e-2, 1.0 / 60}) {
    auto world = std::make_unique<World<SceneT>>();
    auto edge = test::fixed_rod<SceneT>(1, kRadius, {0, 0, 0}, test::along_y());
    edge.friction = TypeParam(0.9);
    (void)world->add(edge);
    auto rod =
        test::solid_rod<SceneT>(1, kRadius, {kBeyond, 0, 2 * kRadius + 5e-5}, test::along_x());
    rod.friction = TypeParam(0.9);
    const auto id = world->add(rod).value;
    const double mass = 1 / static_cast<double>(rod.body.inverse_mass);
    const double inertia = 1 / static_cast<double>(rod.body.inverse_moments.x());
    const double lever = kBeyond * kBeyond + kRadius * kRadius;
    const double rate = mass * 9.81 * kBeyond / (inertia + mass * lever);
    const int count = static_cast<int>(std::lround(std::sqrt(0.1 / rate) / dt));
    for (int i = 0; i < count; ++i) {
      ASSERT_EQ(world->step(static_cast<TypeParam>(dt)), Status::kOk);
      ASSERT_TRUE(world->report().complete()) << i;
    }
    const auto& body = std::as_const(*world).get(id)->body;
    const double w = static_cast<double>(body.momentum.angular_W.norm()) / inertia;
    EXPECT_NEAR(w, rate * count * dt, 0.01 * rate * count * dt) << dt;
  }
}

// q(t) = exp(t L / I) exp(t (1 / I_a - 1 / I) L_z z): precession about L, spin about its own axis.
TYPED_TEST(Classics, FreeSymmetricTop_PrecessesAsEulerSays) {
  using S = TypeParam;
  using SceneT = LawScene<S, RestingContact::kNone, test::kFloating>;
  constexpr int kSteps = 10000;
  for (const double own : {0.01, 0.5, 2.0}) {
    auto world = std::make_unique<World<SceneT>>();
    Actor<SceneT> top;
    top.capsule_B = {{{S(0.1), 0, 0}, {S(0.3), S(0.1), S(0.3)}}, S(0.01)};
    top.body = make_body<S>(Pose<S>{}, 1, {1, 1, static_cast<S>(own)}).value;
    const Vector w(20 * std::sin(0.3), 0, 20 * std::cos(0.3));
    top.body.momentum.angular_W = Vector(w.x(), 0, own * w.z()).template cast<S>();
    const Vector L = top.body.momentum.angular_W.template cast<double>();
    const auto id = world->add(top).value;
    for (int i = 0; i < kSteps; ++i) ASSERT_EQ(world->step(S(1e-3)), Status::kOk);
    const double time = kSteps * static_cast<double>(S(1e-3));
    const Rotation want = test::about(L.normalized(), L.norm() * time) *
                          test::about(Vector::UnitZ(), (1 / own - 1) * L.z() * time);
    const Rotation is =
        std::as_const(*world).get(id)->body.X_WB.q_WB.template cast<double>().normalized();
    const double rounding = 8 * static_cast<double>(kRoundOff<S>) * kSteps;
    EXPECT_LE(want.angularDistance(is), max_of(1e-9, rounding)) << own;
  }
}

// A compound of two bars tumbles into a post: whatever its moments, no motion is refused and all of
// every step is made, but where both bars wedge the post between them and there is no room to move
// one of them clear: then the two go on together, and it is told. @returns steps in which they did
template <class SceneT>
int tumble_at_post(double turn, unsigned seed) {
  using S = typename SceneT::Scalar;
  constexpr double kStep = 1e-2;
  std::mt19937 random(seed);
  const auto draw = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  const auto bar = [](const Vector& a, const Vector& b) {
    return CapsulePart<S>{{{a.cast<S>(), b.cast<S>()}, S(0.02)}, S(1000)};
  };
  auto world = std::make_unique<World<SceneT>>();
  int wedged = 0;
  const auto add = [&world](const auto& compound, bool is_fixed, const Vector& v, const Vector& w) {
    Actor<SceneT> actor;
    actor.body = compound.body;
    for (const auto& part : compound.capsules_B) (void)actor.capsules_B.push(part);
    actor.restitution = S(0.5);
    if (is_fixed) {
      actor.body.inverse_mass = 0;
      actor.body.inverse_moments.setZero();
    } else {
      test::throw_body(actor, v, w);
    }
    EXPECT_TRUE(world->add(actor).ok());
  };
  const double lean = draw(-0.2, 0.2);
  const Vector tip(draw(-0.3, 0.3), draw(0.1, 0.4), draw(-0.3, 0.3));
  const CapsulePart<S> bars[] = {bar({-0.3, 0, 0}, {0.3, lean, 0}), bar({0, 0, 0}, tip)};
  const CapsulePart<S> post[] = {bar({-0.7, -2, 0}, {-0.7, 2, 0})};
  const Vector axis = Vector(draw(-1, 1), draw(-1, 1), draw(-1, 1)).normalized();
  add(make_compound<3>(&bars[0], 2, Pose<S>{}).value, false, {-1, 0, 0}, (turn / kStep) * axis);
  add(make_compound<3>(&post[0], 1, Pose<S>{}).value, true, Vector::Zero(), Vector::Zero());
  for (int i = 0; i < 120; ++i) {
    const auto& report = world->report();
    EXPECT_EQ(world->step(static_cast<S>(kStep)), Status::kOk);
    EXPECT_EQ(report.plans_invalid, 0U) << seed << ", step " << i;
    EXPECT_TRUE(report.complete() || report.frozen > 0) << seed << ", step " << i;
    wedged += report.complete() ? 0 : 1;
    for (const auto& event : world->events()) {
      EXPECT_TRUE(event.v_rel <= S(0) || event.impulse == S(0)) << "who parts is not struck: " << i;
    }
  }
  return wedged;
}

TYPED_TEST(Classics, CompoundAtPost_MakesAllOfEveryStep) {
  using S = TypeParam;
  int wedged = 0;
  for (const double turn : {0.05, 0.2, 0.5, 1.0}) {
    for (unsigned seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE(::testing::Message() << turn << " rad a step");
      wedged += tumble_at_post<LawScene<S, RestingContact::kNone, test::kCompound>>(turn, seed);
      wedged +=
          tumble_at_post<LawScene<S, RestingContact::kSeparation, test::kCompound>>(turn, seed);
      EXPECT_EQ(
          (tumble_at_post<LawScene<S, RestingContact::kSettling, test::kCompound>>(turn, seed)), 0);
    }
  }
  EXPECT_LE(wedged, 4) << "of 96,000 steps";
}

}  // namespace
}  // namespace batuta
