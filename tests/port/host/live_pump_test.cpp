// SPDX-License-Identifier: MIT
// What the thread that reads a live device does, turn by turn and without threads.
#include <gtest/gtest.h>

#include <deque>
#include <thread>

#include "programs/live/feed_pump.hpp"
#include "programs/live/latest.hpp"

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
  rig.feed->samples.push_back({1500, 0.5F, -0.5F, 0.25F, -1.0F, 3, 99});
  rig.pump.turn(2000);
  ASSERT_TRUE(rig.pump.take(rig.sample));
  EXPECT_EQ(rig.sample.time, 1500U);
  EXPECT_EQ(rig.sample.x, 0.5F);
  EXPECT_EQ(rig.sample.feet_y, -1.0F);
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

}  // namespace
}  // namespace batuta::host
