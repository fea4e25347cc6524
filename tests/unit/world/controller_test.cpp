// SPDX-License-Identifier: MIT
#include "batuta/world/controller.hpp"

#include <gtest/gtest.h>

#include "batuta/world/any_controller.hpp"

namespace batuta {
namespace {

template <class Scalar>
class Controller : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Controller, Scalars);

template <class Scalar>
constexpr double kSmall = 64.0 * static_cast<double>(kRoundOff<Scalar>);

template <class Scalar>
Body<Scalar> flying_body() {
  const Pose<Scalar> X = {{1, 2, 3}, Quat<Scalar>(Scalar(0.6), Scalar(0.8), 0, 0)};
  Body<Scalar> body = make_body(X, Scalar(2), Vec3<Scalar>(1, 4, 4)).value;
  body.momentum = {{2, -4, 6}, {1, 2, 3}};
  return body;
}

/// Quarter turn about z, one metre along x.
template <class Scalar>
Pose<Scalar> target_of(const Pose<Scalar>& X) {
  const auto half = static_cast<Scalar>(0.70710678118654752);
  return {X.p_W + Vec3<Scalar>::UnitX(), Quat<Scalar>(half, 0, 0, half) * X.q_WB};
}

template <class Scalar>
void expect_near(const Pose<Scalar>& X, const Pose<Scalar>& Y) {
  EXPECT_LE((X.p_W - Y.p_W).norm(), kSmall<Scalar>);
  EXPECT_NEAR(std::fabs(static_cast<double>(X.q_WB.dot(Y.q_WB))), 1, kSmall<Scalar>);
}

TYPED_TEST(Controller, Fixed_StandsStillWhateverItsMomentum) {
  const Body<TypeParam> body = flying_body<TypeParam>();
  Fixed<TypeParam> fixed;
  fixed.on_contact(body, {});
  fixed.on_step_end(body, TypeParam(1));
  const PlannedMotion<TypeParam> course = fixed.plan(body, TypeParam(0.25), TypeParam(0.75));
  EXPECT_FALSE(course.by_momentum);
  EXPECT_EQ(course.motion.duration, TypeParam(0.75));
  const Pose<TypeParam> end = pose_at(course.motion, TypeParam(0.75));
  EXPECT_EQ(end.p_W, body.X_WB.p_W);
  EXPECT_EQ(end.q_WB.coeffs(), body.X_WB.q_WB.coeffs());
}

TYPED_TEST(Controller, FreeFlight_FliesByItsMomentum) {
  const Body<TypeParam> body = flying_body<TypeParam>();
  FreeFlight<TypeParam> flight;
  flight.on_contact(body, {});
  flight.on_step_end(body, TypeParam(1));
  const PlannedMotion<TypeParam> course = flight.plan(body, TypeParam(0), TypeParam(0.5));
  EXPECT_TRUE(course.by_momentum);
  EXPECT_EQ(course.motion.duration, TypeParam(0.5));
  EXPECT_EQ(course.motion.twist.v_W, Vec3<TypeParam>(1, -2, 3));
  EXPECT_EQ(course.motion.twist.w_W, Vec3<TypeParam>(body.momentum.angular_W / 4));
}

TYPED_TEST(Controller, Hand_IsAtItsTargetWhenTheStepEnds) {
  const Body<TypeParam> body = flying_body<TypeParam>();
  const auto dt = static_cast<TypeParam>(0.01);
  const Hand<TypeParam> hand = {target_of(body.X_WB), dt};
  const PlannedMotion<TypeParam> course = hand.plan(body, TypeParam(0), dt);
  EXPECT_FALSE(course.by_momentum);
  EXPECT_EQ(course.motion.duration, dt);
  expect_near(pose_at(course.motion, dt), hand.target_W);
}

TYPED_TEST(Controller, HandPushedAsideOnItsWay_StillArrives) {
  Body<TypeParam> body = flying_body<TypeParam>();
  const auto dt = static_cast<TypeParam>(0.01);
  const auto t = static_cast<TypeParam>(0.004);
  Hand<TypeParam> hand = {target_of(body.X_WB), dt};
  body.X_WB = pose_at(hand.plan(body, TypeParam(0), dt).motion, t);
  body.X_WB.p_W += Vec3<TypeParam>(0, TypeParam(0.1), 0);
  hand.on_contact(body, {});
  const PlannedMotion<TypeParam> rest = hand.plan(body, t, dt - t);
  EXPECT_EQ(rest.motion.duration, dt - t);
  expect_near(pose_at(rest.motion, dt - t), hand.target_W);
  hand.on_step_end(body, dt);
}

TYPED_TEST(Controller, HandAskedForLessThanItsStep_IsOnItsWay) {
  const Body<TypeParam> body = flying_body<TypeParam>();
  const Hand<TypeParam> hand = {target_of(body.X_WB), TypeParam(1)};
  const PlannedMotion<TypeParam> course = hand.plan(body, TypeParam(0), TypeParam(0.5));
  EXPECT_EQ(course.motion.duration, TypeParam(0.5));
  const Pose<TypeParam> half_way = pose_at(course.motion, TypeParam(0.5));
  EXPECT_NEAR(half_way.p_W.x(), 1.5, kSmall<TypeParam>);
}

TYPED_TEST(Controller, HandAskedForMoreThanItsStep_NeverGoesPastItsTarget) {
  const Body<TypeParam> body = flying_body<TypeParam>();
  const Hand<TypeParam> hand = {target_of(body.X_WB), TypeParam(1)};
  const TypeParam duration(2);
  for (const TypeParam t : {TypeParam(0), TypeParam(1), TypeParam(1.5)}) {
    const PlannedMotion<TypeParam> course = hand.plan(body, t, duration);
    EXPECT_EQ(course.motion.duration, duration);
    expect_near(pose_at(course.motion, duration), hand.target_W);
  }
}

TYPED_TEST(Controller, HandPushedAsideAtTheEndOfItsStep_IsLateRatherThanFast) {
  const Body<TypeParam> body = flying_body<TypeParam>();
  const Hand<TypeParam> hand = {target_of(body.X_WB), TypeParam(1)};
  const TypeParam way = (hand.target_W.p_W - body.X_WB.p_W).norm();
  for (const TypeParam left : {TypeParam(0), TypeParam(1e-6)}) {
    const PlannedMotion<TypeParam> course = hand.plan(body, TypeParam(1) - left, left);
    EXPECT_LE(course.motion.twist.v_W.norm(), TypeParam(8.001) * way);
    EXPECT_TRUE(is_valid(course.motion));
  }
}

TYPED_TEST(Controller, HandWithoutAStep_StandsStill) {
  const Body<TypeParam> body = flying_body<TypeParam>();
  const Hand<TypeParam> hand = {target_of(body.X_WB), TypeParam(0)};
  const PlannedMotion<TypeParam> course = hand.plan(body, TypeParam(0), TypeParam(0));
  EXPECT_EQ(course.motion.twist.v_W, Vec3<TypeParam>(0, 0, 0));
  EXPECT_TRUE(is_valid(course.motion));
}

TYPED_TEST(Controller, AnyController_IsTheOneItHolds) {
  using Any = AnyController<TypeParam, Fixed<TypeParam>, FreeFlight<TypeParam>, Hand<TypeParam>>;
  const Body<TypeParam> body = flying_body<TypeParam>();
  Any controller;
  EXPECT_NE(controller.template as<Fixed<TypeParam>>(), nullptr);
  EXPECT_EQ(controller.plan(body, 0, 1).motion.twist.v_W, Vec3<TypeParam>(0, 0, 0));

  controller = FreeFlight<TypeParam>{};
  EXPECT_TRUE(controller.plan(body, 0, 1).by_momentum);
  EXPECT_EQ(controller.template as<Fixed<TypeParam>>(), nullptr);

  controller = Hand<TypeParam>{target_of(body.X_WB), 1};
  ASSERT_NE(controller.template as<Hand<TypeParam>>(), nullptr);
  controller.on_contact(body, {});
  controller.on_step_end(body, 1);
  expect_near(pose_at(controller.plan(body, 0, 1).motion, TypeParam(1)), target_of(body.X_WB));
}

}  // namespace
}  // namespace batuta
