// SPDX-License-Identifier: MIT

#include "batuta/haptics/coupling.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "batuta/mechanics/motion.hpp"

namespace batuta {
using namespace haptics;
namespace {

using Frame = MovingFrame<double>;

Vec3<double> any_vector(double size) {
  const auto number = [size] { return size * (*rc::gen::inRange(-1000000, 1000001)) * 1e-6; };
  const double x = number();
  const double y = number();
  const double z = number();
  return {x, y, z};
}

Frame any_frame(double turn) {
  const Vec3<double> p = any_vector(0.3);
  const Quat<double> q = exp_map(any_vector(turn));
  const Vec3<double> v = any_vector(5);
  const Vec3<double> w = any_vector(20);
  return {{p, q}, {v, w}};
}

/// The coupling with limits that nothing here comes near.
CouplingSettings<double> unlimited() {
  CouplingSettings<double> settings;
  settings.max_force = 1e9;
  settings.max_moment = 1e9;
  return settings;
}

Frame after(const Frame& frame, double h) {
  return {pose_at(Motion<double>{frame.X_W, frame.twist, h}, h), frame.twist};
}

/// What the springs hold.
double potential(const CouplingSettings<double>& settings, const Frame& a, const Frame& b) {
  const double turn =
      batuta::detail::to_axis_angle(Quat<double>(b.X_W.q_WB * a.X_W.q_WB.conjugate())).angle;
  return (settings.stiffness * (b.X_W.p_W - a.X_W.p_W).squaredNorm() +
          settings.turn_stiffness * turn * turn) /
         2;
}

double power_of(const Wrench<double>& wrench, const Frame& frame) {
  return wrench.force_W.dot(frame.twist.v_W) + wrench.moment_W.dot(frame.twist.w_W);
}

/// Into both sides together.
double power_of_both(const CouplingSettings<double>& settings, const Frame& a, const Frame& b) {
  const Wrench<double> on_a = coupling_wrench(settings, a, b);
  const Wrench<double> on_b = moved<double>({-on_a.force_W, -on_a.moment_W}, a.X_W.p_W, b.X_W.p_W);
  return power_of(on_a, a) + power_of(on_b, b);
}

TEST(Coupling, StretchedAlongX_PullsTheHandToTheBlade) {
  Frame hand;
  Frame blade;
  blade.X_W.p_W.x() = 0.05;
  const auto wrench = coupling_wrench(CouplingSettings<double>{}, hand, blade);
  EXPECT_DOUBLE_EQ(wrench.force_W.x(), 20);  // 400 N/m
  EXPECT_EQ(wrench.force_W.y(), 0);
  EXPECT_EQ(wrench.moment_W.norm(), 0);
}

TEST(Coupling, TurnedAboutZ_TurnsTheHandAfterTheBlade) {
  Frame hand;
  Frame blade;
  blade.X_W.q_WB = exp_map(Vec3<double>(0, 0, 0.5));
  const auto wrench = coupling_wrench(CouplingSettings<double>{}, hand, blade);
  EXPECT_NEAR(wrench.moment_W.z(), 2, 1e-12);  // 4 N m/rad
  EXPECT_EQ(wrench.force_W.norm(), 0);
}

RC_GTEST_PROP(Coupling, Springs_GiveBackExactlyWhatTheyTook, ()) {
  auto settings = unlimited();
  settings.damping = 0;
  settings.turn_damping = 0;
  const Frame a = any_frame(0.6);
  const Frame b = any_frame(0.6);
  const double h = 1e-6;
  const double stored = potential(settings, after(a, h), after(b, h)) -
                        potential(settings, after(a, -h), after(b, -h));
  // Central difference: third order in h, with rates of a few hundred 1/s in the worst draw.
  RC_ASSERT(std::abs(power_of_both(settings, a, b) + stored / (2 * h)) < 1e-4);
}

RC_GTEST_PROP(Coupling, Dampers_OnlyTake, ()) {
  auto settings = unlimited();
  settings.stiffness = 0;
  settings.turn_stiffness = 0;
  const Frame a = any_frame(1);
  const Frame b = any_frame(1);
  const Vec3<double> v = velocity_at(b.X_W, b.twist, a.X_W.p_W) - a.twist.v_W;
  const double taken = settings.damping * v.squaredNorm() +
                       settings.turn_damping * (b.twist.w_W - a.twist.w_W).squaredNorm();
  RC_ASSERT(std::abs(power_of_both(settings, a, b) + taken) <= 1e-12 * (1 + taken));
}

RC_GTEST_PROP(Coupling, Limits_KeepTheDirection, ()) {
  const CouplingSettings<double> settings;
  const Frame a = any_frame(1.5);
  const Frame b = any_frame(1.5);
  const auto free = coupling_wrench(unlimited(), a, b);
  const auto kept = coupling_wrench(settings, a, b);
  RC_ASSERT(kept.force_W.norm() <= settings.max_force * (1 + 1e-14));
  RC_ASSERT(kept.moment_W.norm() <= settings.max_moment * (1 + 1e-14));
  RC_ASSERT(kept.force_W.cross(free.force_W).norm() <= 1e-9 * free.force_W.norm());
  RC_ASSERT(kept.force_W.norm() == free.force_W.norm() ||
            std::abs(kept.force_W.norm() - settings.max_force) < 1e-12);
}

RC_GTEST_PROP(Coupling, StoredEnergy_IsWhatTheLimitedSpringsTook, ()) {
  CouplingSettings<double> settings;
  settings.damping = 0;
  settings.turn_damping = 0;
  settings.max_force = 100;  // reached at 0.25 m
  settings.max_moment = 2;   // at 0.5 rad
  const Frame a = any_frame(0.6);
  const Frame b = any_frame(0.6);
  const double h = 1e-6;
  const double stored = stored_energy(settings, after(a, h).X_W, after(b, h).X_W) -
                        stored_energy(settings, after(a, -h).X_W, after(b, -h).X_W);
  // Second order in h where the limit is passed within it: half the change of slope, k v^2 h.
  RC_ASSERT(std::abs(power_of_both(settings, a, b) + stored / (2 * h)) < 0.2);
}

TEST(Coupling, StoredEnergy_IsThatOfTheTextbook) {
  CouplingSettings<double> settings;
  Pose<double> actual;
  actual.p_W.y() = 0.1;
  EXPECT_DOUBLE_EQ(stored_energy(settings, Pose<double>(), actual), 400 * 0.01 / 2);
  actual.p_W.y() = 1.15;  // the limit is reached at 0.15 m, with 4.5 J
  EXPECT_DOUBLE_EQ(stored_energy(settings, Pose<double>(), actual), 4.5 + 60);
  settings.stiffness = 0;
  EXPECT_EQ(stored_energy(settings, Pose<double>(), actual), 0);
}

TEST(Coupling, NotFinite_PullsNothing) {
  Frame hand;
  Frame blade;
  blade.X_W.p_W.x() = std::numeric_limits<double>::quiet_NaN();
  const auto wrench = coupling_wrench(CouplingSettings<double>{}, hand, blade);
  EXPECT_EQ(wrench.force_W, Vec3<double>::Zero());
  EXPECT_EQ(wrench.moment_W, Vec3<double>::Zero());
  Body<double> body = make_body({}, 1.0, Vec3<double>(1, 1, 1)).value;
  EXPECT_EQ(couple(CouplingSettings<double>{}, blade, body, 1e-3).status, Status::kInvalidArgument);
  EXPECT_EQ(body.momentum.linear_W, Vec3<double>::Zero());
}

TEST(Coupling, SettingsOutOfRange_AreRefused) {
  const auto refuses = [](auto change) {
    CouplingSettings<float> settings;
    change(settings);
    return validate(settings) == Status::kInvalidArgument;
  };
  EXPECT_EQ(validate(CouplingSettings<float>{}), Status::kOk);
  EXPECT_TRUE(refuses([](auto& s) { s.stiffness = -1; }));
  EXPECT_TRUE(refuses([](auto& s) { s.damping = -1; }));
  EXPECT_TRUE(refuses([](auto& s) { s.turn_stiffness = INFINITY; }));
  EXPECT_TRUE(refuses([](auto& s) { s.turn_damping = NAN; }));
  EXPECT_TRUE(refuses([](auto& s) { s.max_force = 0; }));
  EXPECT_TRUE(refuses([](auto& s) { s.max_moment = 0; }));
}

/// Energy of a body on its spring.
double energy(const CouplingSettings<double>& settings, const Frame& hand,
              const Body<double>& body) {
  return kinetic_energy(body) + potential(settings, {body.X_WB, {}}, hand);
}

RC_GTEST_PROP(CoupledBody, HeldByAStillHand_NeverGainsEnergy, ()) {
  auto settings = unlimited();
  const auto power_of_ten = [](int low, int high) {
    return std::pow(10.0, *rc::gen::inRange(low, high + 1));
  };
  settings.stiffness = power_of_ten(-2, 9);
  settings.damping = *rc::gen::element(0, 1) * power_of_ten(-3, 6);
  settings.turn_stiffness = 0;
  settings.turn_damping = 0;
  const double mass = power_of_ten(-6, 6);
  const double dt = power_of_ten(-5, 0);
  Body<double> body =
      make_body({any_vector(1), Quat<double>::Identity()}, mass, Vec3<double>(1, 1, 1)).value;
  body.momentum.linear_W = mass * any_vector(3);
  const Frame hand;
  double before = energy(settings, hand, body);
  for (int i = 0; i < 200; ++i) {
    RC_ASSERT(couple(settings, hand, body, dt).ok());
    body.X_WB = pose_at(free_flight(body, dt), dt);
    const double now = energy(settings, hand, body);
    RC_ASSERT(now <= before * (1 + 1e-12));
    before = now;
  }
}

TEST(CoupledBody, TurnedAgainstAStillHand_NeverGainsEnergy) {
  for (const double stiffness : {0.1, 10.0, 1e6}) {
    auto settings = unlimited();
    settings.stiffness = 0;
    settings.damping = 0;
    settings.turn_stiffness = stiffness;
    settings.turn_damping = 0;
    Body<double> body = make_body({Vec3<double>::Zero(), exp_map(Vec3<double>(0.3, -0.5, 1))}, 1.0,
                                  Vec3<double>(1e-3, 1e-3, 1e-3))
                            .value;
    const Frame hand;
    double before = energy(settings, hand, body);
    for (int i = 0; i < 2000; ++i) {
      ASSERT_TRUE(couple(settings, hand, body, 1e-3).ok());
      body.X_WB = pose_at(free_flight(body, 1e-3), 1e-3);
      const double now = energy(settings, hand, body);
      EXPECT_LE(now, before * (1 + 1e-12)) << stiffness << " step " << i;
      before = now;
    }
  }
}

/// The definition of an implicit step, also where a limit holds: the pull is that of the limited
/// spring and damper at the end of the step.
RC_GTEST_PROP(CoupledBody, Pull_IsThatOfTheLimitedSpringAtTheEnd, ()) {
  const auto power_of_ten = [](int low, int high) {
    return std::pow(10.0, *rc::gen::inRange(low, high + 1));
  };
  CouplingSettings<double> settings;
  settings.turn_stiffness = power_of_ten(-1, 4);
  settings.turn_damping = *rc::gen::element(0, 1) * power_of_ten(-3, 1);
  settings.max_moment = power_of_ten(-3, 3);
  const double dt = 1e-3;
  const Vec3<double> turn = any_vector(1);
  const Vec3<double> moments(power_of_ten(-6, 0), power_of_ten(-6, 0), power_of_ten(-6, 0));
  Body<double> body = make_body({Vec3<double>::Zero(), exp_map(turn)}, 1.0, moments).value;
  body.momentum.angular_W = any_vector(1e-2);
  const auto felt = couple(settings, Frame{}, body, dt);
  RC_ASSERT(felt.ok());
  const Vec3<double> w = twist_of(body).w_W;
  const Vec3<double> spring = settings.turn_stiffness * (-turn - dt * w);
  const Vec3<double> pull = spring - settings.turn_damping * w;
  const Vec3<double> limited = pull * std::min(1.0, settings.max_moment / pull.norm());
  // What cancels at the end of the step was this large at its start.
  const double size = settings.turn_stiffness * (turn.norm() + dt * w.norm());
  RC_ASSERT((felt.value.moment_W + limited).norm() <= 1e-6 * limited.norm() + 1e-12 * size);
}

/// F_i = r_i / (a + c_i) after so many steps of Newton's method on 1 / |F(a)|, from a = 1
/// (coupling.md), as a direction.
Vec3<double> eased_direction(const Vec3<double>& r, const Vec3<double>& c, double limit,
                             int steps) {
  using Real = long double;
  const auto F = [&](Real a) {
    return Vec3<Real>(static_cast<Real>(r.x()) / (a + static_cast<Real>(c.x())),
                      static_cast<Real>(r.y()) / (a + static_cast<Real>(c.y())),
                      static_cast<Real>(r.z()) / (a + static_cast<Real>(c.z())));
  };
  Real a = 1;
  for (int i = 0; i < steps; ++i) {
    const Real size = F(a).norm();
    Real slope = 0;  // of 1 / |F|
    for (int k = 0; k < 3; ++k) {
      slope += F(a)(k) * F(a)(k) / (a + static_cast<Real>(c(k))) / (size * size * size);
    }
    a += (1 / static_cast<Real>(limit) - 1 / size) / slope;
  }
  return F(a).normalized().cast<double>();
}

/// Axes that differ by twenty powers of ten are not eased when the bound of the loop is reached:
/// what is left is cut, and costs no thirteenth round.
TEST(CoupledBody, NotEasedInTwelveRounds_IsCut) {
  struct Stiff {
    Vec3<double> rigid, gives;
    double limit;
  };
  for (const Stiff& stiff : {Stiff{{1e-2, 1e8, 1e-8}, {1e7, 1e17, 1}, 1e-9},
                             Stiff{{1e10, 1e-2, 1e4}, {1e13, 1, 1e8}, 1e-3},
                             Stiff{{1e-3, 1e4, 1e10}, {1e-1, 1e13, 1e18}, 1e-8}}) {
    CouplingSettings<double> settings;
    settings.turn_stiffness = 0;
    settings.turn_damping = 1;
    settings.max_moment = stiff.limit;
    Body<double> body;
    body.inverse_mass = 1;
    body.inverse_moments = stiff.gives;  // of a damper of 1 N m s/rad in a step of 1 s
    Frame hand;
    hand.twist.w_W = stiff.rigid;
    const auto felt = couple(settings, hand, body, 1.0);
    ASSERT_TRUE(felt.ok());
    const Vec3<double> pull = -felt.value.moment_W / stiff.limit;
    const auto after = [&](int rounds) {
      return eased_direction(stiff.rigid, stiff.gives, stiff.limit, rounds);
    };
    EXPECT_LT((pull - after(12)).norm(), 1e-9);
    EXPECT_GT((after(12) - after(13)).norm(), 1e-3) << "eased before";
  }
}

TEST(CoupledBody, BothSides_TakeTheSameImpulse) {
  Body<double> body = make_body({}, 0.5, Vec3<double>(1e-3, 2e-3, 3e-3)).value;
  Frame hand{{{0.02, -0.01, 0.03}, exp_map(Vec3<double>(0.1, 0.2, -0.3))}, {{1, 2, 3}, {4, 5, 6}}};
  const auto felt = couple(CouplingSettings<double>{}, hand, body, 1e-3);
  ASSERT_TRUE(felt.ok());
  EXPECT_LT((body.momentum.linear_W + 1e-3 * felt.value.force_W).norm(), 1e-18);
  EXPECT_LT((body.momentum.angular_W + 1e-3 * felt.value.moment_W).norm(), 1e-18);
  EXPECT_GT(felt.value.force_W.norm(), 1);
  EXPECT_GT(felt.value.moment_W.norm(), 0.1);
}

TEST(CoupledBody, Fixed_IsFeltAndDoesNotMove) {
  const double infinite = std::numeric_limits<double>::infinity();
  Body<double> body = make_body({}, infinite, Vec3<double>(infinite, infinite, infinite)).value;
  Frame hand;
  hand.X_W.p_W.x() = 0.1;
  const auto felt = couple(CouplingSettings<double>{}, hand, body, 1e-3);
  ASSERT_TRUE(felt.ok());
  EXPECT_DOUBLE_EQ(felt.value.force_W.x(), -40);
  EXPECT_EQ(body.momentum.linear_W, Vec3<double>::Zero());
}

TEST(CoupledBody, StepOfNoLength_IsRefused) {
  Body<float> body = make_body({}, 1.0F, Vec3<float>(1, 1, 1)).value;
  for (const float dt : {0.0F, -1.0F, NAN, INFINITY}) {
    EXPECT_EQ(couple(CouplingSettings<float>{}, MovingFrame<float>{}, body, dt).status,
              Status::kInvalidArgument);
  }
}

}  // namespace
}  // namespace batuta
