// SPDX-License-Identifier: MIT
#include "batuta/haptics/output_stage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stage_rig.hpp"

namespace batuta {
using namespace haptics;
namespace {

using test::alive;
using test::open_settings;
using test::StageRig;

constexpr int kLong = 100;  // steps: more than any ramp here
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

StageInput silent(const Vec2<float>& demanded) {
  StageInput input;
  input.demanded = demanded;
  return input;
}

TEST(OutputStage, InHealth_TellsTheDemandItself) {
  StageRig rig;
  const Vec2<float> demand(0.5F, -0.25F);
  EXPECT_EQ(rig.run(kLong, alive(demand)), demand);
  EXPECT_FALSE(rig.stage.limits().ramped || rig.stage.limits().clipped ||
               rig.stage.limits().end_stop || rig.stage.limits().speed || rig.stage.limits().slew);
  EXPECT_EQ(rig.stage.last_command().x, 0.5F);
  EXPECT_EQ(rig.stage.report().steps, 100U);
  StageInput input = alive(demand);
  input.time = 77;
  ASSERT_EQ(rig.stage.step(input), Status::kOk);
  EXPECT_EQ(rig.motor.told.back().time, 77U);
}

TEST(OutputStage, Gain_IsByAxis) {
  StageSettings settings = open_settings();
  settings.gain = {0.01F, 0.02F};
  StageRig rig(settings);
  EXPECT_EQ(rig.run(kLong, alive({50, -25})), Vec2<float>(0.5F, -0.5F));
}

TEST(OutputStage, TooMuch_IsClippedInItsDirection_AndCounted) {
  StageRig rig;
  rig.run(50, alive({1, 1}));
  EXPECT_EQ(rig.stage.report().clipped_share(), 0.0F);
  EXPECT_EQ(rig.run(25, alive({-4, 2})), Vec2<float>(-1, 0.5F));
  EXPECT_TRUE(rig.stage.limits().clipped);
  rig.run(25, alive({-2, 2}));
  EXPECT_EQ(rig.stage.report().clipped, 50U);
  EXPECT_EQ(rig.stage.report().clipped_share(), 0.5F);
  EXPECT_EQ(rig.stage.report().worst_excess, 3.0F);
}

TEST(OutputStage, WhatWasCutBeforeTheStage_IsCountedWithWhatIsCutHere) {
  StageRig rig(open_settings());
  StageInput cut = alive({1, 0});
  cut.clipped = true;
  rig.run(25, alive({1, 0}));
  rig.run(25, cut);
  EXPECT_TRUE(rig.stage.limits().clipped);
  EXPECT_EQ(rig.stage.report().worst_excess, 0.0F);
  cut.excess = 7;
  rig.run(25, cut);
  cut.demanded.x() = 2;  // here as well: counted once
  cut.excess = 0.5F;
  rig.run(25, cut);
  EXPECT_EQ(rig.stage.report().clipped, 75U);
  EXPECT_EQ(rig.stage.report().worst_excess, 7.0F);
  cut.excess = INFINITY;
  EXPECT_EQ(rig.stage.step(cut), Status::kInvalidArgument);
}

/// Else a force of many ranges would push through the stop, and outlast the ramps.
TEST(OutputStage, TooMuch_WinsAgainstNoLaterStep) {
  StageSettings settings = open_settings();
  settings.end_stop = {0.5F, 4, 0};
  StageRig rig(settings);
  StageInput input = alive({1000, 0});
  input.position = {0.75F, 0};
  EXPECT_EQ(rig.run(kLong, input).x(), -1.0F) << "end stop";
  EXPECT_TRUE(rig.stage.limits().end_stop);
  rig.run(5, silent({1000, 0}));
  EXPECT_EQ(rig.run(5, silent({1000, 0})).x(), 0.8F) << "5 of 25 steps of the ramp";
  rig.run(kLong, alive({1000, 0}));
  input.position = {0, 0};
  input.velocity = {22, 0};
  EXPECT_LT(rig.run(1, input).x(), 0.1F) << "speed limit";
  EXPECT_TRUE(rig.stage.limits().speed);
}

TEST(OutputStage, EachAxis_HasItsOwnPlaceAndSpeed) {
  StageSettings settings = open_settings();
  settings.end_stop = {0.5F, 4, 0};
  settings.speed_limit = {10, 0.125F, 0};
  for (const int axis : {0, 1}) {
    StageRig rig(settings);
    StageInput input = alive({0.5F, 0.5F});
    input.position[axis] = 0.75F;
    Vec2<float> stopped(0.5F, 0.5F);
    stopped[axis] = -1;
    EXPECT_EQ(rig.run(kLong, input), stopped);
    input.position[axis] = 0;
    input.velocity[axis] = 12;
    Vec2<float> slower(0.5F, 0.5F);
    slower[axis] = 0.25F;
    EXPECT_EQ(rig.run(kLong, input), slower);
  }
}

TEST(OutputStage, SlewLimit_HoldsFromStepToStep) {
  StageSettings settings = open_settings();
  settings.slew_rate = 250;
  StageRig rig(settings);
  rig.run(kLong, alive({0, 0}));
  for (const float share : {0.25F, 0.5F, 0.75F, 1.0F}) {
    EXPECT_EQ(rig.run(1, alive({1, 0})).x(), share);
    EXPECT_EQ(rig.stage.limits().slew, share < 1);
  }
}

TEST(OutputStage, SilenceOfTheStick_TakesTheForceInTheStatedTime) {
  StageRig rig;
  rig.run(kLong, alive({1, -0.5F}));
  StageInput input = alive({1, -0.5F});
  input.fresh_sample = false;
  EXPECT_EQ(rig.run(10, input), Vec2<float>(1, -0.5F));
  EXPECT_EQ(rig.run(10, input), Vec2<float>(0.5F, -0.25F));
  EXPECT_EQ(rig.stage.report().sample_silences, 1U);
  EXPECT_TRUE(rig.stage.limits().ramped);
  EXPECT_EQ(rig.run(10, input), Vec2<float>(0, 0));
  EXPECT_EQ(rig.run(kLong, input), Vec2<float>(0, 0));
  EXPECT_EQ(rig.stage.report().sample_silences, 1U);
  EXPECT_EQ(rig.stage.report().command_silences, 0U);
  EXPECT_EQ(rig.run(10, alive({1, 0})).x(), 0.5F) << "back as slowly";
}

TEST(OutputStage, SilenceOfTheDemand_TakesTheForceInTheStatedTime) {
  StageRig rig;
  rig.run(kLong, alive({1, 0}));
  StageInput input = alive({1, 0});
  input.fresh_command = false;
  EXPECT_EQ(rig.run(5, input).x(), 1.0F);
  EXPECT_EQ(rig.run(5, input).x(), 0.8F);
  EXPECT_EQ(rig.run(20, input).x(), 0.0F);
  EXPECT_EQ(rig.stage.report().command_silences, 1U);
  EXPECT_EQ(rig.stage.report().sample_silences, 0U);
}

TEST(OutputStage, Disabled_IsWithoutForce_AndFadesInAndOut) {
  StageRig rig;
  ASSERT_EQ(rig.stage.configure(open_settings()), Status::kOk);
  EXPECT_FALSE(rig.stage.is_enabled());
  EXPECT_EQ(rig.run(kLong, alive({1, 0})).x(), 0.0F);
  ASSERT_EQ(rig.stage.enable(), Status::kOk);
  EXPECT_EQ(rig.run(10, alive({1, 0})).x(), 0.25F);
  EXPECT_EQ(rig.motor.told.back().own, 0.25F) << "what the device adds fades alike";
  EXPECT_EQ(rig.run(30, alive({1, 0})).x(), 1.0F);
  rig.stage.disable();
  EXPECT_EQ(rig.run(10, alive({1, 0})).x(), 0.75F);
  EXPECT_EQ(rig.run(30, alive({1, 0})).x(), 0.0F);
}

TEST(OutputStage, EmergencyStop_IsZeroAtOnce_AndStays) {
  StageRig rig;
  rig.run(kLong, alive({1, 1}));
  rig.stage.stop(99);
  EXPECT_EQ(rig.last(), Vec2<float>(0, 0)) << "at once, not in the next step";
  EXPECT_EQ(rig.motor.told.back().time, 99U);
  EXPECT_EQ(rig.motor.told.back().own, 0.0F);
  for (int i = 0; i < kLong; ++i) {
    EXPECT_EQ(rig.stage.step(alive({1, 1})), Status::kUnavailable);
    EXPECT_EQ(rig.last(), Vec2<float>(0, 0));
  }
  EXPECT_EQ(rig.stage.report().stops, 100U);
  EXPECT_EQ(rig.stage.enable(), Status::kUnavailable);
  EXPECT_EQ(rig.stage.configure(open_settings()), Status::kOk);
  EXPECT_TRUE(rig.stage.is_stopped()) << "nothing but reset() ends it";
}

TEST(OutputStage, AfterAnEmergencyStop_TheForceFadesIn_OnceEnabled) {
  for (const int stopped_steps : {0, 10}) {
    StageRig rig;
    rig.run(kLong, alive({1, 0}));
    rig.stage.stop(0);
    for (int i = 0; i < stopped_steps; ++i) (void)rig.stage.step(alive({1, 0}));
    rig.stage.reset();
    EXPECT_FALSE(rig.stage.is_stopped());
    EXPECT_FALSE(rig.stage.is_enabled());
    EXPECT_EQ(rig.run(kLong, alive({1, 0})).x(), 0.0F);
    ASSERT_EQ(rig.stage.enable(), Status::kOk);
    EXPECT_EQ(rig.run(10, alive({1, 0})).x(), 0.25F);
  }
}

TEST(OutputStage, AfterAnEmergencyStop_TheSlewLimitStartsAtZero) {
  StageSettings settings = open_settings();
  settings.slew_rate = 10;
  settings.fade = 1;
  StageRig rig(settings);
  rig.run(200, alive({1, 0}));
  rig.stage.stop(0);
  rig.stage.reset();
  ASSERT_EQ(rig.stage.enable(), Status::kOk);
  EXPECT_EQ(rig.run(1, alive({1, 0})).x(), settings.slew_rate * settings.dt);
}

/// The worst moment for an interrupt: the step has decided, the motor has not been told yet.
TEST(OutputStage, EmergencyStopWithinAStep_EndsWithZero) {
  StageRig rig;
  rig.run(kLong, alive({1, 1}));
  rig.motor.during_write = [&] { rig.stage.stop(5); };
  EXPECT_EQ(rig.stage.step(alive({1, 1})), Status::kUnavailable);
  EXPECT_EQ(rig.last(), Vec2<float>(0, 0));
  EXPECT_EQ(rig.stage.last_command().x, 0.0F);
  EXPECT_EQ(rig.stage.step(alive({1, 1})), Status::kUnavailable);
}

TEST(OutputStage, ADeviceThatIsGone_IsCounted_AndFadesInWhenItIsBack) {
  StageRig rig;
  rig.run(kLong, alive({1, 0}));
  rig.motor.status = Status::kUnavailable;
  for (int i = 0; i < 7; ++i) EXPECT_EQ(rig.stage.step(alive({1, 0})), Status::kUnavailable);
  EXPECT_EQ(rig.stage.report().refused, 7U);
  EXPECT_EQ(rig.stage.report().stops, 0U);
  rig.motor.status = Status::kOk;
  EXPECT_EQ(rig.run(10, alive({1, 0})).x(), 0.25F);
}

TEST(OutputStage, UnlessAskedOtherwise_FadesInForHalfASecond) {
  StageSettings settings = open_settings();
  settings.fade = StageSettings{}.fade;
  StageRig rig(settings);
  EXPECT_EQ(rig.run(250, alive({1, 0})).x(), 0.5F);
  EXPECT_LT(rig.run(249, alive({1, 0})).x(), 1.0F);
  EXPECT_EQ(rig.run(1, alive({1, 0})).x(), 1.0F) << "500 steps of 1 ms";
}

TEST(OutputStage, OfAllRamps_TheOneThatLeavesLeastDecides) {
  StageRig rig;
  StageInput input = alive({1, -1});
  input.allowed = 0.25F;
  EXPECT_EQ(rig.run(4, input).x(), 0.1F) << "4 of 40 steps of the fade";
  EXPECT_EQ(rig.run(kLong, input), Vec2<float>(0.25F, -0.25F));
  input.fresh_sample = false;
  EXPECT_EQ(rig.run(20, input).x(), 0.25F);
  EXPECT_EQ(rig.run(6, input).x(), 0.2F) << "4 of 20 steps to silence";
  for (const float bad : {-0.1F, 1.1F, kNan}) {
    input.allowed = bad;
    EXPECT_EQ(rig.stage.step(input), Status::kInvalidArgument);
    EXPECT_EQ(rig.last(), Vec2<float>(0, 0));
  }
}

TEST(OutputStage, WhatIsNoNumber_IsNoDemandAndNoSignOfLife) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int place = 0; place < 6; ++place) {
      StageRig rig;
      rig.run(kLong, alive({1, 1}));
      StageInput input = alive({1, 1});
      Vec2<float>* const parts[] = {&input.demanded, &input.position, &input.velocity};
      (*parts[place / 2])[place % 2] = bad;
      EXPECT_EQ(rig.stage.step(input), Status::kInvalidArgument);
      EXPECT_EQ(rig.last(), Vec2<float>(0, 0));
      EXPECT_EQ(rig.stage.report().invalid, 1U);
      EXPECT_EQ(rig.run(1, alive({0.5F, 0})).x(), 0.5F) << "and leaves nothing behind";
      for (int i = 0; i < kLong; ++i) (void)rig.stage.step(input);
      EXPECT_EQ(rig.stage.report().sample_silences, 1U);
      EXPECT_EQ(rig.stage.report().command_silences, 1U);
    }
  }
}

