// SPDX-License-Identifier: MIT
#include "batuta/mechanics/motion.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"

namespace batuta {
namespace {

using samples::apart;
using samples::Real;
using samples::real;
using samples::Source;
using samples::true_exp;
using samples::u;

template <class Scalar>
class MotionOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MotionOf, Scalars);

template <class Scalar>
Pose<Scalar> random_pose(Source<Scalar>& source, double size) {
  const Vec3<Scalar> p = source.vector(size);
  return {p, source.rotation()};
}

template <class Scalar>
void expect_same_bits(const Pose<Scalar>& X, const Pose<Scalar>& Y) {
  EXPECT_EQ(X.p_W, Y.p_W);
  EXPECT_EQ(X.q_WB.coeffs(), Y.q_WB.coeffs());
}

/// Torque-free rotation by Euler's equations: q' = w q / 2 with w = R J^-1 R^T b, b constant;
/// classical Runge-Kutta in long double. It knows nothing of symmetry.
Quat<Real> integrated(Quat<Real> q, const Vec3<Real>& angular_W, const Vec3<Real>& inverse_moments,
                      Real duration, int steps) {
  using Coefficients = Eigen::Matrix<Real, 4, 1>;
  const auto rate = [&](const Coefficients& c) {
    const Quat<Real> unit = Quat<Real>(c).normalized();
    const Vec3<Real> b_B = unit.conjugate() * angular_W;
    const Vec3<Real> w_W = unit * Vec3<Real>(inverse_moments.cwiseProduct(b_B));
    return Coefficients((Quat<Real>(0, w_W.x(), w_W.y(), w_W.z()) * unit).coeffs() / 2);
  };
  const Real h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Coefficients c = q.coeffs();
    const Coefficients k1 = rate(c);
    const Coefficients k2 = rate(c + h / 2 * k1);
    const Coefficients k3 = rate(c + h / 2 * k2);
    const Coefficients k4 = rate(c + h * k3);
    q = Quat<Real>(Coefficients(c + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))).normalized();
  }
  return q;
}

TYPED_TEST(MotionOf, PoseAtZero_IsThePoseToTheLastBit) {
  Source<TypeParam> source(1);
  for (int i = 0; i < 1000; ++i) {
    const Pose<TypeParam> X = random_pose(source, 5);
    const Twist<TypeParam> twist = {source.vector(10), source.vector(10)};
    expect_same_bits(pose_at(Motion<TypeParam>{X, twist, 1}, TypeParam(0)), X);
    expect_same_bits(pose_at(still(X, TypeParam(1)), TypeParam(0.7)), X);
  }
}

TYPED_TEST(MotionOf, LinearMotion_KeepsTheOrientationToTheLastBit) {
  Source<TypeParam> source(2);
  const Pose<TypeParam> X = random_pose(source, 1);
  const Vec3<TypeParam> v(1, -2, 4);
  const Pose<TypeParam> Y = pose_at(linear(X, v, TypeParam(1)), TypeParam(0.5));
  EXPECT_EQ(Y.p_W, Vec3<TypeParam>(X.p_W + v / 2));
  EXPECT_EQ(Y.q_WB.coeffs(), X.q_WB.coeffs());
}

TYPED_TEST(MotionOf, PoseAt_IsTheConstantTwist) {
  Source<TypeParam> source(3);
  for (int i = 0; i < 20000; ++i) {
    const Pose<TypeParam> X = random_pose(source, 5);
    const Twist<TypeParam> twist = {source.vector(10),
                                    source.log_uniform(1e-9, 60) * source.direction()};
    const TypeParam t = source.uniform(0, 1);
    const Pose<TypeParam> Y = pose_at(Motion<TypeParam>{X, twist, 1}, t);
    const double turn = static_cast<double>(t * twist.w_W.norm());
    const Quat<Real> q =
        true_exp(Vec3<Real>(static_cast<Real>(t) * real(twist.w_W))) * real(X.q_WB).normalized();
    EXPECT_LE(apart(Y.q_WB, q), (12 + 2 * turn) * u<TypeParam>);
    EXPECT_NEAR(static_cast<double>(real(Y.q_WB).norm()), 1, 4 * u<TypeParam>);
    const Vec3<Real> p = real(X.p_W) + static_cast<Real>(t) * real(twist.v_W);
    EXPECT_LE((real(Y.p_W) - p).norm(), 40 * u<TypeParam>);
  }
}

TYPED_TEST(MotionOf, MillionsOfSteps_StayUnitRotations) {
  Motion<TypeParam> motion;
  motion.twist.w_W = {TypeParam(0.3), TypeParam(-0.2), TypeParam(0.9)};
  motion.duration = TypeParam(1e-3);
  for (int i = 0; i < 1000000; ++i) motion.X_WB = pose_at(motion, motion.duration);
  EXPECT_NEAR(static_cast<double>(real(motion.X_WB.q_WB).norm()), 1, 4 * u<TypeParam>);
}

