// SPDX-License-Identifier: MIT
#include "batuta/haptics/duel_hand.hpp"

#include <gtest/gtest.h>

namespace batuta {
using namespace haptics;
using namespace fencing;
namespace {

using Event = ContactEvent<float>;
using DuelEvents = Duel<>::WorldType::EventList;

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
TEST(BlowAbout, OneContact_GivesImpulseAndMomentOfTheHand) {
  DuelEvents events;
  ASSERT_TRUE(events.push(blow_at({1.5F, 2, 3}, Vec3<float>::UnitZ(), 2)));
  const Momentum<float> left = blow_about(Vec3<float>(1, 2, 3), Side::kLeft, events);
  EXPECT_EQ(left.linear_W, Vec3<float>(0, 0, 2));
  EXPECT_EQ(left.angular_W, Vec3<float>(0, -1, 0));
  const Momentum<float> right = blow_about(Vec3<float>(1, 2, 3), Side::kRight, events);
  EXPECT_EQ(right.linear_W, Vec3<float>(0, 0, -2));
  EXPECT_EQ(right.angular_W, Vec3<float>(0, 1, 0));
}

TEST(BlowAbout, SeveralContacts_AddUp_AndThoseWithoutImpulseAddNothing) {
  DuelEvents events;
  ASSERT_TRUE(events.push(blow_at({1, 0, 0}, Vec3<float>::UnitY(), 2)));
  ASSERT_TRUE(events.push(blow_at({9, 9, 9}, Vec3<float>::UnitX(), 0)));
  ASSERT_TRUE(events.push(blow_at({-1, 0, 0}, Vec3<float>::UnitY(), 1)));
  const Momentum<float> blow = blow_about(Vec3<float>(0, 0, 0), Side::kLeft, events);
  EXPECT_EQ(blow.linear_W, Vec3<float>(0, 3, 0));
  EXPECT_EQ(blow.angular_W, Vec3<float>(0, 0, 2 - 1));
}

}  // namespace
}  // namespace batuta