/// Else one bad number would let go what the demander's own ramp holds back: a blow out of nothing.
TEST(OutputStage, WhatIsNoNumber_AllowsNoMoreThanBefore) {
  StageSettings settings = open_settings();
  settings.slew_rate = 250;  // what was demanded is still there when the number comes
  StageRig rig(settings);
  StageInput input = alive({1, 1});
  rig.run(kLong, input);
  input.allowed = 0;
  EXPECT_EQ(rig.run(1, input), Vec2<float>(0, 0));
  input.demanded.x() = kNan;
  EXPECT_EQ(rig.stage.step(input), Status::kInvalidArgument);
  EXPECT_EQ(rig.last(), Vec2<float>(0, 0));
}

TEST(OutputStage, ADemandBeyondAllNumbersAsAShare_IsNone) {
  StageSettings settings = open_settings();
  settings.gain = {1e10F, 1};
  StageRig rig(settings);
  EXPECT_EQ(rig.stage.step(alive({1e30F, 0})), Status::kInvalidArgument);
  EXPECT_EQ(rig.last(), Vec2<float>(0, 0));
}

TEST(OutputStage, NotConfigured_TellsNothing) {
  test::MemoryMotor motor;
  OutputStage stage(motor);
  EXPECT_EQ(stage.step(alive({1, 0})), Status::kInvalidArgument);
  EXPECT_EQ(stage.enable(), Status::kInvalidArgument);
  EXPECT_TRUE(motor.told.empty());
}