TYPED_TEST(MotionOf, MotionBetween_ArrivesAtTheSecondPose) {
  Source<TypeParam> source(4);
  for (int i = 0; i < 20000; ++i) {
    const Pose<TypeParam> X0 = random_pose(source, 3);
    const Pose<TypeParam> X1 = random_pose(source, 3);
    const TypeParam duration = source.log_uniform(1e-4, 10);
    const Motion<TypeParam> motion = motion_between(X0, X1, duration);
    EXPECT_TRUE(is_valid(motion));
    const Pose<TypeParam> end = pose_at(motion, duration);
    EXPECT_LE((end.p_W - X1.p_W).cwiseAbs().maxCoeff(), 16 * u<TypeParam>);
    EXPECT_LE(apart(end.q_WB, real(X1.q_WB).normalized()), 24 * u<TypeParam>);
    EXPECT_LE(motion.twist.w_W.norm() * duration, TypeParam(3.1416));
  }
}

TYPED_TEST(MotionOf, MotionBetweenTheSamePose_StandsStill) {
  Source<TypeParam> source(5);
  const Pose<TypeParam> X = random_pose(source, 3);
  Pose<TypeParam> minus = X;
  minus.q_WB.coeffs() = -X.q_WB.coeffs();
  for (const auto& motion :
       {motion_between(X, X, TypeParam(1)), motion_between(X, minus, TypeParam(1))}) {
    EXPECT_EQ(motion.twist.v_W, Vec3<TypeParam>(Vec3<TypeParam>::Zero()));
    EXPECT_LE(motion.twist.w_W.norm(), 8 * u<TypeParam>);
  }
}

TYPED_TEST(MotionOf, MotionBetweenInNoTime_IsTheCallersMistake) {
  const Pose<TypeParam> X;
  EXPECT_DEATH((void)motion_between(X, X, TypeParam(0)), "");
}

/// A body of revolution about its axis `odd` with a random pose, momentum and transverse moment 1.
template <class Scalar>
Body<Scalar> random_top(Source<Scalar>& source, int odd, Scalar axial) {
  Vec3<Scalar> moments = Vec3<Scalar>::Ones();
  moments(odd) = axial;
  const Pose<Scalar> X = random_pose(source, 1);
  Body<Scalar> body = make_body(X, Scalar(1), moments).value;
  body.momentum = {source.vector(1), source.uniform(0.5, 6) * source.direction()};
  return body;
}

TYPED_TEST(MotionOf, FreeFlightOfATop_MovesItsAxisAsEulersEquationsDo) {
  Source<TypeParam> source(6);
  for (const double axial : {0.1, 0.4, 1.0, 1.9}) {
    for (int odd = 0; odd < 3; ++odd) {
      const auto top = random_top(source, odd, static_cast<TypeParam>(axial));
      const Motion<TypeParam> flight = free_flight(top, TypeParam(1));
      const Vec3<Real> axis_B = Vec3<Real>::Unit(odd);
      const Quat<Real> q =
          integrated(real(top.X_WB.q_WB).normalized(), real(top.momentum.angular_W),
                     real(top.inverse_moments), 1, 40000);
      const Vec3<Real> truth = q * axis_B;
      const Vec3<Real> found = real(pose_at(flight, TypeParam(1)).q_WB).normalized() * axis_B;
      EXPECT_LE((found - truth).norm(), 64 * u<TypeParam> + 1e-13) << axial << " about " << odd;
      EXPECT_EQ(flight.twist.v_W, twist_of(top).v_W);
    }
  }
}

TYPED_TEST(MotionOf, FreeFlightOfATop_DoesNotDependOnHowItIsCut) {
  Source<TypeParam> source(7);
  Body<TypeParam> top = random_top(source, 0, TypeParam(0.01));
  const Body<TypeParam> start = top;
  constexpr int kPieces = 64;
  const TypeParam piece = TypeParam(1) / kPieces;
  for (int i = 0; i < kPieces; ++i) top.X_WB = pose_at(free_flight(top, piece), piece);
  const Pose<TypeParam> whole = pose_at(free_flight(start, TypeParam(1)), TypeParam(1));
  const Vec3<TypeParam> axis = Vec3<TypeParam>::UnitX();
  EXPECT_LE((top.X_WB.q_WB * axis - whole.q_WB * axis).norm(), 8 * kPieces * u<TypeParam>);
}

