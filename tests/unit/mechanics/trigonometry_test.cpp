// SPDX-License-Identifier: MIT
#include "batuta/mechanics/trigonometry.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "samples.hpp"

namespace batuta {
namespace {

using samples::Real;
using samples::Source;
using samples::ulps;

constexpr double kSinCosBound = 1.0;  // promised 1.5, measured 0.98: every term of the sums counts
constexpr double kArcTangentBound = 2.0;
constexpr Real kHalfPi = 1.57079632679489661923132169163975144L;

/// The largest errors seen, in ulps.
struct Worst {
  double sin = 0;
  double cos = 0;

  template <class Scalar>
  void look_at(Scalar angle) {
    const detail::SinCos<Scalar> value = detail::sin_cos(angle);
    sin = std::max(sin, ulps(value.sin, std::sin(static_cast<Real>(angle))));
    cos = std::max(cos, ulps(value.cos, std::cos(static_cast<Real>(angle))));
  }
  void expect_within_bound() const {
    EXPECT_LE(sin, kSinCosBound);
    EXPECT_LE(cos, kSinCosBound);
    EXPECT_GT(sin + cos, 0.5) << "nothing was looked at";
  }
};

float float_of_bits(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

template <class Scalar>
class Trigonometry : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Trigonometry, Scalars);

TEST(SinCosFloat, EveryHundredthFloatOfTheRange_WithinBound) {
  Worst worst;
  constexpr std::uint32_t kStride = 101;
  for (std::uint32_t bits = bits_of(0x1p-13F); bits <= bits_of(detail::kMaxAngle<float>);
       bits += kStride) {
    worst.look_at(float_of_bits(bits));
  }
  worst.expect_within_bound();
}

TYPED_TEST(Trigonometry, AnglesOfAllSizes_WithinBound) {
  Source<TypeParam> source(7);
  Worst worst;
  for (int i = 0; i < 300000; ++i) {
    worst.look_at(source.uniform(-2526, 2526));
    worst.look_at(source.uniform(-4, 4));
    worst.look_at(source.log_uniform(1e-12, 1));
  }
  worst.expect_within_bound();
}

TYPED_TEST(Trigonometry, NeighboursOfEveryQuarterTurn_WithinBound) {
  Worst worst;
  for (int quarters = 1; quarters <= 1608; ++quarters) {
    for (const Real offset :
         {Real(0), kHalfPi / 2}) {  // and the middles, where the quadrant switches
      auto angle = static_cast<TypeParam>(quarters * kHalfPi - offset);
      for (int i = 0; i < 20; ++i) angle = std::nextafter(angle, TypeParam(0));
      for (int i = 0; i < 40; ++i) {
        if (angle <= detail::kMaxAngle<TypeParam>) worst.look_at(angle);
        worst.look_at(-angle);
        angle = std::nextafter(angle, TypeParam(10000));
      }
    }
  }
  worst.expect_within_bound();
}

TYPED_TEST(Trigonometry, SmallAngles_AreTheirOwnSine) {
  using Limits = std::numeric_limits<TypeParam>;
  EXPECT_EQ(detail::sin_cos(TypeParam(0)).sin, TypeParam(0));
  EXPECT_EQ(detail::sin_cos(TypeParam(0)).cos, TypeParam(1));
  for (const TypeParam x :
       {Limits::denorm_min(), Limits::min(), TypeParam(1e-30), TypeParam(1e-8)}) {
    EXPECT_EQ(detail::sin_cos(x).sin, x);
    EXPECT_EQ(detail::sin_cos(-x).sin, -x);
    EXPECT_EQ(detail::sin_cos(x).cos, TypeParam(1));
  }
}

TYPED_TEST(Trigonometry, OppositeAngle_SameCosineOppositeSine) {
  Source<TypeParam> source(8);
  for (int i = 0; i < 10000; ++i) {
    const TypeParam x = source.uniform(0, 2526);
    EXPECT_EQ(detail::sin_cos(-x).sin, -detail::sin_cos(x).sin);
    EXPECT_EQ(detail::sin_cos(-x).cos, detail::sin_cos(x).cos);
  }
}

TYPED_TEST(Trigonometry, EndOfTheRange_StandsTheRoundingOfTheCaller) {
  const TypeParam largest = detail::kMaxAngle<TypeParam>;
  Worst worst;
  for (const TypeParam x : {largest, std::nextafter(largest, 2 * largest), largest + 1}) {
    worst.look_at(x);
    worst.look_at(-x);
  }
  EXPECT_LE(worst.sin, kSinCosBound);
  EXPECT_LE(worst.cos, kSinCosBound);
}

TYPED_TEST(Trigonometry, AngleOutOfRange_IsTheCallersMistake) {
  EXPECT_DEATH((void)detail::sin_cos(TypeParam(2) * detail::kMaxAngle<TypeParam>), "");
  EXPECT_DEATH((void)detail::sin_cos(TypeParam(-1e30)), "");
  EXPECT_DEATH((void)detail::sin_cos(std::numeric_limits<TypeParam>::quiet_NaN()), "");
}

template <class Scalar>
double arc_tangent_error(Scalar y, Scalar x) {
  return ulps(detail::arc_tangent(y, x), std::atan2(static_cast<Real>(y), static_cast<Real>(x)));
}

TYPED_TEST(Trigonometry, ArcTangentOfRandomPoints_WithinBound) {
  Source<TypeParam> source(9);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const TypeParam y = source.uniform(-1, 1);
    worst = std::max(worst, arc_tangent_error(y, source.uniform(-1, 1)));
    worst = std::max(worst, arc_tangent_error(y, source.uniform(-0.01, 0.01)));
    worst = std::max(worst, arc_tangent_error(y, source.uniform(-100, 100)));
  }
  EXPECT_LE(worst, kArcTangentBound);
  EXPECT_GT(worst, 0.5) << "nothing was looked at";
}

TYPED_TEST(Trigonometry, ArcTangentWhereTheFormulaSwitches_WithinBound) {
  for (const TypeParam slope : {TypeParam(0.5), TypeParam(1), TypeParam(2)}) {
    TypeParam y = slope;
    for (int i = 0; i < 50; ++i) y = std::nextafter(y, TypeParam(0));
    for (int i = 0; i < 100; ++i) {
      for (const TypeParam x : {TypeParam(1), TypeParam(-1)}) {
        EXPECT_LE(arc_tangent_error(y, x), kArcTangentBound);
        EXPECT_LE(arc_tangent_error(-y, x), kArcTangentBound);
      }
      y = std::nextafter(y, TypeParam(4));
    }
  }
}

TYPED_TEST(Trigonometry, ArcTangentOnTheAxes_IsTheRoundedQuarterTurn) {
  const auto half_pi = static_cast<TypeParam>(kHalfPi);
  EXPECT_EQ(detail::arc_tangent(TypeParam(0), TypeParam(0)), TypeParam(0));
  EXPECT_EQ(detail::arc_tangent(TypeParam(-0.0), TypeParam(-0.0)), TypeParam(0));
  EXPECT_EQ(detail::arc_tangent(TypeParam(0), TypeParam(3)), TypeParam(0));
  EXPECT_EQ(detail::arc_tangent(TypeParam(2), TypeParam(0)), half_pi);
  EXPECT_EQ(detail::arc_tangent(TypeParam(-2), TypeParam(0)), -half_pi);
  EXPECT_EQ(detail::arc_tangent(TypeParam(0), TypeParam(-3)), 2 * half_pi);
  EXPECT_EQ(detail::arc_tangent(TypeParam(-0.0), TypeParam(-3)), 2 * half_pi);
  EXPECT_EQ(detail::arc_tangent(TypeParam(1), TypeParam(1)), half_pi / 2);
}

TYPED_TEST(Trigonometry, ArcTangentOfExtremePoints_WithinBound) {
  using Limits = std::numeric_limits<TypeParam>;
  const std::array<TypeParam, 7> sizes = {
      Limits::denorm_min(), Limits::min(),     3 * Limits::denorm_min(),
      TypeParam(1),         Limits::max() / 3, Limits::max() * TypeParam(0.75),
      Limits::max()};
  for (const TypeParam y : sizes) {
    for (const TypeParam x : sizes) {
      EXPECT_LE(arc_tangent_error(y, x), kArcTangentBound) << y << ", " << x;
      EXPECT_LE(arc_tangent_error(-y, -x), kArcTangentBound) << -y << ", " << -x;
    }
  }
}

}  // namespace
}  // namespace batuta
