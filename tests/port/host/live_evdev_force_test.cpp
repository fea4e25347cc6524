// SPDX-License-Identifier: MIT
// Force feedback of the Linux input stack, held against the effects that a fake kernel was given.
#include <gtest/gtest.h>

#include <cerrno>

#include "fake_stick.hpp"
#include "host/live/evdev_force.hpp"

namespace batuta::host {
namespace {

using test::FakeEventDevice;
using test::kPath;
using Stick = test::FakeStick;

TEST(EvdevForce, TwoEffects_PlayWithoutAnEnd_AndOnlyTheirLevelsChange) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_GAIN).has(EV_FF, FF_AUTOCENTER).room_for_effects(16);
  {
    EvdevForce force(kPath);
    ASSERT_EQ(force.open(), ForceKind::kForce);
    Feel feel;
    feel.x = 0.5F;
    feel.y = -0.25F;
    ASSERT_EQ(force.render(feel), Rendered::kDone);
    const std::vector<ff_effect> effects = stick.effects();
    ASSERT_EQ(effects.size(), 2U);
    EXPECT_EQ(effects[0].direction, 0xC000) << "right";
    EXPECT_EQ(effects[0].u.constant.level, 16384);
    EXPECT_EQ(effects[0].replay.length, 0);
    EXPECT_EQ(effects[1].direction, 0x8000) << "up";
    EXPECT_EQ(effects[1].u.constant.level, -8192);
    EXPECT_TRUE(stick.is_playing(0));
    EXPECT_TRUE(stick.is_playing(1));
    EXPECT_EQ(stick.property(FF_GAIN), 0xFFFF);
    EXPECT_EQ(stick.property(FF_AUTOCENTER), 0);
    feel.y = 1;
    ASSERT_EQ(force.render(feel), Rendered::kDone);
    EXPECT_EQ(stick.uploads(), 3) << "what has not changed is not uploaded";
    EXPECT_EQ(stick.effects()[1].u.constant.level, 32767);
    EXPECT_EQ(stick.effects().size(), 2U);
  }
  EXPECT_TRUE(stick.effects().empty()) << "taken back";
  EXPECT_EQ(stick.open_files(), 0);
}

TEST(EvdevForce, WithRoomForOneEffect_ItTurns) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(1);
  EvdevForce force(kPath);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.x = -0.5F;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  ASSERT_EQ(stick.effects().size(), 1U);
  EXPECT_EQ(stick.effects()[0].direction, 0x4000) << "left";
  EXPECT_EQ(stick.effects()[0].u.constant.level, 16384);
}

TEST(EvdevForce, SpringAndDamper_TakeTheRoomThatIsLeft) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_SPRING).has(EV_FF, FF_DAMPER).room_for_effects(3);
  EvdevForce force(kPath);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.spring.coefficient = 0.5F;
  feel.damper.coefficient = 0.5F;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  ASSERT_EQ(stick.effects().size(), 3U);
  EXPECT_EQ(stick.effects()[2].type, FF_SPRING);
  EXPECT_EQ(stick.effects()[2].u.condition[1].right_coeff, 16384);
  EXPECT_TRUE(stick.is_playing(2));
  feel.spring.coefficient = 0;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  EXPECT_EQ(stick.effects()[2].u.condition[0].right_coeff, 0) << "switched off again";
}

TEST(EvdevForce, WithoutAForce_ThereIsRumble_OrNothing) {
  Stick stick;
  stick.has(EV_FF, FF_RUMBLE).room_for_effects(16);
  EvdevForce force(kPath);
  ASSERT_EQ(force.open(), ForceKind::kRumble);
  Feel feel;
  feel.blow = 1;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  ASSERT_EQ(stick.effects().size(), 1U);
  EXPECT_EQ(stick.effects()[0].type, FF_RUMBLE);
  EXPECT_EQ(stick.effects()[0].u.rumble.strong_magnitude, 65535);
  FakeEventDevice mute("/dev/input/fake1");
  EXPECT_EQ(EvdevForce("/dev/input/fake1").open(), ForceKind::kNone);
  EXPECT_EQ(EvdevForce("/dev/input/fake2").open(), ForceKind::kNone);
}

TEST(EvdevForce, AnEffectThatIsNotTaken_ComesWithTheNext_AGoneDeviceIsGone) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(2);
  EvdevForce force(kPath);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.x = 1;
  stick.refuse_effects(EAGAIN);
  EXPECT_EQ(force.render(feel), Rendered::kLater) << "busy is not gone";
  stick.refuse_effects(0);
  EXPECT_EQ(force.render(feel), Rendered::kDone);
  EXPECT_EQ(stick.effects()[0].u.constant.level, 32767);
  stick.unplug();
  feel.x = 0;
  EXPECT_FALSE(force.is_there());
  EXPECT_EQ(force.render(feel), Rendered::kGone);
  EXPECT_EQ(force.open(), ForceKind::kNone);
  stick.plug_in();
  EXPECT_EQ(force.open(), ForceKind::kForce);
  EXPECT_EQ(force.render(feel), Rendered::kDone);
  EXPECT_TRUE(stick.is_playing(0));
  stick.refuse_effects(EINVAL);
  feel.x = 0.5F;
  EXPECT_EQ(force.render(feel), Rendered::kGone) << "it does not pass: open it anew";
  EXPECT_TRUE(stick.effects().empty()) << "and the last force does not stay";
}

}  // namespace
}  // namespace batuta::host
