// SPDX-License-Identifier: MIT
// What a touch is: an entry of the point, from outside, along the blade, by a hand that has its
// weapon in its power (src/fencing/touch.md). Hands go where keys of their own lead them, so that
// speeds and places are known.
#include <algorithm>
#include <cmath>

#include "touch_rule.hpp"

namespace batuta {
using namespace fencing;
namespace {

using test::kFront;
using test::kMiddle;
using test::kReach;
using test::kTrunkX;
using test::TouchRule;
using test::way_of;

TEST_F(TouchRule, Thrust_TouchesWithThePoint) {
  begin();
  thrust(kFront + 0.1, 3);
  ASSERT_EQ(touches(), 1);
  EXPECT_EQ(touch().by, Side::kLeft);
  EXPECT_EQ(touch().part, BodyPart::kTorso);
  EXPECT_NEAR(touch().place, 1, 1e-5) << "the round end comes first";
  EXPECT_NEAR(touch().contact.point_W.x(), 2.25 / 2 - 0.13, 2e-3);
}

// The speed along the blade is that of the hand, which goes straight forward.
TEST_F(TouchRule, ThrustSlowerThanTheLeastSpeed_IsNone) {
  for (const bool fast : {false, true}) {
    begin();
    thrust(kFront + 0.1, fast ? 1.02F : 0.98F);
    EXPECT_EQ(touches(), fast ? 1 : 0);
    EXPECT_GT(duel->report().touch_searches, 0U) << "it was there";
  }
  settings.least_speed = 0.9F;
  begin();
  thrust(kFront + 0.1, 0.98F);
  EXPECT_EQ(touches(), 1);
}

// The point is swept sideways onto the trunk: no speed along the blade. With the least speed at 0
// the same cut counts.
TEST_F(TouchRule, Cut_IsNone) {
  left_keys = way_of({1.2F, -1.0F, 1.15F}, {1.21F, 1.0F, 1.15F});
  for (const bool counts : {false, true}) {
    if (counts) settings.least_speed = 0;
    begin();
    at.y() = -0.6F;  // beside him
    wait(200);
    ASSERT_EQ(touches(), 0);
    const auto before = duel->report().touch_searches;
    go(at, -0.05F, 4);
    EXPECT_EQ(touches(), counts ? 1 : 0);
    EXPECT_GT(duel->report().touch_searches, before);
  }
}

// Where a cut meets the trunk is known: so far from the hand, less the 0.1 m in front of it, of a
// blade of 0.9 m. Where the point begins behind that, the rest of the blade is stopped before it. A
// point longer than the blade is all of it.
TEST_F(TouchRule, Place_IsThatOnTheWholeBlade) {
  left_keys = way_of({1.27F, -1.0F, 1.15F}, {1.28F, 1.0F, 1.15F});  // it passes the arm behind
  settings.least_speed = 0;
  const double middle = (kTrunkX - 1.27 - 0.1) / 0.9;
  for (const float length : {0.1F, 0.24F, 0.3F, 0.6F, 0.9F, 50.0F}) {
    settings.point_length = length;
    begin();
    at.y() = -0.6F;
    wait(200);
    go(at, -0.05F, 4);
    ASSERT_EQ(touches(), 1) << length;
    EXPECT_NEAR(touch().place, middle, 0.01) << length;
  }
  settings.point_length = 0.02F;
  left_keys = way_of({1.5F, -1.0F, 1.15F}, {1.51F, 1.0F, 1.15F});
  begin();
  at.y() = -0.6F;
  wait(200);
  go(at, -0.05F, 4);
  EXPECT_EQ(touches(), 0) << "what the rest of a blade meets is none";
}

/// The point lies still before the trunk. The other's blade taps it, goes away, and he walks onto
/// the point, faster than the least speed.
TEST_F(TouchRule, HandThatIsBeaten_DoesNotScore) {
  for (const bool beaten : {false, true}) {
    left = first_fencer<float>();
    left.grip.composure = beaten ? 1e-6F : 100.0F;  // any blow beats the hand, or none
    left.grip.forte = 0.01F;
    left.grip.settle_torque = 1e-3F;
    left.grip.max_lost = 5;
    begin();
    thrust(kFront - 0.25, 0.5F);
    go(other_at, 0.9F, 1);
    go(other_at, 0, 4);
    wait(600);
    EXPECT_GT(duel->report().blows, 0U);
    ASSERT_EQ(touches(), 0);
    EXPECT_EQ(duel->grip(Side::kLeft).phase(), beaten ? GripPhase::kBeaten : GripPhase::kHeld);
    const float tip = duel->blade_W(Side::kLeft).axis.b.x();
    other_feet = 1;
    wait(300);
    other_feet = 0;
    EXPECT_EQ(touches(), beaten ? 0 : 1);
    EXPECT_GT(tip, duel->X_WF(Side::kRight).p_W.x() - 0.13F) << "he has walked onto it";
  }
}

// The part in which the point lies stays closed until it has been 4 mm away.
TEST_F(TouchRule, EnteredWithoutATouch_IsClosedUntilThePointHasLeft) {
  for (const double away : {0.002, 0.0035, 0.0045, 0.02}) {
    begin();
    thrust(kFront + 0.001, 0.5F);  // pressed in by half of what gives way
    ASSERT_EQ(touches(), 0) << "too slow";
    thrust(kFront - away, 0.5F);
    wait(100);
    thrust(kFront + 0.1, 3);
    EXPECT_EQ(touches(), away > 0.004 ? 1 : 0) << away;
  }
}

TEST_F(TouchRule, PointThatPresses_DoesNotTouchByPressingFast) {
  begin();
  thrust(kFront + 0.001, 0.5F);
  thrust(kFront + 0.06, 3);
  EXPECT_EQ(touches(), 0) << "fast, but it was inside";
}

// Through the edge of the trunk, slowly, and fast from within it into the arm behind it.
TEST_F(TouchRule, OtherParts_StayOpen) {
  left_keys = way_of({kMiddle - kReach, -0.115F, 1.36F}, {kMiddle + kReach, -0.115F, 1.36F});
  settings.target = mask_of(BodyPart::kTorso) | mask_of(BodyPart::kOtherUpperArm);
  settings.point_length = 0.3F;  // it is still in the trunk when it comes to the arm
  begin();
  thrust(kTrunkX - 1, 0.5F);
  ASSERT_EQ(touches(), 0);
  thrust(kTrunkX - 1 + 0.2, 3);
  ASSERT_EQ(touches(), 1);
  EXPECT_EQ(touch().part, BodyPart::kOtherUpperArm);
}

// At this height the trunk's front is 2.2 mm before that of the pelvis: slowly into the one, and
// from there, before the point is 4 mm away from either, fast into the other.
TEST_F(TouchRule, PartsBeside_StayOpen) {
  constexpr float kHeight = 0.9315F;  // spheres of 0.13 m about heights of 1.01 and 0.85
  const auto front = [](double of_part) {
    const double up = of_part - 0.9315;
    return kTrunkX - 1 - std::sqrt(0.1345 * 0.1345 - up * up);
  };
  ASSERT_NEAR(front(0.85) - front(1.01), 0.0022, 1e-4);
  left_keys = way_of({kMiddle - kReach, 0, kHeight}, {kMiddle + kReach, 0, kHeight});
  settings.target = mask_of(BodyPart::kTorso) | mask_of(BodyPart::kPelvis);
  begin();
  thrust(front(1.01) + 0.001, 0.5F);
  ASSERT_EQ(touches(), 0);
  thrust(front(0.85) + 0.05, 3);
  ASSERT_EQ(touches(), 1);
  EXPECT_EQ(touch().part, BodyPart::kPelvis);
}

TEST_F(TouchRule, InTheNextExchange_EveryPartIsOpen) {
  settings.touches = 2;
  settings.halt_us = 100000;
  settings.target = mask_of(BodyPart::kTorso) | mask_of(BodyPart::kOtherUpperArm);
  settings.point_length = 0.3F;
  left_keys = way_of({kMiddle - kReach, -0.115F, 1.36F}, {kMiddle + kReach, -0.115F, 1.36F});
  begin();
  thrust(kTrunkX - 1, 0.5F);
  thrust(kTrunkX - 1 + 0.2, 3);
  wait(50);
  ASSERT_EQ(duel->bout().state, BoutState::kHalt);
  thrust(kMiddle, 3);
  while (duel->bout().state == BoutState::kHalt) step();
  thrust(kTrunkX - 1 + 0.2, 3);
  ASSERT_EQ(touches(), 1);
  EXPECT_EQ(touch().part, BodyPart::kTorso);
}

// Both stand so close that the point is in the trunk on guard: that is none, whatever it does
// there. Once it has been outside, it touches.
TEST_F(TouchRule, InsideOnGuard_IsClosedUntilThePointHasLeft) {
  const float inside = static_cast<float>(kTrunkX - 1 - 0.05);
  left_keys = way_of({inside - kReach, 0, 1.15F}, {inside + kReach, 0, 1.15F});
  begin();
  go(at, 0.1F / kReach, 3 / kReach);
  wait(50);
  EXPECT_EQ(touches(), 0);
  go(at, -0.2F / kReach, 3 / kReach);
  wait(50);
  EXPECT_EQ(touches(), 0);
  go(at, 0.1F / kReach, 3 / kReach);
  ASSERT_EQ(touches(), 1);
  EXPECT_EQ(touch().part, BodyPart::kTorso);
}

// A blade that is a ball is all point, and each of its places is as good as another.
TEST_F(TouchRule, BladeWithoutLength_HasAPlaceOnIt) {
  settings.least_speed = 0;  // along what has no direction there is no speed
  Capsule<float>& blade = left.weapon.blade_B;
  blade.axis.a = blade.axis.b;
  begin();
  thrust(kTrunkX - 1, 3);
  ASSERT_EQ(touches(), 1);
  EXPECT_GE(touch().place, 0);
  EXPECT_LE(touch().place, 1);
}

/// Two who jump between lunges faster than a hand goes, with the library's map.
class JumpingSticks : public test::ConfiguredDuel<Duel<>> {
 protected:
  std::uint32_t state = 1;
  std::uint32_t random() {
    state = 1664525U * state + 1013904223U;
    return state >> 16;
  }
  InputSample jump() {
    constexpr std::array<float, 5> kPlaces = {-1, -0.5F, 0, 0.5F, 1};
    InputSample stick;
    stick.x = kPlaces[random() % 5];
    stick.y = random() % 4 == 0 ? kPlaces[random() % 5] : 1.0F;
    stick.feet_y = kPlaces[random() % 5];
    return stick;
  }
  Capsule<float> point(Side side) const {
    return fencing::detail::point_of(duel->blade_W(side), settings.point_length);
  }
  /// One bout. @returns whether somebody touched
  bool play(float distance) {
    settings.salle.distance = distance;
    const Fencer<float> right = second_fencer<float>();
    EXPECT_EQ(duel->configure(settings, first_fencer<float>(), right), Status::kOk);
    std::array<InputSample, 2> sticks;
    for (std::uint32_t k = 0; k < 1500 && !duel->bout().is_over(); ++k) {  // 1.5 s
      for (auto& stick : sticks) {
        if (k % 50 == 0) stick = jump();
        stick.time = 1000 * duel->steps();
        stick.sequence = duel->steps();
      }
      const std::array points = {point(Side::kLeft), point(Side::kRight)};
      const std::array bodies = {duel->body_W(Side::kLeft), duel->body_W(Side::kRight)};
      const int before = duel->bout().touches.size();
      EXPECT_EQ(duel->step(&sticks[0], &sticks[1]), Status::kOk);
      for (int i = before; i < duel->bout().touches.size(); ++i) {
        const Touch<float>& touch = duel->bout().touches[i];
        const auto part = static_cast<std::size_t>(touch.part);
        const Capsule<float>& bone = bodies[index_of(other(touch.by))][part];
        EXPECT_GT(capsule_gap(points[index_of(touch.by)], bone).gap, 0) << distance << ' ' << k;
      }
    }
    return duel->bout().touches.size() > 0;
  }
};
// A point that lies in a part when a step begins does not touch it in that step.
TEST_F(JumpingSticks, Touch_IsByAPointThatWasOutside) {
  int touched = 0;
  for (int bout = 0; bout < 300; ++bout) {
    if (play(1.0F + 0.005F * static_cast<float>(bout))) ++touched;
  }
  EXPECT_GE(touched, 50) << "there is something to see";
}

// Each of the rules alone, at its limit.
TEST(TouchCounts, AtEachLimit_CountsAndBelowItDoesNot) {
  using Scene = DuelScene<>;
  TouchSettings<Scene> rule;
  rule.least_speed = 2;
  rule.least_control = 0.5F;
  rule.largest_slip = 0.25F;
  const fencing::detail::Command<float> hand{0.5F, 0.75F, 0.25F};
  EXPECT_TRUE((fencing::detail::counts<Scene>(rule, hand, 0.75F, 2.0F)));
  EXPECT_FALSE((fencing::detail::counts<Scene>(rule, hand, 0.75F, 1.999F)));
  EXPECT_FALSE((fencing::detail::counts<Scene>(rule, hand, 0.751F, 2.0F))) << "after the blow";
  EXPECT_FALSE((fencing::detail::counts<Scene>(rule, {0.499F, 0.75F, 0.25F}, 0.75F, 2.0F)));
  EXPECT_FALSE((fencing::detail::counts<Scene>(rule, {0.5F, 0.75F, 0.251F}, 0.75F, 2.0F)));
  rule.least_control = 0;
  EXPECT_TRUE((fencing::detail::counts<Scene>(rule, hand, 0.751F, 2.0F))) << "asked for none";
}

// 0.1 s after the start of its piece the point is at (0.7, 0.5), turned by 0.2 rad about z; the
// part has come by 0.15 m. Both meet at (0.72, 0): arms of (0.02, -0.5) and (0.15, -0.4).
TEST(EntrySpeed, IsThatOfBothAtTheirPlaceAlongTheBlade) {
  MovingCapsule<double> point;
  point.capsule_B = {{{0, 0, 0}, {0.02, 0, 0}}, 0.004};
  point.motion = {{{0.5, 0, 0}, Quat<double>::Identity()}, {{2, 5, 0}, {0, 0, 2}}, 0.2};
  MovingCapsule<double> part;
  part.motion = {{{0.72, 0.4, 0}, Quat<double>::Identity()}, {{-1, 0, 0}, {0, 0, 3}}, 0.5};
  TouchSearch<double> found;
  found.t_free = 0.15;
  found.contact.point_W = {0.72, 0, 0};
  const Vec3<double> of_point(2 + 2 * 0.5, 5 + 2 * 0.02, 0);  // v + w x arm
  const Vec3<double> of_part(-1 + 3 * 0.4, 3 * 0.15, 0);
  const Vec3<double> along(std::cos(0.2), std::sin(0.2), 0);
  EXPECT_NEAR(fencing::detail::entry_speed(point, part, found, 0.05), along.dot(of_point - of_part),
              1e-12);
}

TEST(PointOf, IsTheLastOfTheBlade) {
  const Capsule<double> blade{{{1, 0, 0}, {4, 4, 0}}, 0.01};  // 5 m long
  const Capsule<double> point = fencing::detail::point_of(blade, 1.0);
  EXPECT_LE((point.axis.a - Vec3<double>(3.4, 3.2, 0)).norm(), 1e-12);
  EXPECT_EQ(point.axis.b, blade.axis.b);
  EXPECT_EQ(point.radius, blade.radius);
  EXPECT_LE((fencing::detail::point_of(blade, 7.0).axis.a - blade.axis.a).norm(), 1e-12);
  EXPECT_EQ(fencing::detail::share_of_point(blade, 1.0), 0.2);
  EXPECT_EQ(fencing::detail::share_of_point(blade, 7.0), 1);
}

template <class DuelT>
class TouchSettingsOf : public test::ConfiguredDuel<DuelT> {};
TYPED_TEST_SUITE(TouchSettingsOf, test::CertifiedDuels);

TYPED_TEST(TouchSettingsOf, OutOfRange_AreRefused) {
  using S = typename TestFixture::ScalarT;
  const S infinite = std::numeric_limits<S>::infinity();
  for (const S bad :
       {std::numeric_limits<S>::quiet_NaN(), infinite, -infinite, S(-0.001), S(1001)}) {
    EXPECT_TRUE(this->refuses([bad](auto& s) { s.point_length = bad; })) << bad;
    EXPECT_TRUE(this->refuses([bad](auto& s) { s.least_speed = bad; })) << bad;
    EXPECT_TRUE(this->refuses([bad](auto& s) { s.least_control = bad; })) << bad;
    EXPECT_TRUE(this->refuses([bad](auto& s) { s.largest_slip = bad; })) << bad;
  }
  for (const S bad : {infinite, S(1001)}) {  // beyond kLargestReach: no archive takes it back
    EXPECT_TRUE(this->refuses([bad](auto& s) { s.world.rest_speed = bad; }));
    EXPECT_TRUE(this->refuses([bad](auto& s) { s.world.separation = bad; }));
    EXPECT_TRUE(this->refuses([bad](auto& s) { s.world.min_separation_time = bad; }));
  }
  EXPECT_TRUE(this->refuses([](auto& s) { s.point_length = 0; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.least_control = S(1.001); }));
  EXPECT_FALSE(
      this->refuses([](auto& s) { s.least_speed = s.least_control = s.largest_slip = 0; }));
  EXPECT_FALSE(this->refuses([](auto& s) { s.least_control = 1; }));
}

}  // namespace
}  // namespace batuta
