// SPDX-License-Identifier: MIT
// A time's field has 16 bits, and the descriptor announces 15 of them: whatever a host writes there
// counts as the longest, wherever there is a time, and the rest of the report is as it asks.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "host.hpp"

namespace batuta::pid::test {
namespace {

constexpr std::int64_t kBeyond[] = {32768, 40000, 65534, 65535};
constexpr std::uint32_t kHalfOfLongestUs = 16383500;

/// An effect from the south that a host has said everything of but its times.
class Timed : public Session {
 public:
  std::int64_t block;
  explicit Timed(EffectType type) : block(made(type)) {}
  Status wave(std::int64_t period_ms) {
    return send(pid_usage(0x6E),
                {{pid_usage(0x22), block}, {pid_usage(0x70), 8000}, {pid_usage(0x72), period_ms}});
  }
  Status constant() {
    return send(pid_usage(0x73), {{pid_usage(0x22), block}, {pid_usage(0x70), 8000}});
  }
  /// From a quarter, to a half.
  Status envelope(std::int64_t attack_ms, std::int64_t fade_ms) {
    return send(pid_usage(0x5A), {{pid_usage(0x22), block},
                                  {pid_usage(0x5B), 2500},
                                  {pid_usage(0x5C), attack_ms},
                                  {pid_usage(0x5D), 5000},
                                  {pid_usage(0x5E), fade_ms}});
  }
  Status effect(std::int64_t duration_ms, std::int64_t delay_ms) {
    return set_effect(
        block,
        {{pid_usage(0x50), duration_ms}, {pid_usage(0xA7), delay_ms}, {0x0A0001, degrees(180)}});
  }
  float felt(std::uint32_t step_us) { return force({}, step_us).y(); }
};

TEST(PidTimes, PeriodBeyondTheLongest_IsTheLongest) {
  for (const std::int64_t period : kBeyond) {
    Timed saw(EffectType::kSawtoothUp);
    EXPECT_EQ(saw.wave(100), Status::kOk);
    EXPECT_EQ(saw.wave(period), Status::kOk);
    EXPECT_EQ(saw.effect(0, 0), Status::kOk);
    EXPECT_EQ(saw.start(saw.block), Status::kOk);
    EXPECT_FLOAT_EQ(saw.felt(0), -0.8F) << period;
    EXPECT_NEAR(saw.felt(kHalfOfLongestUs), 0.0F, 1e-6F) << period;
    EXPECT_NEAR(saw.felt(kHalfOfLongestUs - 1000), 0.8F - 1.6F / 32767, 1e-6F) << period;
    EXPECT_FLOAT_EQ(saw.felt(1000), -0.8F) << period;
  }
}

TEST(PidTimes, EnvelopeBeyondTheLongest_IsTheLongest) {
  for (const std::int64_t time : kBeyond) {
    Timed rising(EffectType::kConstant);
    EXPECT_EQ(rising.constant(), Status::kOk);
    EXPECT_EQ(rising.envelope(time, 0), Status::kOk);
    EXPECT_EQ(rising.effect(0, 0), Status::kOk);
    EXPECT_EQ(rising.start(rising.block), Status::kOk);
    EXPECT_FLOAT_EQ(rising.felt(0), 0.25F) << time;
    EXPECT_FLOAT_EQ(rising.felt(kHalfOfLongestUs), 0.525F) << time;
    EXPECT_FLOAT_EQ(rising.felt(kHalfOfLongestUs), 0.8F) << time;
    Timed falling(EffectType::kConstant);
    EXPECT_EQ(falling.constant(), Status::kOk);
    EXPECT_EQ(falling.envelope(0, time), Status::kOk);
    EXPECT_EQ(falling.effect(32767, 0), Status::kOk);
    EXPECT_EQ(falling.start(falling.block), Status::kOk);
    EXPECT_FLOAT_EQ(falling.felt(0), 0.8F) << time;
    EXPECT_FLOAT_EQ(falling.felt(kHalfOfLongestUs), 0.65F) << time;
  }
}

std::int64_t cut(std::int64_t ms) {
  return std::min<std::int64_t>(ms, 32767);
}

/// The times of an effect, as a host sends them.
struct Times {
  std::int64_t duration, delay, period, attack, fade;

  bool is_beyond() const {
    const bool ends = duration != 0xFFFF;
    return (ends && duration > 32767) || delay > 32767 || period > 32767 || attack > 32767 ||
           fade > 32767;
  }
  Times within() const {
    return {duration == 0xFFFF ? 0 : cut(duration), cut(delay), cut(period), cut(attack),
            cut(fade)};
  }
};

/// An effect with other times before, which must be gone.
class Played : public Timed {
 public:
  Played(EffectType type, const Times& times) : Timed(type) {
    take(type, {7, 3, 5, 2, 1});
    take(type, times);
    EXPECT_EQ(start(block, 2), Status::kOk);
    EXPECT_EQ(device.counters().refused(), 0U);
  }

 private:
  void take(EffectType type, const Times& times) {
    EXPECT_EQ(is_periodic(type) ? wave(times.period) : constant(), Status::kOk);
    EXPECT_EQ(envelope(times.attack, times.fade), Status::kOk);
    EXPECT_EQ(effect(times.duration, times.delay), Status::kOk);
  }
};

// What any times make is to the bit what they make cut, from the beginning to beyond the end.
TEST(PidTimes, AnyTimes_AreFeltAsTheyAreCut) {
  std::mt19937 random(11);
  const auto time = [&] {
    const auto any = static_cast<std::int64_t>(random() % 0x10000U);
    return random() % 4 == 0 ? any >> 6U : any;  // short ones, too
  };
  int beyond = 0;
  int felt = 0;
  for (int run = 0; run < 200; ++run) {
    const auto type = run % 2 == 0 ? EffectType::kConstant : EffectType::kSawtoothDown;
    const Times times{run % 7 == 0 ? 0xFFFF : time(), time(), time(), time(), time()};
    Played as_sent(type, times);
    Played as_cut(type, times.within());
    beyond += times.is_beyond() ? 1 : 0;
    for (int step = 0; step < 60; ++step) {
      const auto us = static_cast<std::uint32_t>(random() % 4000000U);
      const float force = as_sent.felt(us);
      ASSERT_EQ(force, as_cut.felt(us)) << "run " << run << ", step " << step;
      felt += force != 0.0F ? 1 : 0;
    }
  }
  EXPECT_GT(beyond, 150);
  EXPECT_GT(felt, 200 * 20);
}

}  // namespace
}  // namespace batuta::pid::test
