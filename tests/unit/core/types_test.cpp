// SPDX-License-Identifier: MIT
#include "batuta/core/types.hpp"

#include <gtest/gtest.h>

namespace batuta {
namespace {

// The layout that host and target share: no padding for vector units.
static_assert(sizeof(Vec3<float>) == 12 && alignof(Vec3<float>) == alignof(float));
static_assert(sizeof(Quat<float>) == 16 && alignof(Quat<float>) == alignof(float));
static_assert(sizeof(Mat3<double>) == 72 && alignof(Mat3<double>) == alignof(double));
static_assert(kRoundOff<float> == 0x1p-24F);
static_assert(kRoundOff<double> == 0x1p-53);
static_assert(detail::kIsScalar<float> && detail::kIsScalar<double> &&
              !detail::kIsScalar<long double> && !detail::kIsScalar<int>);

template <class Scalar>
class Types : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Types, Scalars);

TYPED_TEST(Types, IsFinite_RefusesNanAndInfinities) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam x : {TypeParam(0), TypeParam(-0.0), Limits::max(), Limits::lowest(),
                            Limits::min(), Limits::denorm_min()}) {
    EXPECT_TRUE(is_finite(x)) << x;
  }
  for (const TypeParam x : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_FALSE(is_finite(x)) << x;
  }
}

TYPED_TEST(Types, IsFinite_FindsOneBadComponent) {
  constexpr TypeParam kNan = std::numeric_limits<TypeParam>::quiet_NaN();
  constexpr TypeParam kMax = std::numeric_limits<TypeParam>::max();
  EXPECT_TRUE(is_finite(Vec3<TypeParam>(kMax, kMax, -kMax)));
  for (int i = 0; i < 3; ++i) {
    Vec3<TypeParam> v = Vec3<TypeParam>::Zero();
    v[i] = kNan;
    EXPECT_FALSE(is_finite(v)) << i;
    v[i] = std::numeric_limits<TypeParam>::infinity();
    EXPECT_FALSE(is_finite(v)) << i;
  }
  EXPECT_TRUE(is_finite(Quat<TypeParam>::Identity()));
  EXPECT_TRUE(is_finite(Quat<TypeParam>(kMax, -kMax, kMax, kMax)));
  for (int i = 0; i < 4; ++i) {
    Quat<TypeParam> q = Quat<TypeParam>::Identity();
    q.coeffs()[i] = kNan;
    EXPECT_FALSE(is_finite(q)) << i;
    q.coeffs()[i] = -std::numeric_limits<TypeParam>::infinity();
    EXPECT_FALSE(is_finite(q)) << i;
  }
}

TYPED_TEST(Types, IsFinite_FindsOneBadNumberOfAnyMatrix) {
  constexpr TypeParam kMax = std::numeric_limits<TypeParam>::max();
  EXPECT_TRUE(is_finite(Mat3<TypeParam>::Constant(kMax)));
  for (int i = 0; i < 9; ++i) {
    Mat3<TypeParam> m = Mat3<TypeParam>::Identity();
    m.data()[i] = std::numeric_limits<TypeParam>::infinity();
    EXPECT_FALSE(is_finite(m)) << i;
  }
}

TYPED_TEST(Types, IsPositive_IsFiniteAndAboveZero) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam x : {TypeParam(1), Limits::max(), Limits::min(), Limits::denorm_min()}) {
    EXPECT_TRUE(is_positive(x)) << x;
  }
  for (const TypeParam x : {TypeParam(0), TypeParam(-0.0), TypeParam(-1), Limits::lowest(),
                            Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_FALSE(is_positive(x)) << x;
  }
}

/// Of infinite mass: 0. What is so heavy that its mass is no number is neither.
TYPED_TEST(Types, IsInverse_IsZeroOrOfAFiniteNumber) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam x : {TypeParam(0), TypeParam(-0.0), TypeParam(1), TypeParam(0.25),
                            Limits::max(), Limits::min()}) {
    EXPECT_TRUE(detail::is_inverse(x)) << x;
  }
  for (const TypeParam x : {TypeParam(-1), Limits::lowest(), -Limits::min(), Limits::denorm_min(),
                            -Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_FALSE(detail::is_inverse(x)) << x;
  }
}