TEST(OutputStage, Configured_TellsZero_AndStartsAnew) {
  StageRig rig;
  rig.run(kLong, alive({1, 1}));
  (void)rig.stage.step({});
  ASSERT_EQ(rig.stage.configure(open_settings()), Status::kOk);
  EXPECT_EQ(rig.last(), Vec2<float>(0, 0));
  EXPECT_EQ(rig.stage.report().steps, 0U);
}

std::vector<StageSettings> bad_settings() {
  std::vector<StageSettings> all;
  const auto with = [&](const auto& change) {
    StageSettings settings = open_settings();
    change(settings);
    all.push_back(settings);
  };
  for (const float bad : {0.0F, -1.0F, kNan, kInfinity}) {
    with([&](StageSettings& s) { s.dt = bad; });
    with([&](StageSettings& s) { s.gain.x() = bad; });
    with([&](StageSettings& s) { s.gain.y() = bad; });
    with([&](StageSettings& s) { s.slew_rate = bad; });
    with([&](StageSettings& s) { s.speed_limit.limit = bad; });
    with([&](StageSettings& s) { s.end_stop.start = bad; });
  }
  with([](StageSettings& s) { s.slew_rate = s.dt = 1e-30F; });
  with([](StageSettings& s) { s.slew_rate = s.dt = 1e30F; });
  with([](StageSettings& s) { s.speed_limit.integral = s.dt = 1e30F; });
  for (const std::int32_t bad : {0, -1, 1000001}) {
    with([&](StageSettings& s) { s.fade = bad; });
    with([&](StageSettings& s) { s.samples.length = bad; });
    with([&](StageSettings& s) { s.commands.length = bad; });
  }
  with([](StageSettings& s) { s.samples.silent_after = -1; });
  with([](StageSettings& s) { s.commands.silent_after = -1; });
  return all;
}

TEST(OutputStage, BadSettings_AreRefused_AndChangeNothing) {
  StageRig rig;
  StageRig untouched;
  rig.run(20, alive({1, -0.5F}));
  untouched.run(20, alive({1, -0.5F}));
  for (const StageSettings& bad : bad_settings()) {
    EXPECT_EQ(validate(bad), Status::kInvalidArgument);
    EXPECT_EQ(rig.stage.configure(bad), Status::kInvalidArgument);
    EXPECT_EQ(rig.run(1, alive({1, -0.5F})), untouched.run(1, alive({1, -0.5F})));
  }
  EXPECT_EQ(rig.motor.told.size(), untouched.motor.told.size());
  EXPECT_EQ(rig.stage.report().steps, untouched.stage.report().steps);
  EXPECT_EQ(validate(StageSettings{}), Status::kOk);
}

}  // namespace
}  // namespace batuta
