// SPDX-License-Identifier: MIT
#include "batuta/response/separation.hpp"

#include <gtest/gtest.h>

namespace batuta {
namespace {

template <class Scalar>
class SeparationOf : public testing::Test {
 protected:
  static Contact<Scalar> gap(double metres) {
    return {Vec3<Scalar>::Zero(), Vec3<Scalar>::UnitY(), static_cast<Scalar>(metres)};
  }
  static SeparationOptions<Scalar> options() {
    SeparationOptions<Scalar> o;
    o.distance = Scalar(0.5);
    o.rest_speed = Scalar(0.25);
    o.min_duration = Scalar(0.125);
    return o;
  }
  static Separation<Scalar> separated(const Contact<Scalar>& contact, double v_rel, double im_A,
                                      double im_B, const SeparationOptions<Scalar>& o = options()) {
    const auto result = separate(contact, static_cast<Scalar>(v_rel), static_cast<Scalar>(im_A),
                                 static_cast<Scalar>(im_B), o);
    EXPECT_TRUE(result.ok());
    return result.value;
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SeparationOf, Scalars);

TYPED_TEST(SeparationOf, Touching_OpensTheGapToD) {
  const auto s = this->separated(this->gap(0), 0, 1, 1);
  EXPECT_EQ(s.shift_A_W, Vec3<TypeParam>(0, TypeParam(0.25), 0));
  EXPECT_EQ(s.shift_B_W, Vec3<TypeParam>(0, TypeParam(-0.25), 0));
}

TYPED_TEST(SeparationOf, Gap_IsRestoredToDAndNotAddedTo) {
  const auto open = this->separated(this->gap(0.375), 0, 1, 1);
  EXPECT_EQ(open.shift_A_W.y() - open.shift_B_W.y(), TypeParam(0.125));
  const auto deep = this->separated(this->gap(-1), 0, 1, 1);
  EXPECT_EQ(deep.shift_A_W.y() - deep.shift_B_W.y(), TypeParam(1.5));
  for (const double wide : {0.5, 2.0}) {
    const auto none = this->separated(this->gap(wide), 0, 1, 1);
    EXPECT_EQ(none.shift_A_W, Vec3<TypeParam>::Zero().eval());
    EXPECT_EQ(none.shift_B_W, Vec3<TypeParam>::Zero().eval());
    EXPECT_EQ(none.duration, TypeParam(1));  // time is charged all the same
  }
}

TYPED_TEST(SeparationOf, Shares_FollowInverseMasses) {
  const auto light_A = this->separated(this->gap(0), 0, 3, 1);
  EXPECT_EQ(light_A.shift_A_W.y(), TypeParam(0.375));
  EXPECT_EQ(light_A.shift_B_W.y(), TypeParam(-0.125));
  const auto fixed_A = this->separated(this->gap(0), 0, 0, 1);
  EXPECT_EQ(fixed_A.shift_A_W.y(), TypeParam(0));
  EXPECT_EQ(fixed_A.shift_B_W.y(), TypeParam(-0.5));
  const auto both_fixed = this->separated(this->gap(0), 0, 0, 0);
  EXPECT_EQ(both_fixed.shift_A_W.y(), TypeParam(0));
  EXPECT_EQ(both_fixed.shift_B_W.y(), TypeParam(0));
  const auto largest = static_cast<double>(std::numeric_limits<TypeParam>::max());
  EXPECT_EQ(this->separated(this->gap(0), 0, largest, largest).shift_A_W.y(), TypeParam(0.25));
}

TYPED_TEST(SeparationOf, Duration_IsHalfOfDAtTheRelativeSpeed) {
  EXPECT_EQ(this->separated(this->gap(0), 0, 1, 1).duration, TypeParam(1));       // D / (2 eps_r)
  EXPECT_EQ(this->separated(this->gap(0), -0.5, 1, 1).duration, TypeParam(0.5));  // D / (2 |v|)
  EXPECT_EQ(this->separated(this->gap(0), 0.5, 1, 1).duration, TypeParam(0.5));
  EXPECT_EQ(this->separated(this->gap(0), -100, 1, 1).duration, TypeParam(0.125));  // never less
}

TYPED_TEST(SeparationOf, WhatALimitCuts_TheOtherIsCutByAsMuch) {
  auto o = this->options();  // D = 0.5: a quarter each
  o.limit_A = TypeParam(0.125);
  const auto s = this->separated(this->gap(0), 0, 1, 1, o);
  EXPECT_EQ(s.shift_A_W.y(), TypeParam(0.125));
  EXPECT_EQ(s.shift_B_W.y(), TypeParam(-0.125)) << "the common centre stays";
  o.limit_B = TypeParam(0.0625);
  EXPECT_EQ(this->separated(this->gap(0), 0, 1, 1, o).shift_A_W.y(), TypeParam(0.0625));
  EXPECT_EQ(this->separated(this->gap(0), 0, 1, 1, o).shift_B_W.y(), TypeParam(-0.0625));
  EXPECT_EQ(this->separated(this->gap(0), 0, 1, 0, o).shift_B_W.y(), TypeParam(0)) << "fixed";
  o.limit_A = o.limit_B = TypeParam(0);
  const auto none = this->separated(this->gap(0), 0, 1, 1, o);
  EXPECT_EQ(none.shift_A_W.y(), TypeParam(0));
  EXPECT_EQ(none.shift_B_W.y(), TypeParam(0));
}

TYPED_TEST(SeparationOf, BadInput_IsRefused) {
  using S = TypeParam;
  using Options = SeparationOptions<S>;
  constexpr S kNan = std::numeric_limits<S>::quiet_NaN();
  const auto refused = [&](auto change) {
    Options o = this->options();
    change(o);
    return !separate(this->gap(0), S(0), S(1), S(1), o).ok();
  };
  EXPECT_TRUE(refused([](Options& o) { o.distance = S(0); }));
  EXPECT_TRUE(refused([](Options& o) { o.distance = kNan; }));
  EXPECT_TRUE(refused([](Options& o) { o.rest_speed = S(0); }));
  EXPECT_TRUE(refused([](Options& o) { o.min_duration = S(0); }));
  EXPECT_TRUE(refused([](Options& o) { o.limit_A = S(-1); }));
  EXPECT_TRUE(refused([](Options& o) { o.limit_B = kNan; }));
  EXPECT_FALSE(separate(this->gap(0), kNan, S(1), S(1), this->options()).ok());
  EXPECT_FALSE(separate(this->gap(0), S(0), S(-1), S(1), this->options()).ok());
  EXPECT_FALSE(separate(this->gap(0), S(0), S(1), kNan, this->options()).ok());
  EXPECT_FALSE(
      separate(this->gap(static_cast<double>(kNan)), S(0), S(1), S(1), this->options()).ok());
}

TYPED_TEST(SeparationOf, ShiftOrTimeBeyondTheNumbers_IsRefused) {
  constexpr TypeParam kMax = std::numeric_limits<TypeParam>::max();
  constexpr TypeParam kInfinity = std::numeric_limits<TypeParam>::infinity();
  auto o = this->options();
  o.distance = kMax;
  o.rest_speed = kMax;
  o.limit_A = o.limit_B = kInfinity;
  const Contact<TypeParam> deep = this->gap(-static_cast<double>(kMax));
  const auto far = separate(deep, TypeParam(0), TypeParam(1), TypeParam(0), o);
  EXPECT_EQ(far.status, Status::kInvalidArgument) << "twice the largest number";
  EXPECT_EQ(far.value.shift_A_W, (Vec3<TypeParam>::Zero()));
  const auto far_B = separate(deep, TypeParam(0), TypeParam(0), TypeParam(1), o);
  EXPECT_EQ(far_B.status, Status::kInvalidArgument);
  o.rest_speed = TypeParam(0.25);
  const auto late = separate(this->gap(0), TypeParam(0), TypeParam(1), TypeParam(1), o);
  EXPECT_EQ(late.status, Status::kInvalidArgument) << "D / (2 eps_r)";
  EXPECT_EQ(late.value.duration, TypeParam(0));
}

TYPED_TEST(SeparationOf, OptionsThatNobodyChose_AreRefused) {
  const SeparationOptions<TypeParam> none;
  EXPECT_FALSE(separate(this->gap(0), TypeParam(0), TypeParam(1), TypeParam(1), none).ok());
  auto o = this->options();
  EXPECT_GT(o.limit_A, TypeParam(1e30)) << "no neighbour";
  EXPECT_GT(o.limit_B, TypeParam(1e30));
  for (TypeParam SeparationOptions<TypeParam>::*member :
       {&SeparationOptions<TypeParam>::distance, &SeparationOptions<TypeParam>::rest_speed,
        &SeparationOptions<TypeParam>::min_duration}) {
    o = this->options();
    o.*member = none.*member;
    EXPECT_FALSE(separate(this->gap(0), TypeParam(0), TypeParam(1), TypeParam(1), o).ok());
  }
}

}  // namespace
}  // namespace batuta
