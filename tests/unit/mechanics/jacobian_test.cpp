// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>

#include "batuta/mechanics/rotation.hpp"
#include "samples.hpp"

namespace batuta {
namespace {

using samples::Real;
using samples::real;
using samples::Source;
using samples::true_exp;
using samples::u;

template <class Scalar>
class LeftJacobian : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LeftJacobian, Scalars);

/// The sum of [r]x^k / (k + 1)!, which is the integral of exp(s r) over s in [0, 1]: no sine, no
/// cosine.
Mat3<Real> true_jacobian(const Vec3<Real>& r) {
  Mat3<Real> M;
  M << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  Mat3<Real> sum = Mat3<Real>::Identity();
  Mat3<Real> term = Mat3<Real>::Identity();
  for (int k = 1; k < 60; ++k) {
    term = Mat3<Real>(term * M) / (k + 1);
    sum += term;
  }
  return sum;
}

template <class Scalar>
double error_at(const Vec3<Scalar>& r) {
  return static_cast<double>(
      (real(detail::left_jacobian(r)) - true_jacobian(real(r))).cwiseAbs().maxCoeff());
}

TYPED_TEST(LeftJacobian, AtEverySize_WithinRounding) {
  Source<TypeParam> source(1);
  for (int i = 0; i < 30000; ++i) {
    const Vec3<TypeParam> r = source.log_uniform(1e-20, 6.2) * source.direction();
    EXPECT_LE(error_at(r), 8 * u<TypeParam>) << r.norm();
  }
}

TYPED_TEST(LeftJacobian, AroundTheSwitchOfTheSeries_WithinRounding) {
  Source<TypeParam> source(2);
  for (int i = 0; i < 30000; ++i) {
    const Vec3<TypeParam> r = source.log_uniform(0x1p-8, 0.5) * source.direction();
    EXPECT_LE(error_at(r), 8 * u<TypeParam>) << r.norm();
  }
}

TYPED_TEST(LeftJacobian, SmallVector_KeepsTheFirstOrderTerm) {
  // At these sizes a series entered too late loses the whole difference to the identity.
  for (const double size : {1e-8, 1e-4, 3e-4, 1e-3}) {
    const Vec3<TypeParam> r(0, 0, static_cast<TypeParam>(size));
    const Mat3<TypeParam> J = detail::left_jacobian(r);
    EXPECT_NEAR(J(1, 0), size / 2, size * 1e-6);
    EXPECT_NEAR(J(0, 1), -size / 2, size * 1e-6);
    EXPECT_EQ(J(2, 2), TypeParam(1));
  }
  EXPECT_EQ(detail::left_jacobian(Vec3<TypeParam>(Vec3<TypeParam>::Zero())),
            Mat3<TypeParam>(Mat3<TypeParam>::Identity()));
}

TYPED_TEST(LeftJacobian, PredictsASmallChangeOfTheRotation) {
  Source<TypeParam> source(3);
  constexpr Real kStep = 1e-6L;
  for (int i = 0; i < 2000; ++i) {
    const Vec3<TypeParam> r = source.uniform(0, 6) * source.direction();
    const Vec3<Real> change = kStep * real(source.direction());
    const Vec3<Real> after = real(r) + change;
    const Vec3<Real> before = real(r) - change;
    const Quat<Real> turn = true_exp(after) * true_exp(before).conjugate();
    const Vec3<Real> measured = turn.vec() / turn.w();  // tangent of half the angle: twice the step
    const Vec3<Real> predicted = real(detail::left_jacobian(r)) * change;
    EXPECT_LE((measured - predicted).norm() / kStep, 1e-10L + 16 * Real(u<TypeParam>));
  }
}

}  // namespace
}  // namespace batuta
