// SPDX-License-Identifier: MIT
#include "programs/duel/duel_runner.hpp"

#include <gtest/gtest.h>

#include "bouts.hpp"
#include "heap_trap.hpp"
#include "programs/devices/replay_device.hpp"
#include "programs/duel/bout_words.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

/// A recording of a stick that stays at its centre, for so long; the last sample may be nonsense.
ReplayDevice still_stick(double duration, float last_x = 0) {
  Recording recording;
  recording.samples.resize(2);
  recording.samples[1].time = static_cast<Microseconds>(duration * 1e6);
  recording.samples[1].sequence = 1;
  recording.samples[1].x = last_x;
  recording.duration = duration;
  return {recording, "still"};
}

TEST(DuelRunner, TheDefaultBout_EndsWithATouchByTheLeft) {
  BoutRig bout("default", "script:parry");
  bout.run();
  EXPECT_EQ(bout.runner->ending(), Ending::kWon);
  EXPECT_STREQ(result_of(*bout.runner), "left");
  EXPECT_GE(bout.runner->tally().beats, 5U);
  EXPECT_EQ(bout.runner->tally().devices[0].refused, 0U);
  // In each other by no more than a blade's way back may leave them (src/world/detail/margin.md).
  EXPECT_GT(bout.runner->tally().smallest_gap, -7e-5F) << "blades do not go through each other";
  EXPECT_FALSE(bout.runner->step()) << "it is over";
}

TEST(DuelRunner, AStepThatTheBoutRefuses_IsNoEnd) {
  ReplayDevice left = still_stick(0.5);
  ReplayDevice right = still_stick(0.5);
  const auto runner = std::make_unique<DuelRunner>(left, right, 0.5);  // not started
  EXPECT_FALSE(runner->step());
  EXPECT_EQ(runner->status(), Status::kInvalidArgument);
  EXPECT_EQ(runner->ending(), Ending::kNone);
  ASSERT_EQ(runner->start(), Status::kOk);
  EXPECT_TRUE(runner->step());
  EXPECT_EQ(runner->status(), Status::kOk);
}

TEST(DuelRunner, AnAttackOnAGuard_Hits_FromEitherSide) {
  BoutRig from_left("script:attack", "script:guard");
  from_left.run();
  EXPECT_STREQ(result_of(*from_left.runner), "left");
  BoutRig from_right("script:guard", "script:attack");
  from_right.run();
  EXPECT_STREQ(result_of(*from_right.runner), "right");
}

TEST(DuelRunner, ABoutToThree_HasThreeExchanges) {
  BoutRig bout("script:attack", "script:guard", 60, {3});
  bout.run();
  EXPECT_EQ(bout.runner->ending(), Ending::kWon);
  EXPECT_STREQ(result_of(*bout.runner), "left");
  EXPECT_EQ(score_of(bout.runner->duel().bout()), (std::array<int, 2>{3, 0}));
  EXPECT_EQ(bout.runner->duel().bout().exchange, 3U);
}

TEST(DuelRunner, TimeIsOver_WhoIsAheadWins) {
  BoutRig bout("script:guard", "script:attack", 4, {5});
  bout.run();
  EXPECT_EQ(bout.runner->ending(), Ending::kWon);
  EXPECT_STREQ(result_of(*bout.runner), "right");
  EXPECT_DOUBLE_EQ(bout.runner->now(), 4);
  EXPECT_FALSE(bout.runner->duel().bout().is_over());
}

// In the lockout the touch is there already, and the score does not know it yet.
TEST(DuelRunner, TimeIsOverInTheLockout_TheTouchCounts) {
  BoutRig whole("script:attack", "script:guard");
  whole.run();
  const double touched = 1e-6 * static_cast<double>(whole.runner->duel().time_us(
                                    whole.runner->duel().bout().touches[0].when));
  BoutRig bout("script:attack", "script:guard", touched + 0.01, {5});
  bout.run();
  EXPECT_EQ(bout.runner->duel().bout().state, BoutState::kLockout);
  EXPECT_EQ(bout.runner->ending(), Ending::kWon);
  EXPECT_STREQ(result_of(*bout.runner), "left");
}

