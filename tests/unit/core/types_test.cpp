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
  Quat<TypeParam> q = Quat<TypeParam>::Identity();
  EXPECT_TRUE(is_finite(q));
  q.z() = kNan;
  EXPECT_FALSE(is_finite(q));
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

}  // namespace
}  // namespace batuta
