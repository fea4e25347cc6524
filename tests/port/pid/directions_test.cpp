// SPDX-License-Identifier: MIT
// Signs and directions of both axes, worked out by hand from what PID, DirectInput, SDL and Linux
// say: north is away from the user, angles are clockwise, and a direction is where a force comes
// from. Here x is right and y is up, which is north.

#include <gtest/gtest.h>

#include <cmath>

#include "host.hpp"
#include "shared/hid_pid/direction.hpp"

namespace batuta::pid::test {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
const UsageCode kAngle = 0x0A0001;
const UsageCode kAxisX = 0x010030;
const UsageCode kAxisY = 0x010031;
const UsageCode kHasDirection = pid_usage(0x56);

Vec2<float> constant_force(double share, const Values& effect) {
  Session session;
  const std::int64_t block = session.made(EffectType::kConstant);
  EXPECT_EQ(
      session.send(pid_usage(0x73), {{pid_usage(0x22), block}, {pid_usage(0x70), level(share)}}),
      Status::kOk);
  EXPECT_EQ(session.set_effect(block, effect), Status::kOk);
  EXPECT_EQ(session.start(block), Status::kOk);
  return session.force();
}

TEST(PidDirections, ConstantForce_ComesFromItsDirection) {
  const struct {
    double angle;
    Vec2<float> force;
  } winds[] = {
      {0, {0.0F, -1.0F}},    // from the north: pulls towards the user
      {90, {-1.0F, 0.0F}},   // from the east: pushes to the left
      {180, {0.0F, 1.0F}},   // from the south: pushes away
      {270, {1.0F, 0.0F}},   // from the west: pushes to the right
      {360, {0.0F, -1.0F}},  // north again
  };
  for (const auto& [angle, force] : winds) {
    EXPECT_EQ(constant_force(1.0, {{kAngle, degrees(angle)}}), force) << angle;
    EXPECT_EQ(constant_force(-1.0, {{kAngle, degrees(angle)}}), Vec2<float>(-force)) << angle;
  }
  const Vec2<float> north_east = constant_force(1.0, {{kAngle, degrees(45)}});
  EXPECT_NEAR(north_east.x(), -std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(north_east.y(), -std::sqrt(0.5), 1e-6);
}

TEST(PidDirections, EveryAngle_IsWithinFourUlpOfTheTrueOne) {
  for (unsigned angle = 0; angle <= 18000; ++angle) {
    const Vec2<float> d = direction_of(angle);
    const double a = angle / 50.0 * kDegree;
    ASSERT_NEAR(d.x(), std::sin(a), 4 * 0x1p-24) << angle;
    ASSERT_NEAR(d.y(), std::cos(a), 4 * 0x1p-24) << angle;
  }
}

// Without a direction a force comes from the positive end of each axis; HID's Y ends at the user.
TEST(PidDirections, AxesWithoutDirection_AreTheirPositiveEnds) {
  EXPECT_EQ(constant_force(0.5, {{kHasDirection, 0}, {kAxisX, 1}}), Vec2<float>(-0.5F, 0.0F));
  EXPECT_EQ(constant_force(0.5, {{kHasDirection, 0}, {kAxisY, 1}}), Vec2<float>(0.0F, 0.5F));
  EXPECT_EQ(constant_force(0.5, {{kHasDirection, 0}, {kAxisX, 1}, {kAxisY, 1}}),
            Vec2<float>(-0.5F, 0.5F));
  EXPECT_EQ(constant_force(0.5, {{kHasDirection, 0}}), Vec2<float>(0.0F, 0.0F));
  // With a direction the axes do not count.
  EXPECT_EQ(constant_force(0.5, {{kAxisX, 1}, {kAngle, degrees(180)}}), Vec2<float>(0.0F, 0.5F));
}

Vec2<float> condition_force(EffectType type, const std::vector<Values>& axes, const Stick& stick,
                            const Values& effect = {}) {
  Session session;
  const std::int64_t block = session.made(type);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    EXPECT_EQ(session.condition(block, static_cast<int>(i), axes[i]), Status::kOk);
  }
  EXPECT_EQ(session.set_effect(block, effect), Status::kOk);
  EXPECT_EQ(session.start(block), Status::kOk);
  return session.force(stick);
}

const Values kStiff = {{pid_usage(0x61), 10000}, {pid_usage(0x62), 10000}};
const Values kSoft = {{pid_usage(0x61), 5000}, {pid_usage(0x62), 5000}};

TEST(PidDirections, Spring_PullsBothAxesToTheCentre) {
  const std::vector<Values> axes = {kStiff, kSoft};
  Stick stick;
  stick.position = {0.5F, 0.25F};
  EXPECT_EQ(condition_force(EffectType::kSpring, axes, stick), Vec2<float>(-0.5F, -0.125F));
  stick.position = {-0.5F, -0.25F};
  EXPECT_EQ(condition_force(EffectType::kSpring, axes, stick), Vec2<float>(0.5F, 0.125F));
  // Two blocks are not rotated, whatever direction comes with them.
  EXPECT_EQ(condition_force(EffectType::kSpring, axes, stick, {{kAngle, degrees(90)}}),
            Vec2<float>(0.5F, 0.125F));
}

// Velocity 10/s is the full scale, acceleration 100/s^2.
TEST(PidDirections, DamperAndInertia_HoldTheMotion) {
  const std::vector<Values> axes = {kStiff, kSoft};
  Stick stick;
  stick.velocity = {5.0F, -2.5F};
  EXPECT_EQ(condition_force(EffectType::kDamper, axes, stick), Vec2<float>(-0.5F, 0.125F));
  EXPECT_EQ(condition_force(EffectType::kInertia, axes, stick), Vec2<float>(0.0F, 0.0F));
  stick.acceleration = {-50.0F, 25.0F};
  EXPECT_EQ(condition_force(EffectType::kInertia, axes, stick), Vec2<float>(0.5F, -0.125F));
  EXPECT_EQ(condition_force(EffectType::kSpring, axes, stick), Vec2<float>(0.0F, 0.0F));
}

TEST(PidDirections, Friction_HasItsFullSizeAtEveryVelocityBeyondTheKnee) {
  const std::vector<Values> axes = {kStiff, kSoft};
  Stick stick;
  stick.velocity = {0.5F, -0.5F};  // the knee: 0.05 of 10/s
  EXPECT_EQ(condition_force(EffectType::kFriction, axes, stick), Vec2<float>(-1.0F, 0.5F));
  stick.velocity = {9.0F, -9.0F};
  EXPECT_EQ(condition_force(EffectType::kFriction, axes, stick), Vec2<float>(-1.0F, 0.5F));
  stick.velocity = {0.25F, 0.0F};
  EXPECT_NEAR(condition_force(EffectType::kFriction, axes, stick).x(), -0.5F, 1e-6F);
  EXPECT_EQ(condition_force(EffectType::kFriction, axes, Stick{}), Vec2<float>(0.0F, 0.0F));
}

// The offset and the two sides are HID's: the second axis is positive towards the user.
TEST(PidDirections, SidesOfTheSecondAxis_AreThoseOfHid) {
  const Values towards = {{pid_usage(0x61), 10000}};  // positive side only
  const Values none = {};
  Stick stick;
  stick.position = {0.5F, -0.5F};  // right, towards the user
  EXPECT_EQ(condition_force(EffectType::kSpring, {towards, towards}, stick),
            Vec2<float>(-0.5F, 0.5F));
  stick.position = {-0.5F, 0.5F};
  EXPECT_EQ(condition_force(EffectType::kSpring, {towards, towards}, stick),
            Vec2<float>(0.0F, 0.0F));
  Values shifted = kStiff;
  shifted[pid_usage(0x60)] = 2500;  // rest towards the user
  stick.position = {0.0F, -0.25F};
  EXPECT_EQ(condition_force(EffectType::kSpring, {none, shifted}, stick), Vec2<float>(0.0F, 0.0F));
  stick.position = {0.0F, 0.0F};
  EXPECT_EQ(condition_force(EffectType::kSpring, {none, shifted}, stick),
            Vec2<float>(0.0F, -0.25F));
}

// One block alone lies along the direction: "a friction condition rotated 45 degrees resists motion
// in the north-east - south-west direction and has no effect on the other" (PID 1.0, DirectInput).
TEST(PidDirections, OneBlock_IsRotated) {
  const Values north_east = {{kAngle, degrees(45)}};
  Stick stick;
  stick.velocity = {2.0F, 2.0F};
  const Vec2<float> along = condition_force(EffectType::kDamper, {kStiff}, stick, north_east);
  EXPECT_NEAR(along.x(), -0.2F, 1e-6F);
  EXPECT_NEAR(along.y(), -0.2F, 1e-6F);
  stick.velocity = {2.0F, -2.0F};
  const Vec2<float> across = condition_force(EffectType::kDamper, {kStiff}, stick, north_east);
  EXPECT_NEAR(across.norm(), 0.0F, 1e-6F);
  stick.velocity = {0.0F, 5.0F};
  EXPECT_EQ(condition_force(EffectType::kDamper, {kStiff}, stick), Vec2<float>(0.0F, -0.5F));
}

// The same whichever of the two it is: hosts send one report a block, and may send one alone.
TEST(PidDirections, LoneBlockOfTheSecondAxis_IsOneBlock) {
  Stick stick;
  stick.position = {0.5F, 0.25F};
  for (const Values& effect :
       {Values{{kAngle, degrees(0)}}, Values{{kAngle, degrees(45)}},
        Values{{kHasDirection, 0}, {kAxisX, 1}}, Values{{kHasDirection, 0}, {kAxisY, 1}}}) {
    Session session;
    const std::int64_t block = session.made(EffectType::kSpring);
    EXPECT_EQ(session.condition(block, 1, kSoft), Status::kOk);
    EXPECT_EQ(session.set_effect(block, effect), Status::kOk);
    EXPECT_EQ(session.start(block), Status::kOk);
    const Vec2<float> force = session.force(stick);
    EXPECT_GT(force.norm(), 0.1F);
    EXPECT_EQ(force, condition_force(EffectType::kSpring, {kSoft}, stick, effect));
  }
}

// In a corner of the stick's square the metric along a diagonal is beyond 1: at the stop, no
// further.
TEST(PidDirections, OneBlockInACorner_EndsAtFullScale) {
  Stick stick;
  stick.position = {1.0F, 1.0F};
  const Vec2<float> force =
      condition_force(EffectType::kSpring, {kSoft}, stick, {{kAngle, degrees(45)}});
  EXPECT_NEAR(force.norm(), 0.5F, 1e-6F);
}

// Its positive side is the side of the direction.
TEST(PidDirections, OneBlockFromTheEast_IsThatOfTheFirstAxis) {
  const Values side = {{pid_usage(0x61), 10000}};
  Stick stick;
  for (const float x : {0.5F, -0.5F}) {
    stick.position = {x, 0.3F};
    EXPECT_EQ(condition_force(EffectType::kSpring, {side}, stick, {{kAngle, degrees(90)}}),
              condition_force(EffectType::kSpring, {side, {}}, stick))
        << x;
  }
}

TEST(PidDirections, OneBlockWithoutDirection_IsThatOfTheAxesEnabled) {
  const UsageCode enable = pid_usage(0x56);
  Stick stick;
  stick.position = {0.5F, 0.25F};
  EXPECT_EQ(condition_force(EffectType::kSpring, {kStiff}, stick, {{enable, 0}, {0x010030, 1}}),
            Vec2<float>(-0.5F, 0.0F));
  EXPECT_EQ(condition_force(EffectType::kSpring, {kStiff}, stick, {{enable, 0}, {0x010031, 1}}),
            Vec2<float>(0.0F, -0.25F));
  EXPECT_EQ(
      condition_force(EffectType::kSpring, {kStiff, kSoft}, stick, {{enable, 0}, {0x010031, 1}}),
      Vec2<float>(0.0F, -0.125F));
}

TEST(PidDirections, Gains_MultiplyAndTheSumIsClipped) {
  Session session;
  for (int i = 0; i < 2; ++i) {
    const std::int64_t block = session.made(EffectType::kConstant);
    EXPECT_EQ(session.send(pid_usage(0x73), {{pid_usage(0x22), block}, {pid_usage(0x70), 10000}}),
              Status::kOk);
    EXPECT_EQ(session.set_effect(block, {{pid_usage(0x52), 51}}), Status::kOk);  // a fifth
    EXPECT_EQ(session.start(block), Status::kOk);
  }
  EXPECT_FLOAT_EQ(session.force().y(), -0.4F);
  EXPECT_EQ(session.send(pid_usage(0x7D), {{pid_usage(0x7E), 102}}), Status::kOk);  // two fifths
  EXPECT_FLOAT_EQ(session.force().y(), -0.16F);
  EXPECT_EQ(session.send(pid_usage(0x7D), {{pid_usage(0x7E), 255}}), Status::kOk);
  EXPECT_EQ(session.set_effect(1), Status::kOk);
  EXPECT_EQ(session.set_effect(2), Status::kOk);
  EXPECT_EQ(session.force(), Vec2<float>(0.0F, -1.0F));
}

}  // namespace
}  // namespace batuta::pid::test
