// SPDX-License-Identifier: MIT
// What the thread of a force does, turn by turn and without the thread.
#include "programs/live/force_pump.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace batuta::host {
namespace {

class SetClock final : public Clock {
 public:
  Microseconds time = 0xFFFFF000U;  // it wraps during the tests

 private:
  Microseconds do_now() override { return time; }
};

/// Remembers what it was told to render.
class ScriptedBackend final : public ForceBackend {
 public:
  ScriptedBackend(ForceKind kind, std::vector<Feel>& feels) : kind_(kind), feels_(feels) {}
  ForceKind open() override {
    ++opened;
    return there ? kind_ : ForceKind::kNone;
  }
  Rendered render(const Feel& feel) override {
    if (!there) return Rendered::kGone;
    if (busy) return Rendered::kLater;
    if (kind_ == ForceKind::kNone) return Rendered::kRefused;
    feels_.push_back(feel);
    return Rendered::kDone;
  }
  void renew() override { ++renewed; }
  void close() override { ++closed; }
  ForceKind kind() const override { return kind_; }
  EffectSet left_out() const override { return lost; }
  bool is_there() override {
    ++asked;
    return there;
  }
  /// From now on it does no more than this.
  void take_only(ForceKind kind, EffectSet left_out) {
    kind_ = kind;
    lost = left_out;
  }
  EffectSet lost;
  int closed = 0;
  int asked = 0;
  bool there = true;
  bool busy = false;
  int opened = 0;
  int renewed = 0;

 private:
  ForceKind kind_;
  std::vector<Feel>& feels_;
};

struct ForceRig {
  explicit ForceRig(ForceKind kind, const ForceOptions& options = {})
      : backend(new ScriptedBackend(kind, feels)),
        pump(std::unique_ptr<ForceBackend>(backend), options, clock) {}

  void turns(int count) {
    for (int i = 0; i < count; ++i) {
      clock.time += ForcePump::kTurn_us;
      pump.turn();
    }
  }
  SetClock clock;
  std::vector<Feel> feels;
  ScriptedBackend* backend;  // the pump's
  ForcePump pump;
};

TEST(ForcePump, TheLatestForceWins_AndIsToldOnce) {
  ForceRig rig(ForceKind::kForce);
  rig.turns(1);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kForce);
  ASSERT_EQ(rig.feels.size(), 1U) << "a device that has just been opened is told zero";
  EXPECT_EQ(rig.feels[0].x, 0.0F);
  rig.pump.put(0.5F, 0.5F);
  rig.pump.put(0.25F, -1);
  rig.turns(10);
  ASSERT_EQ(rig.feels.size(), 2U) << "what has not changed is not told again";
  EXPECT_EQ(rig.feels[1].x, 0.25F);
  EXPECT_EQ(rig.feels[1].y, -1.0F);
}

TEST(ForcePump, Silence_TakesTheForceAway) {
  ForceRig rig(ForceKind::kForce);
  rig.pump.put(1, 0);
  rig.turns(100);
  EXPECT_EQ(rig.feels.back().x, 1.0F);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().x, 0.0F);
  EXPECT_EQ(rig.feels.size(), 3U) << "the force, once more before it ends by itself, and zero";
  rig.pump.put(1, 0);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().x, 1.0F) << "and life brings it back";
  EXPECT_EQ(rig.pump.report().silences, 1U);
}

TEST(ForcePump, WhatIsHeld_IsToPlayAgain_EvenAfterASleepOfAnHour) {
  ForceRig rig(ForceKind::kForce);
  const auto turn = [&rig] {
    rig.pump.put(1, 0);
    rig.turns(1);
  };
  for (int i = 0; i < 100; ++i) turn();
  const int before = rig.backend->renewed;
  EXPECT_EQ(before, 2) << "with the first word, and 50 ms later";
  rig.clock.time += 40U * 60U * 1000000U;  // two times are compared to 35 minutes
  turn();
  EXPECT_EQ(rig.backend->renewed, before + 1);
}

