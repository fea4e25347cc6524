// SPDX-License-Identifier: MIT
// How fast a point goes in: as fast as it came, whatever the body leaves of that in the same step;
// and not as fast as a hand wants it whose blade goes nowhere (src/fencing/touch.md). The speed is
// seen from outside, by the way of the point from step to step.
#include "touch_rule.hpp"

namespace batuta {
using namespace fencing;
namespace {

using test::kFront;
using test::kMiddle;
using test::kReach;
using test::TouchRule;
using test::way_of;

// From so far before the trunk that each share of a step is left when the point meets it, m.
constexpr double kWayOfAStep = 0.003;

// In a step of 1 ms a point at 3 m/s makes 3 mm, and what gives way is 2 mm: of who was a tenth of
// a millimetre away, 2.1 mm are left.
TEST_F(TouchRule, ThrustStoppedInTheStepInWhichItTouches_Counts) {
  settings.least_speed = 2.5F;
  double slowest = 1;
  for (int k = 0; k < 12; ++k) {
    begin();
    thrust(kFront - 0.1 - kWayOfAStep * k / 12, 0.5F);
    wait(20);
    double way = 0;
    for (int i = 0; i < 80 && touches() == 0; ++i) {
      const float before = duel->blade_W(Side::kLeft).axis.b.x();
      at.y() += 0.003F / kReach;
      step();
      way = static_cast<double>(duel->blade_W(Side::kLeft).axis.b.x() - before);
    }
    EXPECT_EQ(touches(), 1) << k;
    slowest = std::min(slowest, way);
  }
  EXPECT_LT(slowest, 0.0025) << "no step was too short";
}

/// The hand goes forward with y, and up with x: from the height of the pelvis to that of the trunk.
class JammedBlade : public TouchRule {
 protected:
  static constexpr float kLow = 0.85F;
  static constexpr float kHigh = 1.05F;
  void SetUp() override {
    TouchRule::SetUp();
    left_keys = way_of({kMiddle - kReach, 0, kLow}, {kMiddle + kReach, 0, kLow});
    left_keys[1].hand_F[2] = left_keys[3].hand_F[2] = kHigh;
    at.x() = -1;
  }
  void start() {
    begin();
    at.x() = -1;
    wait(300);  // down to the pelvis, before it
  }
  /// Up with the hand, to the trunk. @returns the fastest that the point went along the blade, m/s
  double rise() {
    double fastest = 0;
    for (int i = 0; i < 500 && touches() == 0; ++i) {
      const Segment<float> before = duel->blade_W(Side::kLeft).axis;
      at.x() = std::min(at.x() + 0.004F, 1.0F);
      step();
      const Vec3<float> way = duel->blade_W(Side::kLeft).axis.b - before.b;
      const float along = way.dot(before.direction().normalized());
      fastest = std::max(fastest, 1000 * static_cast<double>(along));
    }
    return fastest;
  }
};

// The point stands against the pelvis, where no touch counts. Its hand wants it 0.14 m further and
// presses; then it goes up slowly, and the point slides on into the trunk.
TEST_F(JammedBlade, PointThatSlidesOn_IsNoTouch) {
  start();
  thrust(kFront + 0.14, 1.5F);
  wait(20);
  ASSERT_EQ(touches(), 0);
  const float tip = duel->blade_W(Side::kLeft).axis.b.x();
  wait(20);
  EXPECT_NEAR(duel->blade_W(Side::kLeft).axis.b.x(), tip, 1e-3) << "it goes nowhere";
  EXPECT_LT(rise(), 0.98);
  const Capsule<float> trunk =
      duel->body_W(Side::kRight)[static_cast<std::size_t>(BodyPart::kTorso)];
  EXPECT_LT(capsule_gap(duel->blade_W(Side::kLeft), trunk).gap, 0) << "it did not come there";
  EXPECT_EQ(touches(), 0);
}

}  // namespace
}  // namespace batuta
