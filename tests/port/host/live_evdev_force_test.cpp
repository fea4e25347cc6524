// SPDX-License-Identifier: MIT
// Force feedback of the Linux input stack, held against the effects that a fake kernel was given.
#include <gtest/gtest.h>

#include <cerrno>
#include <memory>
#include <optional>

#include "fake_stick.hpp"
#include "held_force.hpp"
#include "programs/live/evdev_feed.hpp"
#include "programs/live/evdev_force.hpp"

namespace batuta::host {
namespace {

using test::FakeEventDevice;
using test::kPath;
using Stick = test::FakeStick;

TEST(EvdevForce, TwoEffects_Play_AndOnlyTheirLevelsChange) {
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
    EXPECT_EQ(effects[0].replay.length, kEffectLength_ms);
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
}

Feel push_right(float share) {
  Feel feel;
  feel.x = share;
  return feel;
}

/// Neither lost nor opened anew: the device is there, and stays open.
class RefusedEffect : public testing::TestWithParam<int> {
 protected:
  RefusedEffect() {
    stick_.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_SPRING).has(EV_FF, FF_DAMPER);
    stick_.room_for_effects(16);
    feel_.spring.coefficient = 0.5F;
    feel_.damper.coefficient = 0.5F;
  }
  Stick stick_;
  EvdevForce force_{kPath};
  Feel feel_ = push_right(0.5F);
};

TEST_P(RefusedEffect, OfASpring_IsLeftOut_TheRestIsRendered) {
  stick_.refuse_effects(GetParam(), FF_SPRING);
  ASSERT_EQ(force_.open(), ForceKind::kForce);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(force_.render(feel_), Rendered::kDone);
  EXPECT_EQ(force_.kind(), ForceKind::kForce);
  EXPECT_EQ(names_of(force_.left_out()), "spring");
  ASSERT_EQ(stick_.effects().size(), 3U);
  EXPECT_EQ(stick_.effects()[0].u.constant.level, 16384);
  EXPECT_EQ(stick_.effects()[2].type, FF_DAMPER);
  EXPECT_EQ(stick_.openings(), 1);
}

TEST_P(RefusedEffect, OfAConstant_BecomesRumble) {
  stick_.has(EV_FF, FF_RUMBLE).refuse_effects(GetParam(), FF_CONSTANT);
  ASSERT_EQ(force_.open(), ForceKind::kForce) << "so it says";
  for (int i = 0; i < 10; ++i) ASSERT_EQ(force_.render(feel_), Rendered::kDone);
  EXPECT_EQ(force_.kind(), ForceKind::kRumble);
  EXPECT_EQ(names_of(force_.left_out()), "constant, spring, damper");
  ASSERT_EQ(stick_.effects().size(), 1U);
  EXPECT_EQ(stick_.effects()[0].u.rumble.strong_magnitude, 32768);
  EXPECT_EQ(stick_.openings(), 1);
}

TEST_P(RefusedEffect, OfEverything_IsNoForce_WithAReason) {
  stick_.has(EV_FF, FF_RUMBLE).refuse_effects(GetParam());
  ASSERT_EQ(force_.open(), ForceKind::kForce);
  EXPECT_EQ(force_.render(feel_), Rendered::kRefused);
  EXPECT_EQ(force_.render(feel_), Rendered::kRefused);
  EXPECT_EQ(force_.kind(), ForceKind::kNone);
  EXPECT_EQ(force_.problem(), "it takes none of its effects (constant, rumble)");
  EXPECT_TRUE(force_.is_there());
  EXPECT_EQ(stick_.openings(), 1);
  stick_.unplug();
  EXPECT_FALSE(force_.is_there());
  stick_.refuse_effects(0);
  stick_.plug_in();
  EXPECT_EQ(force_.open(), ForceKind::kForce) << "another one may be plugged in there";
  EXPECT_EQ(force_.render(feel_), Rendered::kDone);
  EXPECT_TRUE(force_.left_out().empty());
}

TEST_P(RefusedEffect, AmidTheBout_LeavesNothingOfTheLastForce) {
  stick_.has(EV_FF, FF_RUMBLE);
  ASSERT_EQ(force_.open(), ForceKind::kForce);
  ASSERT_EQ(force_.render(feel_), Rendered::kDone);
  stick_.refuse_effects(GetParam());
  feel_.x = 0.25F;
  EXPECT_EQ(force_.render(feel_), Rendered::kRefused);
  EXPECT_TRUE(stick_.effects().empty());
}

INSTANTIATE_TEST_SUITE_P(EvdevForce, RefusedEffect, testing::Values(EINVAL, ENOSPC, ENOSYS, EIO));

TEST(EvdevForce, WithLessRoomThanItSays_TwoForcesBecomeOneThatTurns) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(16, 1);
  EvdevForce force(kPath);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.y = 0.5F;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  EXPECT_EQ(force.kind(), ForceKind::kForce);
  EXPECT_TRUE(force.left_out().empty());
  ASSERT_EQ(stick.effects().size(), 1U);
  EXPECT_EQ(stick.effects()[0].direction, 0x8000) << "up";
  EXPECT_EQ(stick.effects()[0].u.constant.level, 16384);
}