TEST(ForcePump, SilenceWithoutAForce_IsNone) {
  ForceRig rig(ForceKind::kForce);
  rig.pump.put(0, 0);
  rig.turns(300);
  EXPECT_EQ(rig.pump.report().silences, 0U);
}

TEST(ForcePump, Rumble_IsThrottled_AndABlowBetweenTwoOfThemIsFelt) {
  ForceRig rig(ForceKind::kRumble);
  rig.turns(1);
  int told = 0;
  for (int i = 0; i < 100; ++i) {  // a tenth of a second, a blow of one step among it
    rig.pump.put(i == 13 ? 1.0F : 0.001F * static_cast<float>(i), 0);
    const std::size_t before = rig.feels.size();
    rig.turns(1);
    told += static_cast<int>(rig.feels.size() - before);
  }
  EXPECT_EQ(told, 10) << "one each 10 ms";
  ASSERT_GE(rig.feels.size(), 3U);
  EXPECT_FLOAT_EQ(rig.feels[1].blow, 0.009F) << "the hardest of its 10 ms";
  EXPECT_EQ(rig.feels[2].blow, 1.0F);
  EXPECT_NEAR(static_cast<double>(rig.feels[2].x), 0.019, 1e-6) << "it was over when it was told";
  EXPECT_FLOAT_EQ(rig.feels[3].blow, 0.8F) << "and fades";
  EXPECT_FLOAT_EQ(rig.feels[4].blow, 0.6F);
}

TEST(ForcePump, ARumbleThatGoesOn_IsRenewed_AndEndsWithTheBlow) {
  ForceRig rig(ForceKind::kRumble);
  rig.turns(1);
  for (int i = 0; i < 200; ++i) {
    rig.pump.put(0, -0.5F);
    rig.turns(1);
  }
  EXPECT_EQ(rig.feels.size(), 1U + 4U) << "before each 50 ms are over: SDL's ends after 100";
  rig.pump.put(0, 0);
  rig.turns(100);
  EXPECT_EQ(rig.feels.back().blow, 0.0F);
  const std::size_t still = rig.feels.size();
  rig.turns(200);
  EXPECT_EQ(rig.feels.size(), still);
}

TEST(ForcePump, AGoneDevice_IsLookedFor_AndToldTheLatestForceWhenItIsBack) {
  ForceRig rig(ForceKind::kForce);
  rig.turns(1);
  rig.backend->there = false;
  rig.pump.put(1, 1);
  rig.turns(1);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kNone);
  EXPECT_EQ(rig.pump.report().unplugs, 1U);
  const int opened = rig.backend->opened;
  rig.pump.put(1, 1);
  rig.turns(1000);
  EXPECT_EQ(rig.backend->opened - opened, 4) << "each quarter of a second";
  rig.backend->there = true;
  rig.turns(300);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kForce);
  EXPECT_EQ(rig.feels.back().x, 0.0F) << "the force of long ago is not told";
  rig.pump.put(-1, 0);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().x, -1.0F);
}

TEST(ForcePump, ABusyDevice_IsToldAgainUntilItHasTakenTheForce) {
  ForceRig rig(ForceKind::kForce);
  rig.pump.put(1, 0);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().x, 1.0F);
  rig.backend->busy = true;
  rig.pump.put(0, 0);
  rig.turns(5);
  EXPECT_EQ(rig.feels.back().x, 1.0F);
  rig.backend->busy = false;
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().x, 0.0F) << "though nothing new was commanded";
  EXPECT_EQ(rig.pump.report().unplugs, 0U);
}

TEST(ForcePump, ADeviceThatGoesWhileItHasNothingToDo_IsMissed) {
  ForceRig rig(ForceKind::kForce);
  rig.turns(1);
  rig.backend->there = false;
  rig.turns(251);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kNone);
  rig.backend->there = true;
  rig.turns(251);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kForce) << "before the next blow";
}

