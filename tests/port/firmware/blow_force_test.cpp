// SPDX-License-Identifier: MIT
#include "firmware/blow_force.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace batuta::firmware {
namespace {

using Event = ContactEvent<float>;

Event blow_at(const Vec3<float>& point_W, const Vec3<float>& normal_BA_W, float impulse) {
  Event event;
  event.contact_kind = ContactKind::kColliding;
  event.contact.point_W = point_W;
  event.contact.normal_BA_W = normal_BA_W;
  event.impulse = impulse;
  return event;
}

// By hand: hand at (1, 2, 3), contact half a metre before it along x, normal +z, 2 N s.
// Left: impulse (0, 0, 2); lever (0.5, 0, 0); moment (0.5, 0, 0) x (0, 0, 2) = (0, -1, 0).
TEST(BlowForce, OneContact_GivesImpulseAndMomentOfTheHand) {
  DuelEvents events;
  ASSERT_TRUE(events.push(blow_at({1.5F, 2, 3}, Vec3<float>::UnitZ(), 2)));
  const Momentum<float> left = blow_about({1, 2, 3}, Side::kLeft, events);
  EXPECT_EQ(left.p_W, Vec3<float>(0, 0, 2));
  EXPECT_EQ(left.b_W, Vec3<float>(0, -1, 0));
  const Momentum<float> right = blow_about({1, 2, 3}, Side::kRight, events);
  EXPECT_EQ(right.p_W, Vec3<float>(0, 0, -2));
  EXPECT_EQ(right.b_W, Vec3<float>(0, 1, 0));
}

TEST(BlowForce, SeveralContacts_AddUp_AndThoseWithoutImpulseAddNothing) {
  DuelEvents events;
  ASSERT_TRUE(events.push(blow_at({1, 0, 0}, Vec3<float>::UnitY(), 2)));
  ASSERT_TRUE(events.push(blow_at({9, 9, 9}, Vec3<float>::UnitX(), 0)));
  ASSERT_TRUE(events.push(blow_at({-1, 0, 0}, Vec3<float>::UnitY(), 1)));
  const Momentum<float> blow = blow_about(Vec3<float>::Zero(), Side::kLeft, events);
  EXPECT_EQ(blow.p_W, Vec3<float>(0, 3, 0));
  EXPECT_EQ(blow.b_W, Vec3<float>(0, 0, 2 - 1));
}

// By hand: stick x moves the hand 0.25 m along W's y; stick y turns it 2 rad about W's z.
TEST(BlowForce, TheTransposedJacobian_BringsItToTheStick) {
  StickJacobian<float> jacobian = StickJacobian<float>::Zero();
  jacobian(1, 0) = 0.25F;
  jacobian(5, 1) = 2.0F;
  const Momentum<float> blow = {{5, 3, 7}, {11, 13, -0.5F}};
  const Vec2<float> force = stick_force(jacobian, blow, 0.5F);
  EXPECT_EQ(force.x(), 0.25F * 3 / 0.5F);
  EXPECT_EQ(force.y(), 2 * -0.5F / 0.5F);
}

TEST(BlowForce, AtTheStick_DoesTheWorkThatTheBlowDoesAtTheHand) {
  StickJacobian<float> jacobian;
  for (int i = 0; i < 12; ++i)
    jacobian(i / 2, i % 2) = 0.1F * static_cast<float>((7 * i) % 11) - 0.4F;
  const Momentum<float> blow = {{0.3F, -0.2F, 0.7F}, {0.1F, 0.5F, -0.6F}};
  const Vec2<float> rate(1.5F, -0.75F);
  const Twist<float> twist = hand_twist(jacobian, rate);
  const float at_hand = blow.p_W.dot(twist.v_W) + blow.b_W.dot(twist.w_W);
  EXPECT_NEAR(stick_force(jacobian, blow, 1).dot(rate), at_hand, 1e-6F);
}

TEST(BlowForce, WithinTheRange_IsAShareOfIt) {
  const ForceShare half = as_share({50, -25}, 100);
  EXPECT_EQ(half.share, Vec2<float>(0.5F, -0.25F));
  EXPECT_FALSE(half.limited);
  EXPECT_FALSE(as_share({100, -100}, 100).limited);
}

TEST(BlowForce, BeyondTheRange_KeepsItsDirection_AndSaysSo) {
  const ForceShare share = as_share({-400, 100}, 100);
  EXPECT_EQ(share.share, Vec2<float>(-1, 0.25F));
  EXPECT_TRUE(share.limited);
}

TEST(BlowForce, WhateverTheForce_TheShareIsInTheUnitSquare) {
  const float largest = std::numeric_limits<float>::max();
  for (const float x : {0.0F, 1e-38F, 99.999F, 100.001F, 3e7F, largest}) {
    for (const float y : {0.0F, -1e-38F, -77.7F, -3.3e7F, -largest}) {
      const Vec2<float> share = as_share({x, y}, 100).share;
      EXPECT_TRUE(std::abs(share.x()) <= 1 && std::abs(share.y()) <= 1) << x << " " << y;
    }
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vec2<float>& bad : {Vec2<float>(nan, 1), Vec2<float>(1, nan),
                                 Vec2<float>(std::numeric_limits<float>::infinity(), 0)}) {
    EXPECT_EQ(as_share(bad, 100).share, Vec2<float>(0, 0));
    EXPECT_TRUE(as_share(bad, 100).limited);
  }
}

}  // namespace
}  // namespace batuta::firmware