TEST(EvdevForce, AnEffectThatIsThereNoMore_IsMadeAnew) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(2);
  EvdevForce force(kPath);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel = push_right(0.5F);
  feel.y = 0.5F;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  stick.forget_effects();
  feel.x = 0.25F;
  feel.y = -0.25F;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  ASSERT_EQ(stick.effects().size(), 2U) << "one for each axis, as before";
  EXPECT_EQ(stick.effects()[0].u.constant.level, 8192);
  EXPECT_EQ(stick.effects()[1].u.constant.level, -8192);
  EXPECT_TRUE(stick.is_playing(0) && stick.is_playing(1));
}

TEST(EvdevForce, RumbleAtZero_IsStopped_AndPlaysAgain) {
  Stick stick;
  stick.has(EV_FF, FF_RUMBLE).room_for_effects(16);
  EvdevForce force(kPath);
  ASSERT_EQ(force.open(), ForceKind::kRumble);
  ASSERT_EQ(force.render(push_right(0.5F)), Rendered::kDone);
  EXPECT_TRUE(stick.is_playing(0));
  ASSERT_EQ(force.render({}), Rendered::kDone);
  EXPECT_FALSE(stick.is_playing(0)) << "the kernel is told, whatever the driver makes of zero";
  EXPECT_EQ(stick.effects()[0].u.rumble.strong_magnitude, 0);
  ASSERT_EQ(force.render(push_right(0.25F)), Rendered::kDone);
  EXPECT_TRUE(stick.is_playing(0));
}

constexpr int kSeconds = 1000;  // turns of the pump

/// What is told is told by a pump, and the device's effects end by the device's time.
class EndingEffects : public testing::Test {
 protected:
  void begin() {
    force_.emplace(std::make_unique<EvdevForce>(kPath), options_,
                   [this](std::int32_t time_us) { stick_.pass(time_us); });
  }
  bool all_play(int effects) {
    for (int i = 0; i < effects; ++i) {
      if (!stick_.is_playing(i)) return false;
    }
    return true;
  }
  bool none_plays(int effects) {
    for (int i = 0; i < effects; ++i) {
      if (stick_.is_playing(i)) return false;
    }
    return true;
  }
  /// Holds a force for seconds, and then the program is stopped.
  void hold_and_stop(int effects) {
    begin();
    EXPECT_EQ(hold(*force_, 0.5F, -0.25F, 5 * kSeconds, [&] { return all_play(effects); }), 0);
    ASSERT_EQ(static_cast<int>(stick_.effects().size()), effects);
    EXPECT_GT(test::strength(stick_.effects()[0]), 0);
    stick_.pass(kEffectLength_ms * 1000);
    EXPECT_TRUE(none_plays(effects)) << "nobody is there to take it away";
  }

  Stick stick_;
  ForceOptions options_;
  std::optional<test::HeldForce> force_;
};

TEST_F(EndingEffects, AForceNeverDropsOut_AndEndsWhereTheProgramIsStopped) {
  stick_.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  hold_and_stop(2);
}