TYPED_TEST(MotionOf, FreeFlightOfATop_KeepsItsEnergy) {
  Source<TypeParam> source(8);
  for (int i = 0; i < 1000; ++i) {
    Body<TypeParam> top = random_top(source, i % 3, source.uniform(0.1, 1.9));
    const double before = static_cast<double>(kinetic_energy(top));
    top.X_WB = pose_at(free_flight(top, TypeParam(1)), TypeParam(1));
    EXPECT_NEAR(static_cast<double>(kinetic_energy(top)), before, 400 * u<TypeParam> * before);
  }
}

TYPED_TEST(MotionOf, FreeFlightOfANearlyRoundBody_CountsAsATopOnlyWithinRounding) {
  const Vec3<TypeParam> moments(TypeParam(0.1), 1, 1);
  Body<TypeParam> body = make_body<TypeParam>({}, 1, moments).value;
  body.momentum.angular_W = {1, 2, 3};
  const auto turns_about_b = [&] {
    return free_flight(body, TypeParam(0.01)).twist.w_W.cross(body.momentum.angular_W).norm() <
           1e-5;
  };
  EXPECT_TRUE(turns_about_b());
  body.inverse_moments(2) = 1 + 30 * kRoundOff<TypeParam>;
  EXPECT_TRUE(turns_about_b());
  body.inverse_moments(2) = 1 - 30 * kRoundOff<TypeParam>;
  EXPECT_TRUE(turns_about_b());
  body.inverse_moments(2) = 1 + 36 * kRoundOff<TypeParam>;
  EXPECT_FALSE(turns_about_b());
}

/// Largest relative change of the energy over many steps of free flight.
template <class Scalar>
double energy_drift(Body<Scalar> body, Scalar step, int steps) {
  const auto before = static_cast<double>(kinetic_energy(body));
  double worst = 0;
  for (int i = 0; i < steps; ++i) {
    body.X_WB = pose_at(free_flight(body, step), step);
    worst = std::max(worst, std::abs(static_cast<double>(kinetic_energy(body)) / before - 1));
  }
  return worst;
}

TYPED_TEST(MotionOf, FreeFlightOfOtherBodies_KeepsItsEnergy) {
  const auto step = static_cast<TypeParam>(1e-3);
  for (const double ratio : {1.0 + 1e-4, 1.5, 3.0}) {
    const Vec3<TypeParam> moments(TypeParam(0.2), 1, static_cast<TypeParam>(ratio));
    Body<TypeParam> body = make_body<TypeParam>({}, 1, moments).value;
    body.momentum.angular_W = {TypeParam(0.6), 2, 3};
    EXPECT_LT(energy_drift(body, step, 10000), 2e-4) << "ratio " << ratio;
  }
}

TEST(Motion, FreeFlightOfOtherBodies_ErrsByTheFifthPowerOfTheStep) {
  // An error of the model, not of rounding: halving the step leaves a 32nd of the error of one
  // step, of fourth order after all of them.
  Body<double> body = make_body<double>({}, 1, {1, 2, 3}).value;
  body.momentum.angular_W = {1, 2, -1};
  double errors[2] = {};
  for (int i = 0; i < 2; ++i) {
    const double step = i == 0 ? 0.1 : 0.05;
    const Quat<Real> q = integrated(Quat<Real>::Identity(), real(body.momentum.angular_W),
                                    real(body.inverse_moments), static_cast<Real>(step), 2000);
    errors[i] = apart(pose_at(free_flight(body, step), step).q_WB, q);
  }
  EXPECT_GT(errors[0] / errors[1], 26);
  EXPECT_LT(errors[0] / errors[1], 38);
}

// With the spin shown, the whole orientation of a top, not only its axis, is that of Euler's
// equations.
TYPED_TEST(MotionOf, FreeFlightOfATopWhoseSpinShows_IsExact) {
  Body<TypeParam> top = make_body<TypeParam>({}, 1, {TypeParam(0.5), 2, 2}).value;
  top.momentum.angular_W = {TypeParam(0.6), 1, -1};
  top.spin_shows = true;
  const auto step = static_cast<TypeParam>(0.5);
  const Quat<Real> q = integrated(Quat<Real>::Identity(), real(top.momentum.angular_W),
                                  real(top.inverse_moments), static_cast<Real>(step), 4000);
  EXPECT_LE(apart(pose_at(free_flight(top, step), step).q_WB, q), 64 * u<TypeParam> + 1e-13);
  top.spin_shows = false;
  EXPECT_GT(apart(pose_at(free_flight(top, step), step).q_WB, q), 0.1)
      << "it is the spin that was left out";
}

TYPED_TEST(MotionOf, FreeFlightOfHalfATurnInAStep_IsNotValid) {
  Body<TypeParam> body = make_body<TypeParam>({}, 1, {1, 2, 3}).value;
  body.momentum.angular_W = {0, 0, TypeParam(3)};  // 1 rad/s
  EXPECT_TRUE(is_valid(free_flight(body, TypeParam(3.1))));
  EXPECT_FALSE(is_valid(free_flight(body, TypeParam(3.2))));
}