TYPED_TEST(Types, ZeroAndUnitX_AreWhatEigenSays) {
  EXPECT_EQ(detail::zero<TypeParam>(), Vec3<TypeParam>::Zero());
  EXPECT_EQ(detail::unit_x<TypeParam>(), Vec3<TypeParam>::UnitX());
}

TYPED_TEST(Types, AddTo_AddsEachComponent) {
  Vec3<TypeParam> sum(1, 20, 300);
  detail::add_to(sum, Vec3<TypeParam>(4, -5, 6));
  EXPECT_EQ(sum, Vec3<TypeParam>(5, 15, 306));
}

TYPED_TEST(Types, IsZero_LooksAtEachComponent) {
  const TypeParam minus_zero = TypeParam(-0.0);
  EXPECT_TRUE(detail::is_zero(Vec3<TypeParam>(0, minus_zero, 0)));
  for (int i = 0; i < 3; ++i) {
    for (const TypeParam x : {TypeParam(1), std::numeric_limits<TypeParam>::quiet_NaN()}) {
      Vec3<TypeParam> v = Vec3<TypeParam>::Zero();
      v[i] = x;
      EXPECT_FALSE(detail::is_zero(v)) << i;
    }
  }
}

TYPED_TEST(Types, IsSame_LooksAtEachComponent) {
  const Vec3<TypeParam> v(1, 2, 3);
  const Quat<TypeParam> q(4, 1, 2, 3);
  EXPECT_TRUE(detail::is_same(v, Vec3<TypeParam>(1, 2, 3)));
  EXPECT_TRUE(detail::is_same(q, Quat<TypeParam>(4, 1, 2, 3)));
  for (const TypeParam x : {TypeParam(9), std::numeric_limits<TypeParam>::quiet_NaN()}) {
    for (int i = 0; i < 3; ++i) {
      Vec3<TypeParam> other = v;
      other[i] = x;
      EXPECT_FALSE(detail::is_same(v, other)) << i;
      EXPECT_FALSE(detail::is_same(other, v)) << i;
    }
    for (int i = 0; i < 4; ++i) {
      Quat<TypeParam> other = q;
      other.coeffs()[i] = x;
      EXPECT_FALSE(detail::is_same(q, other)) << i;
    }
    EXPECT_FALSE(detail::is_same(Vec3<TypeParam>(x, x, x), v));
    EXPECT_FALSE(detail::is_same(Quat<TypeParam>(x, x, x, x), q));
  }
}

TYPED_TEST(Types, MinMax_FirstWinsATie) {
  const TypeParam minus_zero = TypeParam(-0.0);
  EXPECT_TRUE(std::signbit(min_of(minus_zero, TypeParam(0))));
  EXPECT_FALSE(std::signbit(min_of(TypeParam(0), minus_zero)));
  EXPECT_TRUE(std::signbit(max_of(minus_zero, TypeParam(0))));
  EXPECT_FALSE(std::signbit(max_of(TypeParam(0), minus_zero)));
  EXPECT_EQ(min_of(TypeParam(1), TypeParam(2)), TypeParam(1));
  EXPECT_EQ(min_of(TypeParam(2), TypeParam(1)), TypeParam(1));
  EXPECT_EQ(max_of(TypeParam(1), TypeParam(2)), TypeParam(2));
  EXPECT_EQ(max_of(TypeParam(2), TypeParam(1)), TypeParam(2));
}

TYPED_TEST(Types, Clamp_StaysWithinBothEnds) {
  EXPECT_EQ(clamp(TypeParam(-2), TypeParam(-1), TypeParam(1)), TypeParam(-1));
  EXPECT_EQ(clamp(TypeParam(2), TypeParam(-1), TypeParam(1)), TypeParam(1));
  EXPECT_EQ(clamp(TypeParam(0.5), TypeParam(-1), TypeParam(1)), TypeParam(0.5));
}

TEST(EigenDeathTest, OwnChecks_ReachTheTrap) {
  Vec3<float> v = Vec3<float>::Zero();
  volatile int index = 3;
  EXPECT_DEATH(v(index) = 1.0F, "assert");
}

/// A user's own matrices may be of any size: the core alone does without memory.
TEST(Types, MatrixOfAUser_MayBeOfAnySize) {
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic> own(40, 40);
  own.setIdentity();
  EXPECT_EQ((own * own).sum(), 40);
}

}  // namespace
}  // namespace batuta
