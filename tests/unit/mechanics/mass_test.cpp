// SPDX-License-Identifier: MIT
#include "batuta/mechanics/mass.hpp"

#include <gtest/gtest.h>

#include <array>

#include "batuta/mechanics/rotation.hpp"
#include "samples.hpp"

namespace batuta {
namespace {

using samples::Real;
using samples::real;
using samples::Source;
using samples::u;

template <class Scalar>
class Mass : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Mass, Scalars);

constexpr Real kPi = 3.14159265358979323846264338327950288L;

/// Mass and moments about the middle, by adding up thin discs across the axis.
struct Discs {
  Real mass = 0;
  Real axial = 0;
  Real transverse = 0;

  Discs(Real core, Real radius, Real density) {
    add_part(0, core / 2, core, radius, density);
    add_part(core / 2, core / 2 + radius, core, radius, density);
  }

 private:
  // Three-point Gauss in each of some pieces. Half of the capsule counts twice: it is symmetric.
  void add_part(Real from, Real to, Real core, Real radius, Real density) {
    constexpr int kPieces = 8;
    const Real half = (to - from) / (2 * kPieces);
    const Real outer = std::sqrt(Real(3) / 5) * half;
    for (int i = 0; i < kPieces; ++i) {
      const Real middle = from + (2 * i + 1) * half;
      const std::array<Real, 3> places = {middle - outer, middle, middle + outer};
      const std::array<Real, 3> weights = {Real(5) / 9, Real(8) / 9, Real(5) / 9};
      for (std::size_t k = 0; k < 3; ++k) {
        add_disc(places[k], core, radius, 2 * density * weights[k] * half);
      }
    }
  }
  void add_disc(Real x, Real core, Real radius, Real weight) {
    const Real beyond = std::max(Real(0), x - core / 2);
    const Real rr = radius * radius - beyond * beyond;
    const Real dm = weight * kPi * rr;
    mass += dm;
    axial += dm * rr / 2;
    transverse += dm * (rr / 4 + x * x);
  }
};

template <class Scalar>
Capsule<Scalar> capsule_along(const Vec3<Scalar>& middle, const Vec3<Scalar>& half, Scalar radius) {
  return {{middle - half, middle + half}, radius};
}

TYPED_TEST(Mass, SolidCapsule_AgreesWithItsDiscs) {
  for (const double core : {0.0, 1e-3, 0.3, 1.0, 7.0}) {
    for (const double radius : {1e-3, 0.1, 2.0}) {
      const auto half = static_cast<TypeParam>(core / 2);
      const Capsule<TypeParam> capsule = {{{half, 0, 0}, {-half, 0, 0}},
                                          static_cast<TypeParam>(radius)};
      const auto answer = solid_capsule(capsule, TypeParam(800));
      ASSERT_TRUE(answer.ok());
      const Discs truth(2 * static_cast<Real>(half), static_cast<Real>(capsule.radius), 800);
      const Mat3<TypeParam>& inertia = answer.value.inertia_S;
      const double bound = 16 * u<TypeParam>;
      EXPECT_NEAR(static_cast<double>(answer.value.mass / truth.mass), 1, bound);
      EXPECT_NEAR(static_cast<double>(inertia(1, 1) / truth.transverse), 1, bound);
      EXPECT_NEAR(static_cast<double>(inertia(2, 2) / truth.transverse), 1, bound);
      // In one tensor, the small moment is known to the rounding of the large one.
      EXPECT_NEAR(static_cast<double>(inertia(0, 0)), static_cast<double>(truth.axial),
                  16 * u<TypeParam> * static_cast<double>(truth.transverse));
    }
  }
}

TYPED_TEST(Mass, Sphere_HasTwoFifths) {
  const auto ball = Capsule<TypeParam>::sphere({1, 2, 3}, TypeParam(0.5));
  const auto answer = solid_capsule(ball, TypeParam(3));
  ASSERT_TRUE(answer.ok());
  const double mass = 3 * 4.0 / 3 * static_cast<double>(kPi) / 8;
  EXPECT_NEAR(answer.value.mass, mass, 8 * u<TypeParam> * mass);
  EXPECT_EQ(answer.value.center_S, Vec3<TypeParam>(1, 2, 3));
  const Mat3<TypeParam> truth = Mat3<TypeParam>::Identity() * static_cast<TypeParam>(mass * 0.1);
  EXPECT_LE((answer.value.inertia_S - truth).cwiseAbs().maxCoeff(), 8 * u<TypeParam> * mass);
}

TYPED_TEST(Mass, TurnedCapsule_HasTheTurnedTensor) {
  Source<TypeParam> source(1);
  for (int i = 0; i < 1000; ++i) {
    const Quat<TypeParam> q = source.rotation();
    const Vec3<TypeParam> middle = source.vector(2);
    const Vec3<TypeParam> half(source.uniform(0.01, 1), 0, 0);
    const TypeParam radius = source.uniform(0.01, 0.5);
    const Vec3<TypeParam> turned = q * half;
    const auto plain = solid_capsule(capsule_along({0, 0, 0}, half, radius), TypeParam(1));
    const auto answer = solid_capsule(capsule_along(middle, turned, radius), TypeParam(1));
    ASSERT_TRUE(plain.ok() && answer.ok());
    const Mat3<TypeParam> R = detail::to_matrix(q);
    const Mat3<TypeParam> truth = R * plain.value.inertia_S * R.transpose();
    // The ends are rounded to u |end|, and the moments go with the cube of the length.
    const double bound = 64 * u<TypeParam> * (1 + 4 / static_cast<double>(half.x())) *
                         static_cast<double>(truth.cwiseAbs().maxCoeff());
    EXPECT_LE((answer.value.inertia_S - truth).cwiseAbs().maxCoeff(), bound);
    EXPECT_LE((answer.value.center_S - middle).norm(), 16 * u<TypeParam>);
  }
}

TYPED_TEST(Mass, InvalidCapsuleOrDensity_IsRefused) {
  using Limits = std::numeric_limits<TypeParam>;
  const Capsule<TypeParam> good = {{{0, 0, 0}, {1, 0, 0}}, TypeParam(0.1)};
  for (const TypeParam density :
       {TypeParam(0), TypeParam(-1), Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_EQ(solid_capsule(good, density).status, Status::kInvalidArgument);
  }
  for (const TypeParam radius : {TypeParam(-1), Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_EQ(solid_capsule<TypeParam>({good.axis, radius}, 1).status, Status::kInvalidArgument);
  }
  EXPECT_EQ(solid_capsule<TypeParam>({good.axis, 0}, 1).status, Status::kInvalidArgument)
      << "no volume, no mass";
  const Capsule<TypeParam> vast = {{{0, 0, 0}, {Limits::max() / 4, 0, 0}}, TypeParam(1)};
  EXPECT_EQ(solid_capsule(vast, TypeParam(1)).status, Status::kInvalidArgument) << "overflows";
  const auto minute = Capsule<TypeParam>::sphere({0, 0, 0}, Limits::min());
  EXPECT_EQ(solid_capsule(minute, TypeParam(1)).status, Status::kInvalidArgument) << "vanishes";
}

TYPED_TEST(Mass, PointMass_HasNoInertiaOfItsOwn) {
  const auto answer = point_mass(TypeParam(2), Vec3<TypeParam>(1, 2, 3));
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer.value.mass, TypeParam(2));
  EXPECT_EQ(answer.value.center_S, Vec3<TypeParam>(1, 2, 3));
  EXPECT_EQ(answer.value.inertia_S, Mat3<TypeParam>(Mat3<TypeParam>::Zero()));
}

TYPED_TEST(Mass, InvalidPointMass_IsRefused) {
  using Limits = std::numeric_limits<TypeParam>;
  const Vec3<TypeParam> origin = Vec3<TypeParam>::Zero();
  for (const TypeParam mass :
       {TypeParam(0), TypeParam(-1), Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_EQ(point_mass(mass, origin).status, Status::kInvalidArgument);
  }
  const Vec3<TypeParam> nowhere(0, Limits::quiet_NaN(), 0);
  EXPECT_EQ(point_mass(TypeParam(1), nowhere).status, Status::kInvalidArgument);
}

/// [Kavan eq. 1-3] for points: the definition, in long double.
template <class Scalar, std::size_t N>
MassProperties<Real> sum_of_points(const std::array<Scalar, N>& m,
                                   const std::array<Vec3<Scalar>, N>& x) {
  MassProperties<Real> sum;
  for (std::size_t i = 0; i < N; ++i) {
    sum.mass += static_cast<Real>(m[i]);
    sum.center_S += static_cast<Real>(m[i]) * real(x[i]);
  }
  sum.center_S /= sum.mass;
  for (std::size_t i = 0; i < N; ++i) {
    const Vec3<Real> r = real(x[i]) - sum.center_S;
    sum.inertia_S +=
        static_cast<Real>(m[i]) * (r.squaredNorm() * Mat3<Real>::Identity() - r * r.transpose());
  }
  return sum;
}

TYPED_TEST(Mass, SumOfPoints_IsTheDefinition) {
  Source<TypeParam> source(2);
  for (int i = 0; i < 2000; ++i) {
    std::array<TypeParam, 4> m;
    std::array<Vec3<TypeParam>, 4> x;
    MassProperties<TypeParam> sum;
    for (std::size_t k = 0; k < m.size(); ++k) {
      m[k] = source.log_uniform(1e-4, 1e4);
      x[k] = source.vector(1);
      sum = sum + point_mass(m[k], x[k]).value;
    }
    const MassProperties<Real> truth = sum_of_points(m, x);
    EXPECT_NEAR(static_cast<double>(sum.mass / truth.mass), 1, 4 * u<TypeParam>);
    EXPECT_LE((real(sum.center_S) - truth.center_S).norm(), 24 * u<TypeParam>);
    EXPECT_LE((real(sum.inertia_S) - truth.inertia_S).cwiseAbs().maxCoeff(),
              64 * u<TypeParam> * truth.inertia_S.cwiseAbs().maxCoeff());
  }
}

TYPED_TEST(Mass, SumFarFromTheOrigin_KeepsItsInertia) {
  // Differences of positions enter, not positions: 2^10 m away nothing is lost.
  const Vec3<TypeParam> far = Vec3<TypeParam>::Constant(1024);
  const Vec3<TypeParam> x(TypeParam(0.5), 0, 0);
  const auto near =
      point_mass(TypeParam(1), x).value + point_mass(TypeParam(3), Vec3<TypeParam>(-x)).value;
  const auto there = point_mass(TypeParam(1), Vec3<TypeParam>(far + x)).value +
                     point_mass(TypeParam(3), Vec3<TypeParam>(far - x)).value;
  EXPECT_EQ(there.inertia_S, near.inertia_S);
  EXPECT_EQ(Vec3<TypeParam>(there.center_S - far), near.center_S);
}

TYPED_TEST(Mass, SumWithNothing_ChangesNothing) {
  MassProperties<TypeParam> nothing;
  nothing.center_S = {TypeParam(1e6), 0, 0};  // wherever it is
  const auto ball = solid_capsule(Capsule<TypeParam>::sphere({1, 2, 3}, 1), TypeParam(1)).value;
  for (const auto& sum : {ball + nothing, nothing + ball}) {
    EXPECT_EQ(sum.mass, ball.mass);
    EXPECT_EQ(sum.center_S, ball.center_S);
    EXPECT_EQ(sum.inertia_S, ball.inertia_S);
  }
  EXPECT_EQ((nothing + nothing).mass, TypeParam(0));
}

TYPED_TEST(Mass, ExtremeMassRatio_LeavesTheHeavyOne) {
  const auto heavy = point_mass(TypeParam(1e9), Vec3<TypeParam>(0, 0, 0)).value;
  const auto light = point_mass(TypeParam(1e-9), Vec3<TypeParam>(1, 0, 0)).value;
  const auto sum = heavy + light;
  EXPECT_NEAR(sum.center_S.x(), 1e-18, 1e-18 * 8 * u<TypeParam>);
  EXPECT_NEAR(sum.inertia_S(1, 1), 1e-9, 1e-9 * 8 * u<TypeParam>);
  EXPECT_EQ(sum.inertia_S(0, 0), TypeParam(0));
}

/// R diag(moments) R^T against the tensor, relative to its largest element; also the form of the
/// answer.
template <class Scalar>
double frame_error(const MassProperties<Scalar>& mass) {
  const PrincipalFrame<Scalar> frame = principal_frame(mass);
  EXPECT_EQ(frame.center_S, mass.center_S);
  EXPECT_LE(frame.moments(0), frame.moments(1));
  EXPECT_LE(frame.moments(1), frame.moments(2));
  EXPECT_GE(frame.moments(0), Scalar(0));
  EXPECT_NEAR(static_cast<double>(real(frame.q_SB).norm()), 1, 4 * u<Scalar>);
  const Mat3<Real> R = real(frame.q_SB).normalized().toRotationMatrix();
  const Mat3<Real> back = R * real(frame.moments).asDiagonal() * R.transpose();
  return static_cast<double>((back - real(mass.inertia_S)).cwiseAbs().maxCoeff() /
                             real(mass.inertia_S).cwiseAbs().maxCoeff());
}

/// A tensor with the given moments in axes turned by q, rounded to Scalar and symmetric.
template <class Scalar>
MassProperties<Scalar> turned_tensor(const Vec3<Real>& moments, const Quat<Scalar>& q) {
  const Mat3<Real> R = real(q).normalized().toRotationMatrix();
  const Mat3<Scalar> I = (R * moments.asDiagonal() * R.transpose()).eval().template cast<Scalar>();
  return {Scalar(1), Vec3<Scalar>(1, 2, 3), (I + I.transpose()) / 2};
}

TYPED_TEST(Mass, PrincipalFrameOfRandomTensors_GivesBackTheTensorAndTheMoments) {
  Source<TypeParam> source(3);
  for (int i = 0; i < 20000; ++i) {
    Vec3<Real> moments(source.log_uniform(1e-6, 1), source.log_uniform(1e-3, 1), 1);
    std::sort(moments.data(), moments.data() + 3);
    const auto mass = turned_tensor(moments, source.rotation());
    EXPECT_LE(frame_error(mass), 24 * u<TypeParam>);
    const Vec3<Real> found = real(principal_frame(mass).moments);
    EXPECT_LE((found - moments).cwiseAbs().maxCoeff(), 12 * u<TypeParam>);
  }
}

TYPED_TEST(Mass, PrincipalFrameAtAnisotropyOneMillion_StaysExactInItsOwnAxes) {
  MassProperties<TypeParam> mass;
  mass.inertia_S.diagonal() << TypeParam(1), TypeParam(1e-6), TypeParam(1);
  const PrincipalFrame<TypeParam> frame = principal_frame(mass);
  EXPECT_EQ(frame.moments, Vec3<TypeParam>(TypeParam(1e-6), 1, 1));
  const Vec3<TypeParam> first = frame.q_SB * Vec3<TypeParam>::UnitX();
  EXPECT_LE((first.cwiseAbs() - Vec3<TypeParam>::UnitY()).norm(), 4 * u<TypeParam>);
}

TYPED_TEST(Mass, PrincipalFrameOfEqualMoments_KeepsThemEqual) {
  Source<TypeParam> source(4);
  double widest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Real low = source.log_uniform(1e-6, 1);
    const auto mass = turned_tensor(Vec3<Real>(low, 1, 1), source.rotation());
    EXPECT_LE(frame_error(mass), 24 * u<TypeParam>);
    const Vec3<TypeParam> moments = principal_frame(mass).moments;
    widest = std::max(widest, static_cast<double>(moments(2) - moments(1)));
  }
  EXPECT_LE(widest, 16 * u<TypeParam>) << "motion.md counts on half of its tolerance";
  EXPECT_GT(widest, 0);
}

TYPED_TEST(Mass, PrincipalFrameOfBall_IsTheFrameItself) {
  MassProperties<TypeParam> ball;
  ball.inertia_S = Mat3<TypeParam>::Identity() * TypeParam(0.4);
  const PrincipalFrame<TypeParam> frame = principal_frame(ball);
  EXPECT_EQ(frame.q_SB.coeffs(), Quat<TypeParam>::Identity().coeffs());
  EXPECT_EQ(frame.moments, Vec3<TypeParam>(Vec3<TypeParam>::Constant(TypeParam(0.4))));
}

TYPED_TEST(Mass, PrincipalFrameOfPointsInALine_HasOneZeroMoment) {
  Source<TypeParam> source(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3<TypeParam> x = source.direction();
    const auto line =
        point_mass(TypeParam(1), x).value + point_mass(TypeParam(1), Vec3<TypeParam>(-x)).value;
    const PrincipalFrame<TypeParam> frame = principal_frame(line);
    EXPECT_GE(frame.moments(0), TypeParam(0));
    EXPECT_LE(frame.moments(0), 24 * u<TypeParam>);
    EXPECT_LE((frame.q_SB * Vec3<TypeParam>::UnitX()).cross(x).norm(), 24 * u<TypeParam>);
  }
}

TYPED_TEST(Mass, PrincipalFrameAtAnyScale_HasTheSameAxes) {
  Source<TypeParam> source(6);
  const auto mass = turned_tensor(Vec3<Real>(0.2L, 0.5L, 0.6L), source.rotation());
  const PrincipalFrame<TypeParam> truth = principal_frame(mass);
  for (const int exponent : {-100, -40, 40, 100}) {
    const TypeParam scale = std::ldexp(TypeParam(1), exponent);
    MassProperties<TypeParam> scaled = mass;
    scaled.inertia_S *= scale;
    const PrincipalFrame<TypeParam> frame = principal_frame(scaled);
    EXPECT_EQ(frame.q_SB.coeffs(), truth.q_SB.coeffs());
    EXPECT_EQ(frame.moments, Vec3<TypeParam>(truth.moments * scale));
  }
}

TYPED_TEST(Mass, PrincipalFrameOfNothing_IsTheIdentity) {
  MassProperties<TypeParam> nothing;
  nothing.center_S = {1, 2, 3};
  for (const TypeParam fill : {TypeParam(0), std::numeric_limits<TypeParam>::infinity()}) {
    nothing.inertia_S.setConstant(fill);
    const PrincipalFrame<TypeParam> frame = principal_frame(nothing);
    EXPECT_EQ(frame.center_S, nothing.center_S);
    EXPECT_EQ(frame.q_SB.coeffs(), Quat<TypeParam>::Identity().coeffs());
    EXPECT_EQ(frame.moments, Vec3<TypeParam>(Vec3<TypeParam>::Zero()));
  }
}

TYPED_TEST(Mass, PrincipalFrameOfOneInfiniteElement_IsTheIdentity) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      MassProperties<TypeParam> endless;
      endless.inertia_S.setIdentity();
      endless.inertia_S(i, j) = endless.inertia_S(j, i) =
          -std::numeric_limits<TypeParam>::infinity();
      const PrincipalFrame<TypeParam> frame = principal_frame(endless);
      EXPECT_EQ(frame.q_SB.coeffs(), Quat<TypeParam>::Identity().coeffs()) << i << ' ' << j;
      EXPECT_EQ(frame.moments, Vec3<TypeParam>(Vec3<TypeParam>::Zero())) << i << ' ' << j;
    }
  }
}

