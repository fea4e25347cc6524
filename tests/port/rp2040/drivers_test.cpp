// SPDX-License-Identifier: MIT
// The drivers for the RP2040, on a fake of the Pico SDK's functions.

#include <gtest/gtest.h>

#include "batuta/haptics/output_stage.hpp"
#include "fake_pico.hpp"
#include "platforms/rp2040/board.hpp"
#include "platforms/rp2040/drivers/force_off.hpp"
#include "platforms/rp2040/drivers/pico_force.hpp"
#include "platforms/rp2040/drivers/pico_stick.hpp"
#include "platforms/rp2040/rhythm.hpp"

namespace batuta::rp2040::test {
namespace {

/// A stage that lets a demand through as it is, so that the force gets commands.
class Rp2040Force : public ::testing::Test {
 protected:
  Rp2040Force() {
    fake_pico() = {};
    force.configure();
    EXPECT_EQ(force.arm(), Status::kOk);
    haptics::StageSettings settings;
    settings.gain = {1.0F, 1.0F};
    settings.end_stop.stiffness = 0;
    settings.slew_rate = 2000;
    settings.fade = settings.samples.length = settings.commands.length = 1;
    EXPECT_EQ(stage.configure(settings), Status::kOk);
    EXPECT_EQ(stage.enable(), Status::kOk);
  }
  Status command(float x, float y) {
    haptics::StageInput input;
    input.demanded = {x, y};
    input.fresh_sample = input.fresh_command = true;
    return stage.step(input);
  }
  static std::array<int, 4> levels() {
    const auto& all = fake_pico().levels;
    return {all[2], all[3], all[4], all[5]};
  }
  static constexpr std::array<int, 4> kLow{};