// The paper's search tells the same bout, by other bits, and with more evaluations.
TEST(DuelRunner, EitherSearch_TellsTheSameExchanges) {
  const auto play = [](SearchKind search) {
    auto bout =
        std::make_unique<BoutRig>("script:attack", "script:guard", 60.0, BoutRules{2, search});
    bout->run();
    EXPECT_EQ(bout->runner->bout().search(), search);
    return bout;
  };
  const auto certified = play(SearchKind::kAdvancement);
  const auto paper = play(SearchKind::kStepping);
  EXPECT_NE(certified->runner->bout().on_board(), nullptr);
  EXPECT_EQ(paper->runner->bout().on_board(), nullptr);
  EXPECT_EQ(score_of(certified->runner->duel().bout()), score_of(paper->runner->duel().bout()));
  EXPECT_NEAR(certified->runner->now(), paper->runner->now(), 0.01);
  EXPECT_GT(paper->runner->duel().report().evaluations,
            2 * certified->runner->duel().report().evaluations);
}

TEST(DuelRunner, TwoGuards_ADrawAtTheLimit) {
  BoutRig bout("script:guard", "script:guard", 2.5);
  bout.run();
  EXPECT_EQ(bout.runner->ending(), Ending::kDraw);
  EXPECT_EQ(bout.runner->duel().steps(), 2500U);
  EXPECT_DOUBLE_EQ(bout.runner->now(), 2.5);
}

TEST(DuelRunner, WithoutALimit_ScriptsFenceAPeriod) {
  BoutRig bout("script:guard", "script:parry");
  EXPECT_EQ(bout.runner->limit(), DuelRunner::kBoutLength);
}

TEST(DuelRunner, TheLongerRecordingCounts_AndTheShorterStays) {
  ReplayDevice left = still_stick(0.5);
  ReplayDevice right = still_stick(1.25);
  const auto runner =
      std::make_unique<DuelRunner>(left, right, std::numeric_limits<double>::infinity());
  ASSERT_EQ(runner->start(), Status::kOk);
  while (runner->step()) {
  }
  EXPECT_EQ(runner->ending(), Ending::kDraw);
  EXPECT_DOUBLE_EQ(runner->now(), 1.25);
  EXPECT_TRUE(runner->tally().devices[0].ended);
  EXPECT_DOUBLE_EQ(runner->tally().devices[0].ended_at, 0.5);
  EXPECT_FALSE(runner->tally().devices[1].ended);
}

TEST(DuelRunner, WhatADeviceMayNotDeliver_IsRefusedAndCounted) {
  ReplayDevice left = still_stick(0.1, 7.0F);
  ReplayDevice right = still_stick(0.2);
  const auto runner = std::make_unique<DuelRunner>(left, right, 1.0);
  ASSERT_EQ(runner->start(), Status::kOk);
  while (runner->step()) {
  }
  EXPECT_EQ(runner->tally().devices[0].samples, 1U);
  EXPECT_EQ(runner->tally().devices[0].refused, 1U);
  EXPECT_EQ(rejected(*runner, Side::kLeft), 1U);
  EXPECT_EQ(rejected(*runner, Side::kRight), 0U);
}

TEST(DuelRunner, TheSameTwice_BitForBit) {
  BoutRig a("default", "script:parry", 4);
  BoutRig b("default", "script:parry", 4);
  bool going_on = true;
  while (going_on) {
    going_on = a.runner->step();
    ASSERT_EQ(b.runner->step(), going_on);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Capsule<float> blade_a = a.runner->duel().blade_W(side);
      const Capsule<float> blade_b = b.runner->duel().blade_W(side);
      ASSERT_EQ(blade_a.axis.a, blade_b.axis.a);
      ASSERT_EQ(blade_a.axis.b, blade_b.axis.b);
    }
  }
}

TEST(DuelRunner, SteadyState_AllocatesNothing) {
  BoutRig bout("default", "script:parry");
  int allocations = 0;
  int steps = 0;
  bool going_on = true;
  while (going_on) {
    const test::HeapTrap trap;
    going_on = bout.runner->step();
    allocations += trap.allocations() + trap.releases();
    ++steps;
  }
  EXPECT_GT(steps, 5000);
  EXPECT_EQ(allocations, 0);
}

}  // namespace
}  // namespace batuta::host
