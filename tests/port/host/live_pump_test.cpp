// SPDX-License-Identifier: MIT
// What the threads of a live device do, turn by turn and without threads.
#include <gtest/gtest.h>

#include <deque>
#include <thread>
#include <vector>

#include "host/live/feed_pump.hpp"
#include "host/live/force_pump.hpp"

namespace batuta::host {
namespace {

TEST(Latest, TheLatestValueWins_AndIsHandedOutOnce) {
  Latest<int> box;
  int value = -1;
  EXPECT_FALSE(box.take(value));
  EXPECT_EQ(value, -1);
  for (const int next : {1, 2, 3}) box.put(next);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 3);
  EXPECT_FALSE(box.take(value));
  box.put(4);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 4);
}

TEST(Latest, BetweenTwoThreads_ValuesAreWholeAndInOrder) {
  struct Pair {
    unsigned a = 0;
    unsigned b = 0;
  };
  constexpr unsigned kLast = 200000;
  Latest<Pair> box;
  std::thread writer([&box] {
    for (unsigned i = 1; i <= kLast; ++i) box.put({i, ~i});
  });
  Pair pair;
  for (unsigned before = 0; before != kLast; before = pair.a) {
    if (!box.take(pair)) continue;
    ASSERT_EQ(pair.b, ~pair.a);
    ASSERT_GT(pair.a, before);
  }
  writer.join();
}

/// Says what it was told to say.
class ScriptedFeed final : public Feed {
 public:
  std::string name() const override { return "scripted"; }
  void wait() override {}
  News look(InputSample& sample) override {
    ++looks;
    if (gone) return News::kGone;
    if (samples.empty()) return News::kNone;
    sample = samples.front();
    samples.pop_front();
    return News::kSample;
  }
  bool reopen() override {
    ++attempts;
    gone = gone && !back;
    return !gone;
  }
  std::uint32_t losses() const override { return 7; }

  std::deque<InputSample> samples;
  bool gone = false;
  bool back = false;
  int looks = 0;
  int attempts = 0;
};

struct Pumped {
  explicit Pumped() : pump(std::unique_ptr<Feed>(feed)) {}
  ScriptedFeed* feed = new ScriptedFeed;  // the pump's, from here on
  FeedPump pump;
  InputSample sample;
};

TEST(FeedPump, ASample_IsHandedOn_AndSaidAgainInSilence) {
  Pumped rig;
  rig.pump.turn(1000);
  EXPECT_FALSE(rig.pump.take(rig.sample)) << "the device has not said anything yet";
  rig.feed->samples.push_back({1500, 0.5F, -0.5F, 3, 99});
  rig.pump.turn(2000);
  ASSERT_TRUE(rig.pump.take(rig.sample));
  EXPECT_EQ(rig.sample.time, 1500U);
  EXPECT_EQ(rig.sample.x, 0.5F);
  EXPECT_EQ(rig.sample.buttons, 3U);
  EXPECT_EQ(rig.sample.sequence, 1U) << "numbered here: it goes on when the device is opened anew";
  rig.pump.turn(1500 + FeedPump::kRepeat_us - 1);
  EXPECT_FALSE(rig.pump.take(rig.sample));
  rig.pump.turn(1500 + FeedPump::kRepeat_us);
  ASSERT_TRUE(rig.pump.take(rig.sample)) << "it is still there";
  EXPECT_EQ(rig.sample.time, 1500U + FeedPump::kRepeat_us);
  EXPECT_EQ(rig.sample.x, 0.5F);
  EXPECT_EQ(rig.sample.sequence, 2U);
  EXPECT_EQ(rig.pump.losses(), 7U);
}

TEST(FeedPump, AStampOfTheFuture_BecomesNow_AcrossTheWrap) {
  Pumped rig;
  const Microseconds now = 100;  // shortly after the wrap
  rig.feed->samples.push_back({0xFFFFFF00U, 0, 0, 0, 0});
  rig.pump.turn(now);
  ASSERT_TRUE(rig.pump.take(rig.sample));
  EXPECT_EQ(rig.sample.time, 0xFFFFFF00U) << "a moment ago";
  rig.feed->samples.push_back({5000, 0, 0, 0, 0});
  rig.pump.turn(200);
  ASSERT_TRUE(rig.pump.take(rig.sample));
  EXPECT_EQ(rig.sample.time, 200U);
}

TEST(FeedPump, Unplugged_ItIsSilentAndLookedFor_NotTooOften_AndGoesOn) {
  Pumped rig;
  rig.feed->samples.push_back({0, 1, 1, 0, 0});
  rig.pump.turn(0);
  rig.feed->gone = true;
  rig.pump.turn(1000);
  EXPECT_FALSE(rig.pump.is_attached());
  EXPECT_EQ(rig.pump.unplugs(), 1U);
  (void)rig.pump.take(rig.sample);
  for (Microseconds now = 2000; now < 1000000; now += 1000) rig.pump.turn(now);
  EXPECT_FALSE(rig.pump.take(rig.sample)) << "nothing is repeated that is not known any more";
  EXPECT_EQ(rig.feed->attempts, 3) << "a second, an attempt each quarter";
  rig.feed->back = true;
  rig.pump.turn(1001000);
  EXPECT_TRUE(rig.pump.is_attached());
  EXPECT_FALSE(rig.pump.take(rig.sample)) << "it has said nothing since";
  rig.feed->samples.push_back({1001500, -1, 0, 0, 0});
  rig.pump.turn(1002000);
  ASSERT_TRUE(rig.pump.take(rig.sample));
  EXPECT_EQ(rig.sample.x, -1.0F);
  EXPECT_EQ(rig.sample.sequence, 2U);
  EXPECT_EQ(rig.pump.unplugs(), 1U);
}

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
    if (busy) return Rendered::kLater;
    if (there) feels_.push_back(feel);
    return there ? Rendered::kDone : Rendered::kGone;
  }
  bool is_there() override { return there; }
  bool there = true;
  bool busy = false;
  int opened = 0;

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
  EXPECT_EQ(rig.feels.size(), 2U);
  rig.pump.put(1, 0);
  rig.turns(1);
  EXPECT_EQ(rig.feels.back().x, 1.0F) << "and life brings it back";
  EXPECT_EQ(rig.pump.report().silences, 1U);
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

TEST(ForcePump, LettingGo_IsZero) {
  ForceRig rig(ForceKind::kForce);
  rig.pump.put(1, 1);
  rig.turns(1);
  rig.pump.let_go();
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
