// SPDX-License-Identifier: MIT
// Signs and directions, held against the words of linux/input.h and SDL_haptic.h.
#include "programs/live/effects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "programs/live/linux_effects.hpp"

namespace batuta::host {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Level, IsTheNearestOfSixteenBits_AndNeverWraps) {
  EXPECT_EQ(level_of(0), 0);
  EXPECT_EQ(level_of(1), 32767);
  EXPECT_EQ(level_of(-1), -32767) << "as strong to one side as to the other";
  EXPECT_EQ(level_of(0.5F), 16384);
  EXPECT_EQ(level_of(-0.5F), -16384);
  EXPECT_EQ(level_of(7), 32767);
  EXPECT_EQ(level_of(-kInfinity), -32767);
  EXPECT_EQ(level_of(kNan), 0);
  EXPECT_EQ(magnitude_of(0), 0);
  EXPECT_EQ(magnitude_of(1), 65535);
  EXPECT_EQ(magnitude_of(0.5F), 32768);
  EXPECT_EQ(magnitude_of(-1), 0);
  EXPECT_EQ(magnitude_of(kInfinity), 65535);
  EXPECT_EQ(magnitude_of(kNan), 0);
}

struct Golden {
  float x;
  float y;
  std::uint16_t direction;
};

TEST(PolarForce, PushesWhereLinuxSaysThatItDoes) {
  // struct ff_effect: 0 deg -> 0x0000 (down), 90 -> 0x4000 (left), 180 -> 0x8000 (up), 270 ->
  // 0xC000 (right). Here x is to the right and y up.
  const Golden golden[] = {{0, -1, 0x0000}, {-1, -1, 0x2000}, {-1, 0, 0x4000}, {-1, 1, 0x6000},
                           {0, 1, 0x8000},  {1, 1, 0xA000},   {1, 0, 0xC000},  {1, -1, 0xE000}};
  for (const Golden& force : golden) {
    const PolarForce whole = polar_force(force.x, force.y);
    EXPECT_EQ(whole.direction, force.direction) << force.x << ", " << force.y;
    EXPECT_EQ(whole.level, 32767);
    const PolarForce half = polar_force(force.x / 2, force.y / 2);
    EXPECT_EQ(half.direction, force.direction);
    EXPECT_EQ(half.level, 16384);
  }
  EXPECT_EQ(polar_force(0, 0).level, 0);
  EXPECT_EQ(polar_force(kNan, kNan).level, 0);
}

TEST(PolarForce, AnyDirection_IsWithinHalfAStepOfTheAngle) {
  const double pi = std::acos(-1.0);
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * pi * i / 1000;  // from down, by way of left
    const PolarForce force =
        polar_force(static_cast<float>(-std::sin(angle)), static_cast<float>(-std::cos(angle)));
    const auto off = static_cast<std::int16_t>(
        force.direction - static_cast<std::uint16_t>(std::lround(angle / (2 * pi) * 65536)));
    EXPECT_LE(std::abs(off), 1) << i;  // the rounding of the force itself to float
  }
}

TEST(LinuxConstant, EachAxis_PushesToItsPositiveSide) {
  const ff_effect right = linux_constant(kPushRight, level_of(0.25F));
  EXPECT_EQ(right.type, FF_CONSTANT);
  EXPECT_EQ(right.direction, 0xC000) << "right";
  EXPECT_EQ(right.u.constant.level, 8192);
  EXPECT_EQ(right.replay.length, kEffectLength_ms);
  EXPECT_EQ(right.id, -1) << "new";
  const ff_effect up = linux_constant(kPushUp, level_of(-0.25F));
  EXPECT_EQ(up.direction, 0x8000) << "up";
  EXPECT_EQ(up.u.constant.level, -8192) << "and so it pushes down";
}

TEST(LinuxEffects, AllEndByThemselves_SoonAfterSilenceWouldEndThem) {
  const ConditionPair pair = condition_numbers(Condition{0.5F, 0, 0});
  for (const ff_effect& effect : {linux_constant(kPushRight, 1), linux_condition(FF_SPRING, pair),
                                  linux_condition(FF_DAMPER, pair), linux_rumble(Rumble{1, 1})}) {
    EXPECT_GT(effect.replay.length, 100) << effect.type << ": 0 has no end";
    EXPECT_LE(effect.replay.length, 200) << effect.type;
    EXPECT_EQ(effect.replay.delay, 0) << effect.type;
  }
}

TEST(LinuxConstant, BothForms_AreTheSameForce) {
  // The unit vectors of the directions that the header names.
  EXPECT_EQ(polar_force(0.3F, 0).direction, kPushRight);
  EXPECT_EQ(polar_force(0, 0.3F).direction, kPushUp);
  EXPECT_EQ(polar_force(-0.3F, 0).direction, kPushLeft);
  EXPECT_EQ(static_cast<std::uint16_t>(kPushRight + 0x8000), kPushLeft);
}

TEST(Condition, PullsBack_OnBothSidesAlike) {
  Condition spring;
  spring.coefficient = 0.5F;
  spring.centre_x = 0.25F;  // to the right
  spring.centre_y = 0.5F;   // up
  const ff_effect effect = linux_condition(FF_SPRING, condition_numbers(spring));
  EXPECT_EQ(effect.type, FF_SPRING);
  for (const ff_condition_effect& axis : effect.u.condition) {
    EXPECT_EQ(axis.right_coeff, 16384) << "positive: against the movement";
    EXPECT_EQ(axis.left_coeff, axis.right_coeff);
    EXPECT_EQ(axis.right_saturation, 65535);
    EXPECT_EQ(axis.left_saturation, 65535);
    EXPECT_EQ(axis.deadband, 0);
  }
  EXPECT_EQ(effect.u.condition[0].center, 8192);
  EXPECT_EQ(effect.u.condition[1].center, -16384) << "the counts of an axis grow downwards";
}

TEST(Condition, WithoutACoefficient_IsNone) {
  for (const float none : {0.0F, -1.0F, kNan}) {
    Condition condition;
    condition.coefficient = none;
    condition.centre_x = 1;
    const ConditionPair pair = condition_numbers(condition);
    EXPECT_EQ(pair.x.coefficient, 0);
    EXPECT_EQ(pair.x.saturation, 0);
    EXPECT_EQ(pair.y.coefficient, 0);
  }
}

TEST(Rumble, APush_ShakesTheHeavyMotor_ABlowBoth) {
  Feel push;
  push.x = -0.5F;
  push.blow = 0.5F;
  EXPECT_EQ(rumble_of(push).strong, 32768);
  EXPECT_EQ(rumble_of(push).weak, 0);
  Feel blow;
  blow.blow = 0.75F;  // and it is over
  EXPECT_EQ(rumble_of(blow).strong, 49151);
  EXPECT_EQ(rumble_of(blow).weak, 49151);
  Feel both = push;
  both.y = 1;
  EXPECT_EQ(rumble_of(both).strong, 65535) << "the longer coordinate, as the range is a square";
  EXPECT_EQ(rumble_of({}).strong + rumble_of({}).weak, 0);
  const ff_effect effect = linux_rumble(rumble_of(blow));
  EXPECT_EQ(effect.type, FF_RUMBLE);
  EXPECT_EQ(effect.u.rumble.strong_magnitude, 49151);
  EXPECT_EQ(effect.u.rumble.weak_magnitude, 49151);
}

}  // namespace
}  // namespace batuta::host
