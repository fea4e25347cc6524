// SPDX-License-Identifier: MIT
#include "batuta/mechanics/body.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"

namespace batuta {
namespace {

using samples::Real;
using samples::real;
using samples::relative_error;
using samples::Source;
using samples::u;

template <class Scalar>
class BodyOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BodyOf, Scalars);

template <class Scalar>
constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
template <class Scalar>
constexpr Scalar kNaN = std::numeric_limits<Scalar>::quiet_NaN();

template <class Scalar>
Pose<Scalar> random_pose(Source<Scalar>& source) {
  const Vec3<Scalar> p = source.vector(2);
  return {p, source.rotation()};
}

template <class Scalar>
Body<Scalar> random_body(Source<Scalar>& source, double anisotropy) {
  const Pose<Scalar> X = random_pose(source);
  Vec3<Scalar> moments;
  for (int i = 0; i < 3; ++i) moments(i) = source.log_uniform(1, anisotropy);
  Body<Scalar> body = make_body(X, source.log_uniform(1e-3, 1e3), moments).value;
  body.momentum = {source.vector(3), source.vector(3)};
  return body;
}

template <class Scalar>
Mat3<Real> true_rotation(const Body<Scalar>& body) {
  return real(body.X_WB.q_WB).normalized().toRotationMatrix();
}

template <class Scalar>
void expect_same(const Body<Scalar>& A, const Body<Scalar>& B) {
  EXPECT_EQ(A.X_WB.p_W, B.X_WB.p_W);
  EXPECT_EQ(A.X_WB.q_WB.coeffs(), B.X_WB.q_WB.coeffs());
  EXPECT_EQ(A.momentum.linear_W, B.momentum.linear_W);
  EXPECT_EQ(A.momentum.angular_W, B.momentum.angular_W);
}

TYPED_TEST(BodyOf, NothingSaid_IsFixedAtTheOriginAndUnturned) {
  const Body<TypeParam> body;
  EXPECT_EQ(body.X_WB.p_W, (Vec3<TypeParam>(0, 0, 0)));
  EXPECT_EQ(body.X_WB.q_WB.coeffs(), Quat<TypeParam>::Identity().coeffs());
  EXPECT_EQ(body.momentum.linear_W, (Vec3<TypeParam>(0, 0, 0)));
  EXPECT_EQ(body.momentum.angular_W, (Vec3<TypeParam>(0, 0, 0)));
  EXPECT_EQ(body.inverse_mass, TypeParam(0));
  EXPECT_EQ(body.inverse_moments, (Vec3<TypeParam>(0, 0, 0)));
}

TYPED_TEST(BodyOf, MakeBody_KeepsTheInverses) {
  const auto body = make_body<TypeParam>({}, 2, {4, 8, kInfinity<TypeParam>});
  ASSERT_TRUE(body.ok());
  EXPECT_EQ(body.value.inverse_mass, TypeParam(0.5));
  EXPECT_EQ(body.value.inverse_moments, Vec3<TypeParam>(TypeParam(0.25), TypeParam(0.125), 0));
  EXPECT_FALSE(is_fixed(body.value));
  EXPECT_EQ(kinetic_energy(body.value), TypeParam(0));
}

TYPED_TEST(BodyOf, MakeBodyOfInfiniteMassAndMoments_IsFixed) {
  const Vec3<TypeParam> endless = Vec3<TypeParam>::Constant(kInfinity<TypeParam>);
  const auto body = make_body<TypeParam>({}, kInfinity<TypeParam>, endless);
  ASSERT_TRUE(body.ok());
  EXPECT_TRUE(is_fixed(body.value));
  EXPECT_FALSE(is_fixed(make_body<TypeParam>({}, 1, endless).value));
  EXPECT_FALSE(is_fixed(make_body<TypeParam>({}, kInfinity<TypeParam>, {1, 1, 1}).value));
}

TYPED_TEST(BodyOf, MakeBodyWithBadNumbers_IsRefused) {
  const TypeParam subnormal = std::numeric_limits<TypeParam>::denorm_min();
  const Vec3<TypeParam> ones = Vec3<TypeParam>::Ones();
  for (const TypeParam bad : {TypeParam(0), TypeParam(-1), kNaN<TypeParam>, subnormal}) {
    EXPECT_EQ(make_body<TypeParam>({}, bad, ones).status, Status::kInvalidArgument);
    for (int i = 0; i < 3; ++i) {
      Vec3<TypeParam> moments = ones;
      moments(i) = bad;
      EXPECT_EQ(make_body<TypeParam>({}, 1, moments).status, Status::kInvalidArgument);
    }
  }
  for (const TypeParam bad : {kNaN<TypeParam>, kInfinity<TypeParam>}) {
    Pose<TypeParam> X;
    X.p_W.y() = bad;
    EXPECT_EQ(make_body(X, TypeParam(1), ones).status, Status::kInvalidArgument);
    X = {};
    X.q_WB.z() = bad;
    EXPECT_EQ(make_body(X, TypeParam(1), ones).status, Status::kInvalidArgument);
  }
}

TYPED_TEST(BodyOf, MakeBody_RenewsTheQuaternion) {
  Pose<TypeParam> X;
  X.q_WB = Quat<TypeParam>(3, 0, 4, 0);
  const auto body = make_body(X, TypeParam(1), Vec3<TypeParam>(Vec3<TypeParam>::Ones()));
  ASSERT_TRUE(body.ok());
  EXPECT_NEAR(body.value.X_WB.q_WB.w(), 0.6, 4 * u<TypeParam>);
  EXPECT_NEAR(body.value.X_WB.q_WB.y(), 0.8, 4 * u<TypeParam>);
}

TYPED_TEST(BodyOf, ToWorldAndBack_IsTheSamePoint) {
  Source<TypeParam> source(1);
  for (int i = 0; i < 10000; ++i) {
    const Pose<TypeParam> X = random_pose(source);
    const Vec3<TypeParam> x_B = source.vector(1);
    const Vec3<TypeParam> x_W = to_world(X, x_B);
    const Mat3<Real> R = real(X.q_WB).normalized().toRotationMatrix();
    EXPECT_LE((real(x_W) - (real(X.p_W) + R * real(x_B))).norm(), 24 * u<TypeParam>);
    EXPECT_LE((to_body(X, x_W) - x_B).norm(), 32 * u<TypeParam>);
  }
}

TYPED_TEST(BodyOf, CapsuleToWorld_HasTheEndsInTheWorld) {
  Source<TypeParam> source(2);
  const Pose<TypeParam> X = random_pose(source);
  const Capsule<TypeParam> capsule = {{source.vector(1), source.vector(1)}, TypeParam(0.3)};
  const Capsule<TypeParam> moved = to_world(X, capsule);
  EXPECT_EQ(moved.axis.a, to_world(X, capsule.axis.a));
  EXPECT_EQ(moved.axis.b, to_world(X, capsule.axis.b));
  EXPECT_EQ(moved.radius, capsule.radius);
}

TYPED_TEST(BodyOf, InverseInertia_IsSymmetricAndTurnedIntoTheWorld) {
  Source<TypeParam> source(3);
  for (int i = 0; i < 5000; ++i) {
    const Body<TypeParam> body = random_body(source, 1e6);
    const Mat3<TypeParam> inverse = detail::inverse_inertia_W(body);
    EXPECT_EQ(inverse, Mat3<TypeParam>(inverse.transpose()));
    const Mat3<Real> R = true_rotation(body);
    const Mat3<Real> truth = R * real(body.inverse_moments).asDiagonal() * R.transpose();
    EXPECT_LE((real(inverse) - truth).cwiseAbs().maxCoeff(),
              24 * u<TypeParam> * body.inverse_moments.maxCoeff());
  }
}

TYPED_TEST(BodyOf, Twist_IsMomentumOverMassAndInertia) {
  Source<TypeParam> source(4);
  for (int i = 0; i < 10000; ++i) {
    const Body<TypeParam> body = random_body(source, 100);
    const Twist<TypeParam> twist = twist_of(body);
    const Mat3<Real> R = true_rotation(body);
    const Vec3<Real> w = R * (real(body.inverse_moments).asDiagonal() *
                              (R.transpose() * real(body.momentum.angular_W)));
    EXPECT_LE(relative_error(twist.v_W, Vec3<Real>(static_cast<Real>(body.inverse_mass) *
                                                   real(body.momentum.linear_W))),
              4 * u<TypeParam>);
    const Real scale = body.inverse_moments.maxCoeff() * body.momentum.angular_W.norm();
    EXPECT_LE((real(twist.w_W) - w).norm(), 24 * u<TypeParam> * scale);
  }
}

TYPED_TEST(BodyOf, MomentumOfTwist_GivesBackTheMomentumAlsoAtAnisotropyOneMillion) {
  Source<TypeParam> source(5);
  for (int i = 0; i < 10000; ++i) {
    Body<TypeParam> body = random_body(source, 1e6);
    // Turning about one principal axis at a time: the error stays relative to that moment's own
    // share.
    const int axis = i % 3;
    const Mat3<TypeParam> R = detail::to_matrix(body.X_WB.q_WB);
    body.momentum.angular_W = R.col(axis);
    const Momentum<TypeParam> back = momentum_of(body, twist_of(body));
    const double spread = static_cast<double>(body.inverse_moments.maxCoeff()) /
                          static_cast<double>(body.inverse_moments.minCoeff());
    EXPECT_LE(relative_error(back.linear_W, real(body.momentum.linear_W)), 8 * u<TypeParam>);
    EXPECT_LE(relative_error(back.angular_W, real(body.momentum.angular_W)),
              24 * u<TypeParam> * spread);
  }
}

TYPED_TEST(BodyOf, TwistInItsOwnAxes_LosesNothingAtAnisotropyOneMillion) {
  const Vec3<TypeParam> moments(TypeParam(1e-6), 1, 1);
  Body<TypeParam> body = make_body<TypeParam>({}, 1, moments).value;
  body.momentum.angular_W = {TypeParam(1e-6), 3, -2};
  const Vec3<TypeParam> w = twist_of(body).w_W;
  EXPECT_NEAR(w.x(), 1, 4 * u<TypeParam>);
  EXPECT_EQ(w.y(), TypeParam(3));
  EXPECT_EQ(w.z(), TypeParam(-2));
  const Vec3<TypeParam> b = momentum_of(body, {{0, 0, 0}, w}).angular_W;
  EXPECT_NEAR(b.x(), 1e-6, 8e-6 * u<TypeParam>);
}

TYPED_TEST(BodyOf, FixedBody_HasNoTwistNoMomentumAndNoEnergy) {
  Body<TypeParam> wall;
  wall.momentum = {{1, 2, 3}, {4, 5, 6}};
  const Vec3<TypeParam> zero = Vec3<TypeParam>::Zero();
  EXPECT_EQ(twist_of(wall).v_W, zero);
  EXPECT_EQ(twist_of(wall).w_W, zero);
  const Momentum<TypeParam> none = momentum_of(wall, {{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(none.linear_W, zero);
  EXPECT_EQ(none.angular_W, zero);
  EXPECT_EQ(kinetic_energy(wall), TypeParam(0));
}

TYPED_TEST(BodyOf, VelocityAt_IsTheDerivativeOfThePath) {
  Source<TypeParam> source(6);
  for (int i = 0; i < 2000; ++i) {
    const Pose<TypeParam> X = random_pose(source);
    const Twist<TypeParam> twist = {source.vector(2), source.vector(2)};
    const Vec3<TypeParam> x_W = source.vector(2);
    const Real h = 1e-6L;
    const auto place = [&](Real t) {
      const Vec3<Real> arm = real(x_W) - real(X.p_W);
      const Vec3<Real> turned = samples::true_exp(t * real(twist.w_W)) * arm;
      return Vec3<Real>(real(X.p_W) + t * real(twist.v_W) + turned);
    };
    const Vec3<Real> truth = (place(h) - place(-h)) / (2 * h);
    EXPECT_LE((real(velocity_at(X, twist, x_W)) - truth).norm(), 48 * u<TypeParam> + 1e-10);
  }
}

TYPED_TEST(BodyOf, Torque_IsArmCrossForce) {
  const Pose<TypeParam> X = {{1, 0, 0}, Quat<TypeParam>::Identity()};
  const Vec3<TypeParam> torque = torque_of(X, Vec3<TypeParam>(0, 3, 0), Vec3<TypeParam>(3, 0, 0));
  EXPECT_EQ(torque, Vec3<TypeParam>(0, 0, 6));
}

TYPED_TEST(BodyOf, Apply_AddsForceAndTorqueOverTime) {
  Body<TypeParam> body = make_body<TypeParam>({}, 2, {1, 1, 1}).value;
  EXPECT_EQ(apply<TypeParam>(body, {4, 0, 0}, {0, 8, 0}, TypeParam(0.25)), Status::kOk);
  EXPECT_EQ(apply<TypeParam>(body, {0, 0, 4}, {0, 8, 0}, TypeParam(0.25)), Status::kOk);
  EXPECT_EQ(body.momentum.linear_W, Vec3<TypeParam>(1, 0, 1));
  EXPECT_EQ(body.momentum.angular_W, Vec3<TypeParam>(0, 4, 0));
}

TYPED_TEST(BodyOf, ApplyWithBadNumbers_ChangesNothing) {
  Source<TypeParam> source(7);
  Body<TypeParam> body = random_body(source, 10);
  const Body<TypeParam> before = body;
  const Vec3<TypeParam> good(1, 2, 3);
  for (const TypeParam number : {kNaN<TypeParam>, kInfinity<TypeParam>, -kInfinity<TypeParam>}) {
    const Vec3<TypeParam> bad(1, number, 0);
    EXPECT_EQ(apply(body, bad, good, TypeParam(1)), Status::kInvalidArgument);
    EXPECT_EQ(apply(body, good, bad, TypeParam(1)), Status::kInvalidArgument);
    EXPECT_EQ(apply(body, good, good, number), Status::kInvalidArgument);
    EXPECT_EQ(apply_impulse(body, bad, good), Status::kInvalidArgument);
    EXPECT_EQ(apply_impulse(body, good, bad), Status::kInvalidArgument);
  }
  EXPECT_EQ(apply(body, good, good, TypeParam(-1)), Status::kInvalidArgument);
  const Vec3<TypeParam> vast = Vec3<TypeParam>::Constant(std::numeric_limits<TypeParam>::max());
  EXPECT_EQ(apply(body, vast, good, TypeParam(2)), Status::kInvalidArgument) << "overflows";
  EXPECT_EQ(apply(body, good, vast, TypeParam(2)), Status::kInvalidArgument) << "overflows";
  expect_same(body, before);
}

TYPED_TEST(BodyOf, ApplyOnWhatCannotMove_ChangesNothing) {
  Body<TypeParam> wall;
  EXPECT_EQ(apply<TypeParam>(wall, {1, 2, 3}, {1, 2, 3}, 1), Status::kOk);
  EXPECT_EQ(apply_impulse<TypeParam>(wall, {1, 2, 3}, {3, 2, 1}), Status::kOk);
  expect_same(wall, Body<TypeParam>{});

  Body<TypeParam> hinged = make_body<TypeParam>({}, kInfinity<TypeParam>, {1, 1, 1}).value;
  EXPECT_EQ(apply<TypeParam>(hinged, {1, 2, 3}, {1, 2, 3}, 1), Status::kOk);
  EXPECT_EQ(hinged.momentum.linear_W, Vec3<TypeParam>(0, 0, 0));
  EXPECT_EQ(hinged.momentum.angular_W, Vec3<TypeParam>(1, 2, 3));
}

TYPED_TEST(BodyOf, Impulse_ChangesTheVelocityOfItsPointByTheCollisionMatrix) {
  // dv(x) = (1/m + (I^-1 (r x J)) x r): [Kavan eq. 12-15] put into eq. 6.
  Source<TypeParam> source(8);
  for (int i = 0; i < 2000; ++i) {
    Body<TypeParam> body = random_body(source, 10);
    const Vec3<TypeParam> x_W = source.vector(2);
    const Vec3<TypeParam> J = source.vector(1);
    const Vec3<TypeParam> before = velocity_at(body.X_WB, twist_of(body), x_W);
    const Vec3<Real> r = real(x_W) - real(body.X_WB.p_W);
    const Mat3<Real> R = true_rotation(body);
    const Mat3<Real> inverse = R * real(body.inverse_moments).asDiagonal() * R.transpose();
    const Vec3<Real> truth =
        static_cast<Real>(body.inverse_mass) * real(J) + (inverse * r.cross(real(J))).cross(r);
    ASSERT_EQ(apply_impulse(body, J, x_W), Status::kOk);
    const Vec3<TypeParam> after = velocity_at(body.X_WB, twist_of(body), x_W);
    const double speeds = static_cast<double>(before.norm() + after.norm()) + 20;
    EXPECT_LE((real(Vec3<TypeParam>(after - before)) - truth).norm(), 64 * u<TypeParam> * speeds);
  }
}

/// A body that goes nowhere, with the axes that it can turn about.
template <class Scalar>
Body<Scalar> on_axle(Source<Scalar>& source, const Vec3<Scalar>& axes) {
  Body<Scalar> body = random_body<Scalar>(source, 10);
  body.inverse_mass = 0;
  body.inverse_moments = body.inverse_moments.cwiseProduct(axes);
  return body;
}

TYPED_TEST(BodyOf, DropHeld_LeavesWhatTheOneAxleCanHave) {
  using Scalar = TypeParam;
  Source<Scalar> source(17);
  for (int k = 0; k < 300; ++k) {
    const Vec3<Scalar> axis = Vec3<Scalar>::Unit(k % 3);
    Body<Scalar> body = on_axle<Scalar>(source, axis);
    const Vec3<Real> along_W = true_rotation(body) * real(axis);
    const Vec3<Real> right = along_W.dot(real(body.momentum.angular_W)) * along_W;
    const Real size = real(body.momentum.angular_W).norm();
    detail::drop_held(body);
    EXPECT_LE((real(body.momentum.angular_W) - right).norm(), 24 * u<Scalar> * size);
    EXPECT_EQ(body.momentum.linear_W, Vec3<Scalar>::Zero());
  }
}

TYPED_TEST(BodyOf, DropHeld_LeavesSpinAndGyroscopesToTheLastBit) {
  using Scalar = TypeParam;
  Source<Scalar> source(18);
  for (int k = 0; k < 300; ++k) {
    const Vec3<Scalar> axis = Vec3<Scalar>::Unit(k % 3);
    Body<Scalar> spinning = on_axle<Scalar>(source, axis);
    spinning.momentum.linear_W.setZero();
    spinning.momentum.angular_W = spinning.X_WB.q_WB * Vec3<Scalar>(3 * axis);
    Body<Scalar> gyroscope = on_axle<Scalar>(source, Vec3<Scalar>(Vec3<Scalar>::Ones() - axis));
    for (Body<Scalar>* const body : {&spinning, &gyroscope}) {
      const Body<Scalar> before = *body;
      detail::drop_held(*body);
      expect_same(*body, before);
    }
  }
}

TYPED_TEST(BodyOf, KineticEnergy_IsHalfMomentumTimesTwist) {
  Source<TypeParam> source(9);
  for (int i = 0; i < 5000; ++i) {
    const Body<TypeParam> body = random_body(source, 1e6);
    const Mat3<Real> R = true_rotation(body);
    const Vec3<Real> b_B = R.transpose() * real(body.momentum.angular_W);
    const Real truth =
        (static_cast<Real>(body.inverse_mass) * real(body.momentum.linear_W).squaredNorm() +
         b_B.cwiseProduct(b_B).dot(real(body.inverse_moments))) /
        2;
    const double scale = static_cast<double>(truth) +
                         body.inverse_moments.maxCoeff() * body.momentum.angular_W.squaredNorm();
    EXPECT_NEAR(static_cast<double>(kinetic_energy(body)), static_cast<double>(truth),
                16 * u<TypeParam> * scale);
  }
}

}  // namespace
}  // namespace batuta