// As many turns as no sine is there for.
TYPED_TEST(MotionOf, FreeFlightOfAnyFiniteSpin_IsAnAnswer) {
  using Limits = std::numeric_limits<TypeParam>;
  Body<TypeParam> body = make_body<TypeParam>({}, 1, {1, 2, 3}).value;
  Body<TypeParam> top = make_body<TypeParam>({}, 1, {1, 2, 2}).value;
  top.spin_shows = true;
  for (const TypeParam spin : {TypeParam(1e4), TypeParam(1e18), Limits::max()}) {
    for (int axis = 0; axis < 3; ++axis) {
      body.momentum.angular_W = top.momentum.angular_W = spin * Vec3<TypeParam>::Unit(axis);
      EXPECT_FALSE(is_valid(free_flight(body, TypeParam(1)))) << spin;
      EXPECT_FALSE(is_valid(free_flight(top, TypeParam(1)))) << spin;
    }
  }
}

TYPED_TEST(MotionOf, FreeFlightOfWhatTurnsAboutOneAxisOnly_KeepsTurning) {
  Body<TypeParam> wheel;
  wheel.inverse_mass = 1;
  wheel.inverse_moments = {0, 0, TypeParam(0.5)};
  wheel.momentum.angular_W = {1, 2, 3};
  EXPECT_EQ(free_flight(wheel, TypeParam(1)).twist.w_W, Vec3<TypeParam>(0, 0, TypeParam(1.5)));
  const Body<TypeParam> wall;
  EXPECT_EQ(free_flight(wall, TypeParam(1)).twist.w_W, Vec3<TypeParam>(0, 0, 0));
}

TYPED_TEST(MotionOf, IsValid_RefusesWhatIsNotFiniteOrTurnsTooFar) {
  using Limits = std::numeric_limits<TypeParam>;
  Motion<TypeParam> good;
  good.duration = 1;
  good.twist.w_W = {0, 0, detail::kMaxAngle<TypeParam>};
  EXPECT_TRUE(is_valid(good));
  EXPECT_EQ(pose_at(good, good.duration).p_W, good.X_WB.p_W);
  for (const TypeParam bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (int field = 0; field < 5; ++field) {
      Motion<TypeParam> motion = good;
      if (field == 0) motion.X_WB.p_W.x() = bad;
      if (field == 1) motion.X_WB.q_WB.w() = bad;
      if (field == 2) motion.twist.v_W.y() = bad;
      if (field == 3) motion.twist.w_W.z() = bad;
      if (field == 4) motion.duration = bad;
      EXPECT_FALSE(is_valid(motion)) << field;
    }
  }
  Motion<TypeParam> motion = good;
  motion.duration = -1;
  EXPECT_FALSE(is_valid(motion));
  motion.duration = TypeParam(1.01);
  EXPECT_FALSE(is_valid(motion));
  motion.twist.w_W.z() = Limits::max();
  EXPECT_FALSE(is_valid(motion)) << "the square overflows";
  motion.duration = 0;
  EXPECT_TRUE(is_valid(motion)) << "no time, no turn";
}

TYPED_TEST(MotionOf, HidesSpin_OnlyOfCapsulesOnTheOddAxisOfAnAxisymmetricBody) {
  using S = TypeParam;
  const Capsule<S> along_x{{Vec3<S>(-1, 0, 0), Vec3<S>(2, 0, 0)}, S(0.1)};
  const Capsule<S> along_z{{Vec3<S>(0, 0, -1), Vec3<S>(0, 0, 2)}, S(0.1)};
  const Capsule<S> beside{{Vec3<S>(-1, S(0.001), 0), Vec3<S>(2, 0, 0)}, S(0.1)};
  Body<S> body;
  body.inverse_moments = Vec3<S>(8, 1, 1);
  EXPECT_TRUE(detail::hides_spin(body, along_x));
  EXPECT_FALSE(detail::hides_spin(body, along_z));
  EXPECT_FALSE(detail::hides_spin(body, beside));
  body.inverse_moments = Vec3<S>(4, 4, 1);
  EXPECT_TRUE(detail::hides_spin(body, along_z));
  EXPECT_FALSE(detail::hides_spin(body, along_x));
  body.inverse_moments = Vec3<S>(4, 1, 4);
  EXPECT_FALSE(detail::hides_spin(body, along_x));
  body.inverse_moments = Vec3<S>(3, 2, 1);
  EXPECT_FALSE(detail::hides_spin(body, along_x));
  body.inverse_moments = Vec3<S>(0, 0, 1);
  EXPECT_FALSE(detail::hides_spin(body, along_z));
}

}  // namespace
}  // namespace batuta
