// SPDX-License-Identifier: MIT
// The lines of docs/forces.md, run: past the end of a bout, and where both are put on guard anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "forces_page.hpp"

namespace batuta::test {
using namespace fencing;
using namespace haptics;
namespace {

class HandClock final : public Clock {
 public:
  Microseconds time = 0;

 private:
  Microseconds do_now() override { return time; }
};

class LedStick final : public InputDevice {
 public:
  InputSample sample;
  bool silent = false;

 private:
  Status do_read(Microseconds now, InputSample& read) override {
    if (silent) return Status::kUnavailable;
    sample.time = now;
    ++sample.sequence;
    read = sample;
    return Status::kOk;
  }
};

class ToldMotor final : public ForceDevice {
 public:
  ForceCommand last;
  float hardest() const { return std::max(std::fabs(last.x), std::fabs(last.y)); }

 private:
  Status do_write(const ForceCommand& command) override {
    last = command;
    return Status::kOk;
  }
};

/// All that the lines need. The other fencer stands still.
struct Loop {
  std::unique_ptr<Duel<>> duel = std::make_unique<Duel<>>();
  HandForce<float> felt;
  ToldMotor motor;
  OutputStage stage{motor};
  std::uint32_t exchange = 1;
  LedStick stick;
  HandClock clock;

  void start(int touches, const StageSettings& settings) {
    auto bout = duel_settings();
    bout.touches = touches;
    ASSERT_EQ(duel->configure(bout, first_fencer<float>, second_fencer<float>), Status::kOk);
    ASSERT_EQ(felt.configure({}), Status::kOk);
    ASSERT_EQ(stage.configure(settings), Status::kOk);
    ASSERT_EQ(stage.enable(), Status::kOk);
  }
  void run(float x, float y) {
    clock.time += 1000;
    stick.sample.x = x;
    stick.sample.y = y;
    tick(*duel, felt, stage, exchange, stick, clock);
  }
};

/// A thrust along x = first, which from 400 ms on goes over to x = then.
struct Thrust {
  float first;
  float then;

  float y(int ms) const { return std::min(1.0F, static_cast<float>(ms) / 400.0F); }
  float x(int ms) const {
    const float over = std::clamp(static_cast<float>(ms - 400) / 200.0F, 0.0F, 1.0F);
    return first * y(ms) + (then - first) * over;
  }
};

/// What whoever holds the stick does when the bout is over.
enum class Afterwards { kStays, kLetsGo, kShakes, kUnplugs };

void go_on(Loop& loop, Afterwards what, int ms) {
  const InputSample last = loop.stick.sample;
  const float side = ms % 2 == 0 ? 1.0F : -1.0F;
  loop.stick.silent = what == Afterwards::kUnplugs;
  if (what == Afterwards::kLetsGo) return loop.run(0, 0);
  if (what == Afterwards::kShakes) return loop.run(side, -side);
  loop.run(last.x, last.y);
}

/// Of an end stop and nothing else: nothing within its start, and beyond it never outward.
void expect_end_stop_alone(float share, float position) {
  if (std::fabs(position) <= EndStopSettings().start) {
    EXPECT_EQ(share, 0.0F) << "at " << position;
  } else {
    EXPECT_LE(share * position, 0.0F) << "at " << position;
  }
}

/// @returns whether the motor was told a force when the bout ended, or nothing where it did not end
int forces_after_the_end(const Thrust& thrust, Afterwards what) {
  constexpr int kMost = 2500;         // ms
  constexpr int kAcrossTheRange = 8;  // steps of the slew limit: 250/s are 1/4 in each
  const RampSettings silence = StageSettings().commands;
  const int at_zero = silence.silent_after + silence.length;
  Loop loop;
  loop.start(1, {});
  for (int ms = 0; ms < kMost && !loop.duel->bout().is_over(); ++ms) {
    loop.run(thrust.x(ms), thrust.y(ms));
  }
  if (!loop.duel->bout().is_over()) return 0;
  const int forced = loop.motor.hardest() > 0.0F ? 1 : 0;
  for (int ms = 1; ms < 2 * at_zero; ++ms) {
    go_on(loop, what, ms);
    const Vec2<float> position = loop.duel->stick(Side::kLeft).position();
    if (ms >= kAcrossTheRange) {
      expect_end_stop_alone(loop.motor.last.x, position.x());
      expect_end_stop_alone(loop.motor.last.y, position.y());
    }
    if (ms >= at_zero) {
      EXPECT_EQ(loop.motor.hardest(), 0.0F) << ms << " ms after the end";
    }
    if (::testing::Test::HasFailure()) return forced;
  }
  return forced;
}

TEST(TheLines, AfterTheBout_TheMotorComesToZero_WhateverTheStickDoes) {
  int forced = 0;
  for (const float first : {-0.5F, 0.0F, 0.5F}) {
    for (const float then : {-1.0F, -0.5F, 0.5F, 1.0F}) {
      for (const Afterwards what :
           {Afterwards::kStays, Afterwards::kLetsGo, Afterwards::kShakes, Afterwards::kUnplugs}) {
        forced += forces_after_the_end({first, then}, what);
        ASSERT_FALSE(HasFailure()) << first << " to " << then << ", " << static_cast<int>(what);
      }
    }
  }
  EXPECT_GT(forced, 10) << "else there was nothing to let go";
}

/// A stage that shapes nothing: what the motor is told is a tenth of the demand, in its step.
StageSettings plain_stage() {
  StageSettings settings;
  settings.gain = {0.1F, 0.1F};
  settings.end_stop.stiffness = 0;
  settings.slew_rate = 2 / settings.dt;
  settings.fade = 1;
  return settings;
}

// On guard the blade is in the hand, and both are at rest: nothing pulls at the stick, however far
// the hand was out before. To rounding: 1e-7 m of 400 N/m, and in a millisecond of 2 N s/m, are
// 2.4e-4 N for each of 1 m, and as much of turns; of 10 that are the range.
TEST(TheLines, WhereBothArePutOnGuardAnew_NothingKicks) {
  constexpr float kRounded = 1e-4F;
  constexpr int kMost = 9000;  // ms
  Loop loop;
  loop.start(4, plain_stage());
  int restarts = 0;
  int since = 0;  // ms
  for (int ms = 0; ms < kMost && !loop.duel->bout().is_over(); ++ms) {
    const std::uint32_t before = loop.duel->bout().exchange;
    const float out = std::min(1.0F, static_cast<float>(ms % 4000) / 400.0F);
    loop.run(-0.5F * out, out);
    const bool anew = loop.duel->bout().exchange != before;
    restarts += anew ? 1 : 0;
    since = anew ? 0 : since + 1;
    if (restarts > 0 && since < 3) {
      EXPECT_LT(loop.motor.hardest(), kRounded) << "exchange " << before + 1 << " + " << since;
    }
  }
  EXPECT_TRUE(loop.duel->bout().is_over());
  EXPECT_EQ(restarts, 3);
}

TEST(TheLines, OfADuelThatIsNotThere_AreNoForce) {
  Loop loop;
  ASSERT_EQ(loop.felt.configure({}), Status::kOk);
  ASSERT_EQ(loop.stage.configure({}), Status::kOk);
  ASSERT_EQ(loop.stage.enable(), Status::kOk);
  for (int ms = 0; ms < 1000; ++ms) {
    loop.run(1, -1);
    ASSERT_EQ(loop.motor.hardest(), 0.0F) << ms;
  }
}

}  // namespace
}  // namespace batuta::test
