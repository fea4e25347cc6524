// SPDX-License-Identifier: MIT
#include "batuta/geometry/direction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace batuta {
namespace {

template <class Scalar>
class Direction : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Direction, Scalars);

TYPED_TEST(Direction, LengthOfPythagoreanVectors_AtEveryScale) {
  using Scalar = TypeParam;
  for (const Scalar scale : {Scalar(1e-36), Scalar(1e-18), Scalar(1), Scalar(1e18), Scalar(1e37)}) {
    const Vec3<Scalar> v = scale * Vec3<Scalar>(2, -3, 6);
    EXPECT_NEAR(length(v) / (7 * scale), 1, 6 * kRoundOff<Scalar>);
    EXPECT_NEAR(unit(v).z(), Scalar(6) / 7, 4 * kRoundOff<Scalar>);
  }
  EXPECT_EQ(length(Vec3<Scalar>(0, 0, 0)), 0);
}

TYPED_TEST(Direction, LengthOfWhatIsNotAllNumbers_IsNotANumber) {
  using Scalar = TypeParam;
  constexpr Scalar kNaN = std::numeric_limits<Scalar>::quiet_NaN();
  for (std::size_t i = 1; i < 27; ++i) {  // each component 0, 1 or NaN
    const std::array<Scalar, 3> digits = {Scalar(0), Scalar(1), kNaN};
    const Vec3<Scalar> v(digits[i % 3], digits[i / 3 % 3], digits[i / 9 % 3]);
    EXPECT_EQ(std::isnan(length(v)), v.hasNaN()) << "of digits " << i;
  }
}

TYPED_TEST(Direction, LargestComponent_IsTheLargestInSize) {
  using Scalar = TypeParam;
  EXPECT_EQ(detail::largest_component(Vec3<Scalar>(-3, 1, 2)), 3);
  EXPECT_EQ(detail::largest_component(Vec3<Scalar>(1, -3, 2)), 3);
  EXPECT_EQ(detail::largest_component(Vec3<Scalar>(1, 2, -3)), 3);
}

TYPED_TEST(Direction, Perpendicular_IsUnitAndAtRightAngles) {
  using Scalar = TypeParam;
  for (int i = 1; i < 125; ++i) {  // the grid {-2..2}^3, its middle left out
    const Vec3<Scalar> v(Scalar(i % 5 - 2), Scalar(i / 5 % 5 - 2), Scalar(i / 25 - 2));
    if (v.isZero(0)) continue;
    const Vec3<Scalar> p = detail::perpendicular(v);
    EXPECT_NEAR(p.norm(), 1, 4 * kRoundOff<Scalar>);
    EXPECT_NEAR(p.dot(v), 0, 8 * kRoundOff<Scalar>);
  }
}

TYPED_TEST(Direction, Perpendicular_OfTheAxes) {
  using Scalar = TypeParam;
  using V = Vec3<Scalar>;
  EXPECT_EQ(detail::perpendicular<Scalar>({5, 0, 0}), V(0, 0, -1));
  EXPECT_EQ(detail::perpendicular<Scalar>({0, 5, 0}), V(0, 0, 1));
  EXPECT_EQ(detail::perpendicular<Scalar>({0, 0, 5}), V(0, -1, 0));
  EXPECT_EQ(detail::perpendicular<Scalar>({3, 4, 0}), V(Scalar(-0.8), Scalar(0.6), 0));
}

TEST(DirectionDeathTest, UnitOfZero_IsACallersMistake) {
  EXPECT_DEATH(unit<float>({0, 0, 0}), "assertion failed");
}

}  // namespace
}  // namespace batuta
