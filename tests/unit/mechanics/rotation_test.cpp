// SPDX-License-Identifier: MIT
#include "batuta/mechanics/rotation.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"

namespace batuta {
namespace {

using samples::apart;
using samples::Real;
using samples::real;
using samples::relative_error;
using samples::Source;
using samples::true_exp;
using samples::u;

constexpr Real kPi = 3.14159265358979323846264338327950288L;

template <class Scalar>
class Rotation : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Rotation, Scalars);

template <class Scalar>
double unit_error(const Quat<Scalar>& q) {
  return std::fabs(static_cast<double>(real(q).norm() - 1));
}

template <class Scalar>
void expect_same_bits(const Quat<Scalar>& p, const Quat<Scalar>& q) {
  EXPECT_EQ(p.coeffs(), q.coeffs());
}

TYPED_TEST(Rotation, Renewed_IsUnitAndParallelAtAnyScale) {
  Source<TypeParam> source(1);
  using Limits = std::numeric_limits<TypeParam>;
  const double least = static_cast<double>(Limits::min());
  const double most = static_cast<double>(Limits::max());
  for (int i = 0; i < 20000; ++i) {
    const Quat<TypeParam> direction = source.rotation();
    const TypeParam scale = source.log_uniform(least * 1e6, most / 8);
    const Quat<TypeParam> q(direction.coeffs() * scale);
    EXPECT_LE(unit_error(renewed(q)), 4 * u<TypeParam>);
    EXPECT_LE(apart(renewed(q), real(q).normalized()), 4 * u<TypeParam>);
  }
}

TYPED_TEST(Rotation, RenewedOfSubnormals_IsUnit) {
  const TypeParam tiny = std::numeric_limits<TypeParam>::denorm_min();
  const Quat<TypeParam> q = renewed(Quat<TypeParam>(tiny, 0, tiny, 0));
  EXPECT_LE(unit_error(q), 4 * u<TypeParam>);
  EXPECT_EQ(q.w(), q.y());
}

TYPED_TEST(Rotation, RenewedOfWhatHasNoDirection_IsTheIdentity) {
  using Limits = std::numeric_limits<TypeParam>;
  expect_same_bits(renewed(Quat<TypeParam>(0, 0, 0, 0)), Quat<TypeParam>::Identity());
  for (const TypeParam bad : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
    expect_same_bits(renewed(Quat<TypeParam>(bad, 0, 1, 0)), Quat<TypeParam>::Identity());
    expect_same_bits(renewed(Quat<TypeParam>(1, 0, 0, bad)), Quat<TypeParam>::Identity());
  }
}

/// To within 1/512 of the squared length, whichever components it has.
TYPED_TEST(Rotation, IsTurn_AsksForTheLengthOfAllFour) {
  using Q = Quat<TypeParam>;
  const TypeParam half(0.5);
  for (const auto& q : {Q(half, half, half, half), Q(half, -half, half, -half), Q(1, 0, 0, 0),
                        Q(0, 1, 0, 0), Q(0, 0, 1, 0), Q(0, 0, 0, 1)}) {
    EXPECT_TRUE(detail::is_turn(q));
    for (const double square : {1.0 - 1.0 / 256, 1.0 + 1.0 / 256, 0.0, 2.0}) {
      const auto scale = static_cast<TypeParam>(std::sqrt(square));
      EXPECT_FALSE(detail::is_turn(Q(q.coeffs() * scale))) << square;
    }
    for (const double square : {1.0 - 1.0 / 1024, 1.0 + 1.0 / 1024}) {
      const auto scale = static_cast<TypeParam>(std::sqrt(square));
      EXPECT_TRUE(detail::is_turn(Q(q.coeffs() * scale))) << square;
    }
  }
  EXPECT_FALSE(detail::is_turn(Q(1, std::numeric_limits<TypeParam>::quiet_NaN(), 0, 0)));
}

TYPED_TEST(Rotation, MatrixOfQuaternion_TurnsAsTheQuaternionDoes) {
  Source<TypeParam> source(2);
  for (int i = 0; i < 10000; ++i) {
    const Quat<TypeParam> q = source.rotation();
    const Mat3<Real> truth = real(q).normalized().toRotationMatrix();
    // q is unit to 2 u, of which the matrix makes twice as much.
    EXPECT_LE((real(detail::to_matrix(q)) - truth).cwiseAbs().maxCoeff(), 12 * u<TypeParam>);
  }
}

TYPED_TEST(Rotation, QuaternionOfMatrix_GoesBack) {
  Source<TypeParam> source(3);
  for (int i = 0; i < 20000; ++i) {
    const Quat<TypeParam> q = source.rotation();
    const Quat<TypeParam> back = detail::to_quaternion(detail::to_matrix(q));
    EXPECT_LE(apart(back, real(q).normalized()), 8 * u<TypeParam>);
    EXPECT_GE(back.w(), TypeParam(0));
    EXPECT_LE(unit_error(back), 4 * u<TypeParam>);
  }
}

TYPED_TEST(Rotation, QuaternionOfHalfTurnMatrix_LosesNothing) {
  Source<TypeParam> source(4);
  for (int i = 0; i < 5000; ++i) {
    Vec3<TypeParam> axis = source.direction();
    if (i < 3) axis = Vec3<TypeParam>::Unit(i);
    const Real angle = kPi - static_cast<Real>(source.log_uniform(1e-12, 1e-1));
    const Quat<Real> truth = true_exp(Vec3<Real>(angle * real(axis).normalized()));
    const Mat3<TypeParam> R = truth.toRotationMatrix().template cast<TypeParam>();
    EXPECT_LE(apart(detail::to_quaternion(R), truth), 8 * u<TypeParam>);
  }
}

TYPED_TEST(Rotation, AxisAngle_AllWaysAgree) {
  Source<TypeParam> source(5);
  for (int i = 0; i < 10000; ++i) {
    const detail::AxisAngle<TypeParam> turn = {source.direction(), source.uniform(1e-3, 3.14)};
    const Vec3<Real> vector = static_cast<Real>(turn.angle) * real(turn.axis);
    EXPECT_LE(apart(detail::to_quaternion(turn), true_exp(vector)), 4 * u<TypeParam>);
    const Mat3<Real> R = true_exp(vector).toRotationMatrix();
    EXPECT_LE((real(detail::to_matrix(turn)) - R).cwiseAbs().maxCoeff(), 12 * u<TypeParam>);

    const detail::AxisAngle<TypeParam> back = detail::to_axis_angle(detail::to_quaternion(turn));
    EXPECT_NEAR(back.angle, turn.angle, 8 * u<TypeParam>);
    EXPECT_LE((back.axis - turn.axis).norm() * turn.angle, 12 * u<TypeParam>);
    const detail::AxisAngle<TypeParam> from_matrix = detail::to_axis_angle(detail::to_matrix(turn));
    EXPECT_NEAR(from_matrix.angle, turn.angle, 24 * u<TypeParam>);
  }
}

TYPED_TEST(Rotation, AxisAngleOfTheIdentity_IsZeroAboutX) {
  for (const TypeParam w : {TypeParam(1), TypeParam(-1)}) {
    const detail::AxisAngle<TypeParam> turn = detail::to_axis_angle(Quat<TypeParam>(w, 0, 0, 0));
    EXPECT_EQ(turn.angle, TypeParam(0));
    EXPECT_EQ(turn.axis, Vec3<TypeParam>::UnitX());
  }
}

TYPED_TEST(Rotation, NegativeAngleAndManyTurns_GiveTheSameRotation) {
  const Vec3<TypeParam> z = Vec3<TypeParam>::UnitZ();
  for (const TypeParam angle : {TypeParam(-1), TypeParam(5), TypeParam(100), TypeParam(-2000)}) {
    const Quat<Real> truth = true_exp(Vec3<Real>(0, 0, static_cast<Real>(angle)));
    const Quat<TypeParam> q = detail::to_quaternion(detail::AxisAngle<TypeParam>{z, angle});
    EXPECT_LE(apart(q, truth), 4 * u<TypeParam>);
    EXPECT_GE(q.w(), TypeParam(0));
    const TypeParam positive = detail::to_axis_angle(q).angle;
    EXPECT_GE(positive, TypeParam(0));
    EXPECT_LE(positive, static_cast<TypeParam>(kPi));
  }
}

TYPED_TEST(Rotation, ExpMap_IsTheRotationAndUnitAtEverySize) {
  Source<TypeParam> source(6);
  for (int i = 0; i < 30000; ++i) {
    const Vec3<TypeParam> r = source.log_uniform(1e-20, 40) * source.direction();
    const Quat<TypeParam> q = exp_map(r);
    // |r| is known to 2 u, so the half angle is known to |r| u.
    const double bound = (4 + 2 * static_cast<double>(r.norm())) * u<TypeParam>;
    EXPECT_LE(apart(q, true_exp(real(r))), bound);
    EXPECT_LE(unit_error(q), 6 * u<TypeParam>);
    if (r.norm() < TypeParam(1)) {
      EXPECT_LE(relative_error(Vec3<TypeParam>(q.vec()), Vec3<Real>(true_exp(real(r)).vec())),
                6 * u<TypeParam>);
    }
  }
}

TYPED_TEST(Rotation, LogOfExp_GivesBackEverySmallVectorToItsLastDigits) {
  Source<TypeParam> source(7);
  for (int i = 0; i < 30000; ++i) {
    const Vec3<TypeParam> r = source.log_uniform(1e-37, 1) * source.direction();
    EXPECT_LE(relative_error(log_map(exp_map(r)), real(r)), 12 * u<TypeParam>) << r.norm();
  }
}

TYPED_TEST(Rotation, LogAndExpOfVectorsOfSize1em8_AreExactToRounding) {
  const Vec3<TypeParam> r(TypeParam(3e-8), TypeParam(-1e-8), TypeParam(2e-8));
  const Quat<TypeParam> q = exp_map(r);
  EXPECT_NEAR(q.w(), 1, 4 * u<TypeParam>);
  EXPECT_LE(relative_error(Vec3<TypeParam>(2 * q.vec()), real(r)), 4 * u<TypeParam>);
  EXPECT_LE(relative_error(log_map(q), real(r)), 4 * u<TypeParam>);
  EXPECT_EQ(log_map(Quat<TypeParam>::Identity()), Vec3<TypeParam>(Vec3<TypeParam>::Zero()));
}

TYPED_TEST(Rotation, LogNearHalfTurn_LosesNothing) {
  Source<TypeParam> source(8);
  for (int i = 0; i < 20000; ++i) {
    const Real angle = kPi - static_cast<Real>(source.log_uniform(1e-10, 1));
    const Vec3<Real> r = angle * real(source.direction()).normalized();
    const Quat<TypeParam> q(true_exp(r).coeffs().template cast<TypeParam>());
    EXPECT_LE(relative_error(log_map(q), r), 8 * u<TypeParam>);
    EXPECT_LE(log_map(q).norm(), static_cast<TypeParam>(kPi) * (1 + 4 * kRoundOff<TypeParam>));
  }
}

TYPED_TEST(Rotation, LogOfMinusQ_IsLogOfQ) {
  Source<TypeParam> source(9);
  for (int i = 0; i < 1000; ++i) {
    const Quat<TypeParam> q = source.rotation();
    EXPECT_EQ(log_map(q), log_map(Quat<TypeParam>(-q.coeffs())));
  }
}

TYPED_TEST(Rotation, ExpOfOpposite_IsTheInverse) {
  Source<TypeParam> source(10);
  for (int i = 0; i < 1000; ++i) {
    const Vec3<TypeParam> r = source.vector(3);
    expect_same_bits(exp_map(Vec3<TypeParam>(-r)), exp_map(r).conjugate());
  }
}

TYPED_TEST(Rotation, Interpolated_IsExactAtBothEnds) {
  Source<TypeParam> source(11);
  for (int i = 0; i < 1000; ++i) {
    const Quat<TypeParam> q0 = source.rotation();
    const Quat<TypeParam> q1 = source.rotation();
    expect_same_bits(interpolated(q0, q1, TypeParam(0)), q0);
    expect_same_bits(interpolated(q0, q1, TypeParam(1)), q1);
    expect_same_bits(interpolated(q0, q0, TypeParam(0.5)), renewed(q0));
  }
}

TYPED_TEST(Rotation, Interpolated_TurnsSteadilyOnTheShortestWay) {
  Source<TypeParam> source(12);
  for (int i = 0; i < 5000; ++i) {
    const Quat<TypeParam> q0 = source.rotation();
    const Vec3<TypeParam> whole = source.uniform(0, 3) * source.direction();
    const Quat<Real> q1 = true_exp(real(whole)) * real(q0);
    Quat<TypeParam> end(q1.coeffs().template cast<TypeParam>());
    if (i % 2 == 1) end.coeffs() = -end.coeffs();
    const TypeParam t = source.uniform(0, 1);
    const Quat<Real> truth = true_exp(static_cast<Real>(t) * real(whole)) * real(q0);
    EXPECT_LE(apart(interpolated(q0, end, t), truth), 24 * u<TypeParam>);
  }
}

}  // namespace
}  // namespace batuta
