// SPDX-License-Identifier: MIT
#include "batuta/mechanics/straight.hpp"

#include <gtest/gtest.h>

namespace batuta {
namespace {

template <class Scalar>
class Straight : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Straight, Scalars);

template <class Scalar>
constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
template <class Scalar>
constexpr Scalar kNan = std::numeric_limits<Scalar>::quiet_NaN();

TYPED_TEST(Straight, NewBody_RestsWhereItWasPut) {
  const Vec3<TypeParam> p_W(1, 2, 3);
  const auto made = make_straight_body<TypeParam>(p_W, 4);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made.value.p_W, p_W);
  EXPECT_EQ(made.value.inverse_mass, TypeParam(0.25));
  EXPECT_EQ(velocity_of(made.value), Vec3<TypeParam>::Zero());
  EXPECT_EQ(kinetic_energy(made.value), TypeParam(0));
}

TYPED_TEST(Straight, InfiniteMass_IsFixed) {
  auto made = make_straight_body<TypeParam>({0, 0, 0}, kInfinity<TypeParam>);
  ASSERT_TRUE(made.ok());
  made.value.momentum_W = {5, 0, 0};
  EXPECT_EQ(velocity_of(made.value), Vec3<TypeParam>::Zero());
  EXPECT_EQ(kinetic_energy(made.value), TypeParam(0));
}

TYPED_TEST(Straight, WhatIsNoBody_IsRefused) {
  using S = TypeParam;
  const S denormal = std::numeric_limits<S>::denorm_min();
  for (const S mass : {S(0), S(-1), -kInfinity<S>, kNan<S>, denormal}) {
    EXPECT_EQ(make_straight_body<S>({0, 0, 0}, mass).status, Status::kInvalidArgument) << mass;
  }
  for (const S x : {kNan<S>, kInfinity<S>, -kInfinity<S>}) {
    EXPECT_EQ(make_straight_body<S>({0, x, 0}, 1).status, Status::kInvalidArgument) << x;
  }
}

/// Powers of two: nothing is rounded.
TYPED_TEST(Straight, MovingBody_VelocityAndEnergyOfItsMomentum) {
  StraightBody<TypeParam> body;
  body.inverse_mass = TypeParam(0.5);
  body.momentum_W = {2, -4, 8};
  EXPECT_EQ(velocity_of(body), Vec3<TypeParam>(1, -2, 4));
  EXPECT_EQ(kinetic_energy(body), TypeParam(21));
}

TYPED_TEST(Straight, Position_StartsWhereItIsAndMovesEvenly) {
  const detail::StraightMotion<TypeParam> motion{{TypeParam(0.1), 2, 3}, {1, -2, 4}, 2};
  EXPECT_EQ(detail::position_at(motion, TypeParam(0)), motion.p_W);
  EXPECT_EQ(detail::position_at(motion, TypeParam(2)), Vec3<TypeParam>(TypeParam(2.1), -2, 11));
}

TYPED_TEST(Straight, Motion_ValidIfFiniteAndForward) {
  using S = TypeParam;
  const detail::StraightMotion<S> good{{1, 2, 3}, {4, 5, 6}, 0};
  EXPECT_TRUE(is_valid(good));
  for (const S x : {kNan<S>, kInfinity<S>, -kInfinity<S>}) {
    for (int i = 0; i < 3; ++i) {
      auto bad = good;
      bad.p_W[i] = x;
      EXPECT_FALSE(is_valid(bad));
      bad = good;
      bad.v_W[i] = x;
      EXPECT_FALSE(is_valid(bad));
    }
    auto bad = good;
    bad.duration = x;
    EXPECT_FALSE(is_valid(bad));
  }
  auto bad = good;
  bad.duration = -1;
  EXPECT_FALSE(is_valid(bad));
}

}  // namespace
}  // namespace batuta