TEST(ForcePump, ADeviceThatTakesLess_IsToldAtThePaceOfWhatItTakes_AndNotLost) {
  ForceRig rig(ForceKind::kForce);
  rig.turns(1);
  rig.backend->take_only(ForceKind::kRumble, EffectSet().add(Effect::kConstant));
  for (int i = 1; i <= 101; ++i) {
    rig.pump.put(0.005F * static_cast<float>(i), 0);
    rig.turns(1);
  }
  EXPECT_EQ(rig.feels.size(), 1U + 1U + 10U) << "one as a force, then each 10 ms";
  EXPECT_EQ(rig.pump.kind(), ForceKind::kRumble);
  EXPECT_EQ(rig.pump.report().unplugs, 0U);
  EXPECT_EQ(rig.pump.report().kind, ForceKind::kRumble);
  EXPECT_EQ(names_of(rig.pump.report().left_out), "constant");
  EXPECT_EQ(rig.backend->opened, 1);
}

TEST(ForcePump, ADeviceThatTakesNothing_IsNotAskedAgain_BeforeItIsPluggedInAnew) {
  ForceRig rig(ForceKind::kForce);
  rig.turns(1);
  rig.backend->take_only(ForceKind::kNone, EffectSet().add(Effect::kConstant));
  rig.pump.put(1, 0);
  rig.turns(5000);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kNone);
  EXPECT_EQ(rig.backend->opened, 1);
  EXPECT_EQ(rig.backend->asked, 19) << "only whether it is there, each quarter of a second";
  EXPECT_EQ(rig.pump.report().unplugs, 0U);
  EXPECT_EQ(rig.pump.report().kind, ForceKind::kNone);
  EXPECT_EQ(names_of(rig.pump.report().left_out), "constant");
  rig.backend->there = false;
  rig.turns(250);
  EXPECT_EQ(rig.pump.report().unplugs, 1U);
  rig.backend->there = true;
  rig.backend->take_only(ForceKind::kForce, {});
  rig.turns(251);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kForce);
  rig.pump.put(1, 0);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().x, 1.0F);
}

TEST(ForcePump, ADeviceThatIsBusyForTooLong_DoesNotKeepItsForce) {
  ForceRig rig(ForceKind::kForce);
  rig.pump.put(1, 0);
  rig.turns(1);
  rig.backend->busy = true;
  for (int i = 0; i < ForcePump::kSilence_us / ForcePump::kTurn_us + 1; ++i) {
    EXPECT_EQ(rig.backend->closed, 0) << i;
    rig.pump.put(0, 0);
    rig.turns(1);
  }
  rig.turns(1);
  EXPECT_EQ(rig.backend->closed, 1);
  EXPECT_EQ(rig.pump.report().stalls, 1U);
  EXPECT_EQ(rig.pump.report().unplugs, 0U);
  rig.backend->busy = false;
  rig.turns(251);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kForce) << "and it is tried again";
  EXPECT_EQ(rig.feels.back().x, 0.0F);
}

TEST(ForcePump, ADeviceThatIsBusyNowAndThen_IsKept) {
  ForceRig rig(ForceKind::kForce);
  for (int i = 0; i < 10; ++i) {
    rig.backend->busy = true;
    rig.pump.put(0.01F * static_cast<float>(i + 1), 0);
    rig.turns(ForcePump::kSilence_us / ForcePump::kTurn_us / 2);
    rig.backend->busy = false;
    rig.turns(1);
  }
  EXPECT_EQ(rig.pump.report().stalls, 0U);
  EXPECT_EQ(rig.backend->closed, 0);
}

TEST(ForcePump, Off_StopsARumbleAtOnce) {
  ForceRig rig(ForceKind::kRumble);
  rig.turns(1);
  for (int i = 0; i < 15; ++i) {  // off() comes amid the ten milliseconds
    rig.pump.put(1, 0);
    rig.turns(1);
  }
  EXPECT_EQ(rig.feels.back().blow, 1.0F);
  rig.pump.put(0, 0, 0);
  rig.turns(1);
  EXPECT_EQ(rumble_of(rig.feels.back()).strong, 0);
  EXPECT_EQ(rumble_of(rig.feels.back()).weak, 0);
  const std::size_t still = rig.feels.size();
  rig.turns(99);
  EXPECT_EQ(rig.feels.size(), still) << "nothing comes after it";
}