TEST_F(EndingEffects, AForceThatTurnsDoesTheSame) {
  stick_.has(EV_FF, FF_CONSTANT).room_for_effects(1);
  hold_and_stop(1);
}

TEST_F(EndingEffects, SpringAndDamperDoTheSame) {
  stick_.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_SPRING).has(EV_FF, FF_DAMPER).room_for_effects(16);
  options_.spring.coefficient = options_.damper.coefficient = 0.5F;
  hold_and_stop(4);
}

TEST_F(EndingEffects, ARumbleDoesTheSame) {
  stick_.has(EV_FF, FF_RUMBLE).room_for_effects(16);
  hold_and_stop(1);
}

TEST_F(EndingEffects, ASpringWithoutAForce_IsPlayedOn) {
  stick_.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_SPRING).room_for_effects(16);
  options_.spring.coefficient = 0.5F;
  begin();
  EXPECT_EQ(hold(*force_, 0, 0, kSeconds, [&] { return stick_.is_playing(2); }), 0);
}

TEST_F(EndingEffects, AfterAPauseInWhichAllHasEnded_ABlowIsFelt) {
  stick_.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  begin();
  for (int blow = 0; blow < 5; ++blow) {
    force_->command(0.5F, 0);
    force_->pass(ForcePump::kTurn_us);
    force_->turn();
    EXPECT_TRUE(stick_.is_playing(0)) << blow;
    EXPECT_EQ(stick_.effects()[0].u.constant.level, 16384) << blow;
    (void)hold(*force_, 0, 0, kSeconds, [] { return true; });
    EXPECT_TRUE(none_plays(2)) << "what is zero need not play";
  }
}

TEST_F(EndingEffects, AreTold_OnceMoreEachFiftyMilliseconds_AndNoOftener) {
  stick_.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  begin();
  const auto step = [this](float force) {
    force_->command(force, 0);
    force_->pass(ForcePump::kTurn_us);
    force_->turn();
  };
  for (int i = 0; i < kSeconds; ++i) step(0.5F);
  EXPECT_EQ(stick_.uploads(), 2) << "its level is the same";
  EXPECT_LE(stick_.plays(), 2 + 2 * 20) << "two effects, twenty times a second";
  const int before = stick_.plays();
  for (int i = 0; i < kSeconds; ++i) step(i % 2 == 0 ? 0.0F : 0.001F * static_cast<float>(i));
  EXPECT_LE(stick_.plays() - before, 2 * 20) << "also where the force comes and goes";
}

TEST(EvdevForce, ReadableButNotWritable_SaysSo_UnlessItHasNoForceAnyway) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  FakeEventDevice mouse("/dev/input/fake1");
  for (const int error : {EACCES, EPERM, EROFS}) {
    stick.refuse_writing(error);
    mouse.refuse_writing(error);
    EvdevForce force(kPath);
    EXPECT_EQ(force.open(), ForceKind::kNone);
    EXPECT_EQ(force.problem(), "no permission to write to it (is the user in the group input?)");
    EvdevForce none("/dev/input/fake1");
    EXPECT_EQ(none.open(), ForceKind::kNone);
    EXPECT_EQ(none.problem(), "");
  }
  EXPECT_EQ(stick.open_files() + mouse.open_files(), 0);
}

TEST(EvdevForce, OfADeviceThatTheFencerDoesNotRead_IsNotOpened) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  const auto claim = std::make_shared<Claim>();
  EvdevForce force(kPath, claim);
  EXPECT_EQ(force.open(), ForceKind::kNone) << "it is nobody's";
  EvdevFeed feed(kPath, claim);
  ASSERT_EQ(feed.open(), "");
  EXPECT_EQ(force.open(), ForceKind::kForce);
  FakeEventDevice other("/dev/input/fake1");
  other.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  stick.give_name_to(other);
  EXPECT_EQ(force.open(), ForceKind::kNone) << "the name leads to another hand";
  EXPECT_EQ(other.uploads(), 0);
}

}  // namespace
}  // namespace batuta::host