TYPED_TEST(Mass, Sword_BalancesWhereItsPartsSay) {
  // A blade of 0.9 m along x, a guard across, a pommel of 0.25 kg behind the grip.
  const Capsule<TypeParam> blade = {{{0, 0, 0}, {TypeParam(0.9), 0, 0}}, TypeParam(0.004)};
  const Capsule<TypeParam> guard = {{{0, TypeParam(-0.05), 0}, {0, TypeParam(0.05), 0}},
                                    TypeParam(0.005)};
  const auto steel = solid_capsule(blade, TypeParam(7800));
  const auto cross = solid_capsule(guard, TypeParam(7800));
  const auto pommel = point_mass(TypeParam(0.25), Vec3<TypeParam>(TypeParam(-0.17), 0, 0));
  ASSERT_TRUE(steel.ok() && cross.ok() && pommel.ok());
  const auto sword = steel.value + cross.value + pommel.value;
  const double balance = (0.45 * static_cast<double>(steel.value.mass) - 0.17 * 0.25) /
                         static_cast<double>(sword.mass);
  EXPECT_NEAR(sword.center_S.x(), balance, 16 * u<TypeParam>);
  const PrincipalFrame<TypeParam> frame = principal_frame(sword);
  const Vec3<TypeParam> along = frame.q_SB * Vec3<TypeParam>::UnitX();
  EXPECT_NEAR(std::fabs(along.x()), 1, 16 * u<TypeParam>);
  EXPECT_LT(frame.moments(0), frame.moments(1) / 100);
}

}  // namespace
}  // namespace batuta