TEST(ForcePump, SilenceStopsARumbleAtOnce) {
  ForceRig rig(ForceKind::kRumble);
  rig.turns(1);
  for (int i = 0; i < 15; ++i) {
    rig.pump.put(1, 0);
    rig.turns(1);
  }
  rig.turns(ForcePump::kSilence_us / ForcePump::kTurn_us);
  EXPECT_EQ(rumble_of(rig.feels.back()).strong, 0);
}

TEST(ForcePump, AfterHoursWithoutAForce_ABlowIsToldAtOnce) {
  constexpr Microseconds kPause_us = 50000;
  constexpr int kPausesAMinute = 1200;
  for (const int minutes : {1, 35, 36, 50, 71, 72, 110}) {  // 31 bits are 35.8 minutes
    ForceRig rig(ForceKind::kRumble);
    rig.turns(1);
    for (int i = 0; i < minutes * kPausesAMinute; ++i) {
      rig.clock.time += kPause_us;
      rig.pump.put(0, 0);
      rig.pump.turn();
    }
    rig.pump.put(1, 0);
    rig.turns(1);
    ASSERT_EQ(rig.feels.size(), 2U) << minutes;
    EXPECT_EQ(rig.feels.back().blow, 1.0F);
  }
}

TEST(ForcePump, LettingGo_IsZero) {
  ForceRig rig(ForceKind::kForce);
  rig.pump.put(1, 1);
  rig.turns(1);
  rig.pump.drop_force();
  EXPECT_EQ(rig.feels.back().x, 0.0F);
  EXPECT_EQ(rig.feels.back().y, 0.0F);
  EXPECT_EQ(rig.pump.kind(), ForceKind::kNone);
}

TEST(ForcePump, SpringAndDamper_AreThereWhileSomebodyCommands) {
  ForceOptions options;
  options.spring.coefficient = 0.25F;
  options.damper.coefficient = 0.5F;
  ForceRig rig(ForceKind::kForce, options);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().spring.coefficient, 0.0F);
  rig.pump.put(0, 0);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().spring.coefficient, 0.25F);
  EXPECT_EQ(rig.feels.back().damper.coefficient, 0.5F);
  rig.pump.put(0, 0, 0.5F);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().spring.coefficient, 0.125F);
  EXPECT_EQ(rig.feels.back().damper.coefficient, 0.25F);
  rig.pump.put(0, 0, 0);  // an output stage that was stopped
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().spring.coefficient, 0.0F);
  EXPECT_EQ(rig.feels.back().damper.coefficient, 0.0F);
  rig.pump.put(0, 0);
  rig.turns(200);
  EXPECT_EQ(rig.feels.back().damper.coefficient, 0.0F);
}

TEST(ForcePump, PeriodJitterAndAge_AreMeasured) {
  ForceRig rig(ForceKind::kForce);
  rig.turns(1);
  const std::int32_t late_us[] = {0, 300, 0, 0};
  float force = 0;
  for (const std::int32_t late : late_us) {
    rig.pump.put(force += 0.1F, 0);
    rig.clock.time += static_cast<Microseconds>(late);
    rig.turns(1);
  }
  const ForceReport& report = rig.pump.report();
  EXPECT_EQ(report.sent, 5U);
  EXPECT_EQ(report.worst_period_us, 1300);
  EXPECT_DOUBLE_EQ(report.mean_period_us, 4300.0 / 4);
  EXPECT_DOUBLE_EQ(report.jitter_us, 300.0 / 4);
  EXPECT_EQ(report.worst_age_us, 1300);
  EXPECT_DOUBLE_EQ(report.mean_age_us, 4300.0 / 4);
}

}  // namespace
}  // namespace batuta::host