  PicoForce force;
  haptics::OutputStage stage{force};
};

TEST_F(Rp2040Force, Pins_ArePulsedAndLowAtFirst) {
  EXPECT_EQ(levels(), kLow);
  EXPECT_EQ(fake_pico().wrap, 6249);
  for (const unsigned pin : {2U, 3U, 4U, 5U}) EXPECT_TRUE(fake_pico().is_pulsed.at(pin));
}

TEST_F(Rp2040Force, Command_PulsesOneInputOfEachBridge) {
  EXPECT_EQ(command(0.5F, -1.0F), Status::kOk);
  EXPECT_EQ(levels(), (std::array<int, 4>{3125, 0, 0, 6250}));
  EXPECT_EQ(command(-0.5F, 1.0F), Status::kOk);
  EXPECT_EQ(levels(), (std::array<int, 4>{0, 3125, 6250, 0}));
}

TEST_F(Rp2040Force, WithoutCommands_GuardTakesTheForceAfterItsTicks) {
  ASSERT_EQ(command(1.0F, 1.0F), Status::kOk);
  for (std::uint32_t i = 1; i < PicoForce::kGuardTicks; ++i) {
    force.guard_tick();
    EXPECT_NE(levels(), kLow) << i;
  }
  force.guard_tick();
  EXPECT_EQ(levels(), kLow);
  EXPECT_EQ(force.guard_ticks(), PicoForce::kGuardTicks);
  EXPECT_EQ(command(1.0F, 1.0F), Status::kOk);
  EXPECT_NE(levels(), kLow);
}

TEST_F(Rp2040Force, OpenLoop_TakesTheForceUntilArmedAgain) {
  ASSERT_EQ(command(1.0F, 1.0F), Status::kOk);
  fake_pico().loop_closed = false;
  force.guard_tick();
  EXPECT_EQ(levels(), kLow);
  EXPECT_EQ(command(1.0F, 1.0F), Status::kUnavailable);
  EXPECT_EQ(levels(), kLow);
  EXPECT_EQ(force.arm(), Status::kUnavailable);
  fake_pico().loop_closed = true;
  force.guard_tick();
  EXPECT_EQ(command(1.0F, 1.0F), Status::kUnavailable) << "closing it is not enough";
  EXPECT_EQ(force.arm(), Status::kOk);
  EXPECT_EQ(command(1.0F, 1.0F), Status::kOk);
}

TEST_F(Rp2040Force, ForceOff_NeedsNoObject) {
  ASSERT_EQ(command(1.0F, 1.0F), Status::kOk);
  force_off();
  EXPECT_EQ(levels(), kLow);
}

/// A stick that is read each millisecond.
struct TickedStick {
  /// @returns the status of the last of `readings`
  Status read(int readings, InputSample& sample) {
    Status status = Status::kOk;
    for (int i = 0; i < readings; ++i) status = stick.read(now += 1000, sample);
    return status;
  }
  PicoStick stick;
  Microseconds now = 0;
};

TEST(Rp2040Stick, Deflection_IsThatOfTheWipers) {
  fake_pico() = {};
  TickedStick ticked;
  ASSERT_EQ(ticked.stick.start(kStickAxis), Status::kOk);
  InputSample sample;
  fake_pico().counts = {4031, 64, 0, 0};  // the ends of what is a stick
  EXPECT_EQ(ticked.read(99, sample), Status::kUnavailable) << "not for a loose contact";
  ASSERT_EQ(ticked.read(1, sample), Status::kOk);
  EXPECT_EQ(sample.x, 1.0F);
  EXPECT_EQ(sample.y, -1.0F);
  fake_pico().counts = {2048, 2048, 0, 0};
  ASSERT_EQ(ticked.read(1, sample), Status::kOk);
  EXPECT_EQ(sample.x, 0.0F) << "in the dead zone";
}

TEST(Rp2040Stick, WiperThatIsOff_IsNoStick) {
  fake_pico() = {};
  TickedStick ticked;
  ASSERT_EQ(ticked.stick.start(kStickAxis), Status::kOk);
  InputSample sample;
  fake_pico().counts = {2048, 2048, 0, 0};
  ASSERT_EQ(ticked.read(100, sample), Status::kOk);
  fake_pico().counts = {2048, 4095, 0, 0};
  EXPECT_EQ(ticked.read(1, sample), Status::kUnavailable);
  EXPECT_FALSE(ticked.stick.is_connected());
}

TEST(Rp2040Stick, SameTime_IsConvertedOnce_AndTheNextIsTheNextSample) {
  fake_pico() = {};
  fake_pico().counts = {2048, 2048, 0, 0};
  TickedStick ticked;
  ASSERT_EQ(ticked.stick.start(kStickAxis), Status::kOk);
  InputSample first;
  ASSERT_EQ(ticked.read(150, first), Status::kOk);
  const int conversions = fake_pico().conversions;
  InputSample again = first;
  EXPECT_EQ(ticked.stick.read(ticked.now, again), Status::kUnavailable);
  EXPECT_EQ(fake_pico().conversions, conversions);
  InputSample next;
  ASSERT_EQ(ticked.read(1, next), Status::kOk);
  EXPECT_EQ(next.sequence, first.sequence + 1);
  EXPECT_EQ(fake_pico().conversions, conversions + 32) << "2 us each";
}

TEST(Rp2040Rhythm, LateTicksAreDroppedAndTheRhythmIsKept) {
  EXPECT_EQ(next_tick_us(5000, 5000, 1000), 6000U);
  EXPECT_EQ(next_tick_us(5000, 5999, 1000), 6000U);
  EXPECT_EQ(next_tick_us(5000, 6000, 1000), 7000U);  // that tick is over
  EXPECT_EQ(next_tick_us(5000, 9400, 1000), 10000U);
  EXPECT_EQ(next_tick_us(0xFFFFFF00U, 0x00000010U, 1000), 0xFFFFFF00U + 1000U);  // 272 us later
}

}  // namespace
}  // namespace batuta::rp2040::test
