// SPDX-License-Identifier: MIT
// Delay, duration and loops against a clock that counts single milliseconds, in steps of any
// length.

#include "shared/hid_pid/playback.hpp"

#include <gtest/gtest.h>

#include <random>

#include "host.hpp"

namespace batuta::pid {
namespace {

struct Plan {
  std::uint32_t delay;
  std::uint32_t duration;  // 0: no end
  std::uint32_t period;
  std::uint32_t loops;  // 0: no end
};

void expect_as_planned(const Playback& playback, const Plan& plan, std::uint64_t at) {
  const bool endless = plan.duration == 0 || plan.loops == 0;
  const bool over = !endless && at >= plan.delay + std::uint64_t{plan.duration} * plan.loops;
  ASSERT_EQ(playback.playing(), !over) << at;
  ASSERT_EQ(playback.sounding(), !over && at >= plan.delay) << at;
  if (over || at < plan.delay) return;
  const std::uint64_t heard = at - plan.delay;
  const std::uint64_t elapsed = plan.duration == 0 ? heard : heard % plan.duration;
  ASSERT_EQ(playback.elapsed_us(), std::min<std::uint64_t>(elapsed, 0x80000000U)) << at;
  ASSERT_EQ(playback.cycle_us(), plan.period == 0 ? 0 : elapsed % plan.period) << at;
}

TEST(PidPlayback, AnySteps_AreAsOneClockSaysIt) {
  std::mt19937 random(4);
  const auto below = [&](std::uint32_t n) {
    return static_cast<std::uint32_t>(random() % std::max(1U, n));
  };
  for (int run = 0; run < 2000; ++run) {
    const Plan plan = {below(3) * below(5000), below(4) * below(9000), below(3) * below(700),
                       below(5)};
    Playback playback;
    playback.start(plan.delay, plan.loops);
    playback.advance(12345, {plan.duration, plan.period});  // begins, whatever went before
    std::uint64_t at = 0;
    expect_as_planned(playback, plan, at);
    for (int i = 0; i < 40; ++i) {
      const std::uint32_t step = below(run % 2 == 0 ? 600U : 20000U);
      playback.advance(step, {plan.duration, plan.period});
      at += step;
      expect_as_planned(playback, plan, at);
    }
  }
}

TEST(PidPlayback, LongestSteps_DoNotWrap) {
  constexpr std::uint32_t kLongest = 0x7FFFFFFFU;
  const Plan plans[] = {{0, 0, 32767000, 1}, {32767000, 0, 999, 1}, {5, 32767000, 32766000, 0}};
  for (const Plan& plan : plans) {
    Playback playback;
    playback.start(plan.delay, plan.loops);
    playback.advance(0, {plan.duration, plan.period});
    std::uint64_t at = 0;
    for (int i = 0; i < 10; ++i) {
      playback.advance(kLongest, {plan.duration, plan.period});
      at += kLongest;
      if (plan.duration == 0) {
        ASSERT_EQ(playback.elapsed_us(), std::min<std::uint64_t>(at - plan.delay, 0x80000000U));
        ASSERT_EQ(playback.cycle_us(), (at - plan.delay) % plan.period);
      } else {
        expect_as_planned(playback, plan, at);
      }
    }
  }
}

// More than 2^32 of them.
TEST(PidPlayback, LoopsWithoutEnd_AreNotCounted) {
  Playback playback;
  playback.start(0, 0);
  for (int i = 0; i < 2200; ++i) {
    playback.advance(0x7FFFFFFFU, {1000, 0});
    ASSERT_TRUE(playback.sounding()) << i;
  }
}

TEST(PidPlayback, TimesChangedWhilePlaying_AreFollowed) {
  Playback playback;
  playback.start(0, 1);
  playback.advance(0, {0, 1000});
  playback.advance(2500, {0, 1000});
  EXPECT_EQ(playback.cycle_us(), 500U);
  playback.advance(0, {0, 300});
  EXPECT_EQ(playback.cycle_us(), 200U);
  playback.advance(0, {0, 0});
  EXPECT_EQ(playback.cycle_us(), 0U);
  EXPECT_TRUE(playback.sounding());
  playback.advance(0, {2500, 0});
  EXPECT_FALSE(playback.playing()) << "2.5 ms are over";
}

}  // namespace

namespace test {
namespace {

/// A constant force for some milliseconds; whether it is felt.
class Pulse : public Session {
 public:
  std::int64_t block;
  explicit Pulse(const Values& effect) : block(made(EffectType::kConstant)) {
    EXPECT_EQ(send(pid_usage(0x73), {{pid_usage(0x22), block}, {pid_usage(0x70), 10000}}),
              Status::kOk);
    EXPECT_EQ(set_effect(block, effect), Status::kOk);
  }
  bool felt(std::uint32_t step_us) { return force({}, step_us).y() != 0.0F; }
};

TEST(PidPlayback, DelayAndDuration_AreMilliseconds) {
  Pulse pulse({{pid_usage(0x50), 20}, {pid_usage(0xA7), 10}});
  EXPECT_FALSE(pulse.felt(1000)) << "not started";
  EXPECT_EQ(pulse.start(pulse.block, 2), Status::kOk);
  EXPECT_FALSE(pulse.felt(1000)) << "its time 0";
  EXPECT_FALSE(pulse.felt(9999));
  EXPECT_TRUE(pulse.felt(1)) << "the delay is over";
  EXPECT_TRUE(pulse.felt(20000)) << "the second loop, without a delay";
  EXPECT_TRUE(pulse.felt(19999));
  EXPECT_FALSE(pulse.felt(1));
  EXPECT_EQ(pulse.device.playing(), 0);
}

// Hosts say "no end" in two ways. A third, 0xFFFFFFFF of DirectInput, does not reach a device: the
// field has 16 bits.
TEST(PidPlayback, DurationsWithoutEnd_HaveNone) {
  for (const int duration : {0, 0xFFFF}) {
    Pulse pulse({{pid_usage(0x50), duration}});
    EXPECT_EQ(pulse.start(pulse.block), Status::kOk);
    for (int i = 0; i < 200; ++i) ASSERT_TRUE(pulse.felt(1800000000U)) << "half an hour more";
    EXPECT_EQ(pulse.stop(pulse.block), Status::kOk);
    EXPECT_FALSE(pulse.felt(0));
  }
}

TEST(PidPlayback, Loops_ZeroIsOneAnd255HasNoEnd) {
  Pulse pulse({{pid_usage(0x50), 20}});
  EXPECT_EQ(pulse.start(pulse.block, 0), Status::kOk);
  EXPECT_TRUE(pulse.felt(0));
  EXPECT_TRUE(pulse.felt(19999));
  EXPECT_FALSE(pulse.felt(1));
  EXPECT_EQ(pulse.start(pulse.block, 254), Status::kOk);
  pulse.felt(0);
  EXPECT_TRUE(pulse.felt(254 * 20000 - 1));
  EXPECT_FALSE(pulse.felt(1));
  EXPECT_EQ(pulse.start(pulse.block, 255), Status::kOk);
  pulse.felt(0);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(pulse.felt(2000000000U));
}

TEST(PidPlayback, StartedAgain_BeginsAgain) {
  Pulse pulse({{pid_usage(0x50), 20}});
  EXPECT_EQ(pulse.start(pulse.block), Status::kOk);
  pulse.felt(0);
  EXPECT_TRUE(pulse.felt(15000));
  EXPECT_EQ(pulse.start(pulse.block), Status::kOk);
  pulse.felt(0);
  EXPECT_TRUE(pulse.felt(15000));
  EXPECT_FALSE(pulse.felt(5000));
}

// The clock wraps; a clock that goes back stands still, and goes on from there.
TEST(PidPlayback, Clock_MayWrapAndGoBack) {
  Pulse pulse({{pid_usage(0x50), 20}});
  pulse.now = 0xFFFFFFF0U;
  pulse.felt(0);
  EXPECT_EQ(pulse.start(pulse.block), Status::kOk);
  pulse.felt(0);
  EXPECT_TRUE(pulse.felt(19999));
  EXPECT_LT(pulse.now, 20000U) << "it has wrapped";
  pulse.now -= 5000;
  EXPECT_TRUE(pulse.felt(0));
  EXPECT_FALSE(pulse.felt(1));
}

}  // namespace
}  // namespace test
}  // namespace batuta::pid
