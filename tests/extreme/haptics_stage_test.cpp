// SPDX-License-Identifier: MIT
// The output stage with hostile numbers in every place: what it tells the device is a share,
// whatever goes in; settings that make no sense are refused and change nothing; each of its steps
// keeps its promise for all numbers.
#include "batuta/haptics/output_stage.hpp"

#include <algorithm>

#include "hostile.hpp"

namespace batuta {
using namespace haptics;
namespace {

constexpr int kDraws = 20000;

TEST(HapticsStage, HostileStageSettings_AreRefused) {
  const auto by_validate = [](const auto& settings) { return validate(settings); };
  test::expect_taken<float>(EndStopSettings{}, {false, true, true}, by_validate);
  test::expect_taken<float>(SpeedLimitSettings{}, {false, true, true}, by_validate);
  constexpr auto kLow = test::kLowest<std::int32_t>[0];
  constexpr auto kHigh = test::kHighest<std::int32_t>[0];
  for (const std::int32_t steps : {kLow, -1, 0, 1, 1000000, 1000001, kHigh}) {
    const bool counts = steps >= 0 && steps <= 1000000;
    EXPECT_EQ(validate(RampSettings{steps, 1}) == Status::kOk, counts) << steps;
    EXPECT_EQ(validate(RampSettings{0, steps}) == Status::kOk, counts && steps > 0) << steps;
    StageSettings settings;
    settings.fade = steps;
    EXPECT_EQ(validate(settings) == Status::kOk, counts && steps > 0) << steps;
  }
}

class Watched final : public ForceDevice {
 public:
  ForceCommand last;
  float largest = 0;
  Status answer = Status::kOk;

 private:
  Status do_write(const ForceCommand& command) override {
    EXPECT_TRUE(std::abs(command.x) <= 1.0F && std::abs(command.y) <= 1.0F);  // no NaN either
    largest = std::max({largest, std::abs(command.x), std::abs(command.y)});
    last = command;
    return answer;
  }
};

StageSettings short_ramps() {
  StageSettings settings;
  settings.samples = settings.commands = {1, 2};
  settings.fade = 2;
  return settings;
}

StageInput input_of(const std::vector<float>& n, std::size_t from, int draw) {
  StageInput input;
  input.time = static_cast<Microseconds>(draw) * 0x10001U;
  input.demanded = {100 * n[from], 100 * n[from + 1]};
  input.position = {n[from + 2], n[from + 3]};
  input.velocity = {10 * n[from + 4], 10 * n[from + 5]};
  input.allowed = n[from + 6] > 0.0F && n[from + 6] < 3.0F ? 1.0F : n[from + 6];
  input.fresh_sample = input.fresh_command = true;
  return input;
}

void step_hostile(OutputStage& stage, const StageSettings& settings, Watched& device, int index) {
  const std::vector<float> n = test::some_of<float>(48, index);
  for (std::size_t from = 0; from + 7 <= n.size(); ++from) {
    device.answer = n[from] == 0.0F ? Status::kUnavailable : Status::kOk;
    const StageInput input = input_of(n, from, index);
    const bool usable = is_finite(input.demanded.x() * settings.gain.x()) &&
                        is_finite(input.demanded.y() * settings.gain.y()) &&
                        is_finite(input.position) && is_finite(input.velocity) &&
                        input.allowed >= 0.0F && input.allowed <= 1.0F;
    const Status wanted = device.answer != Status::kOk ? device.answer
                          : usable                     ? Status::kOk
                                                       : Status::kInvalidArgument;
    EXPECT_EQ(stage.step(input), wanted);
    EXPECT_EQ(stage.last_command().x, device.last.x);
    EXPECT_EQ(stage.last_command().y, device.last.y);
    EXPECT_EQ(device.last.time, input.time);
  }
  EXPECT_TRUE(is_finite(stage.report().worst_excess));
}

TEST(HapticsStage, WhateverGoesIn_AShareComesOut) {
  int taken = 0;
  float largest = 0;
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<float> n = test::some_of<float>(10, -1 - i);
    StageSettings settings = short_ramps();
    settings.gain = {std::abs(n[0]), std::abs(n[1])};
    settings.end_stop = {std::abs(n[2]), std::abs(n[3]), std::abs(n[4])};
    settings.speed_limit = {std::abs(n[5]), std::abs(n[6]), std::abs(n[7])};
    settings.slew_rate = 500 * std::abs(n[8]);
    if (i % 2 == 0) settings.dt = std::abs(n[9]);
    Watched device;
    OutputStage stage(device);
    if (stage.configure(settings) != Status::kOk) continue;
    ++taken;
    ASSERT_EQ(stage.enable(), Status::kOk);
    step_hostile(stage, settings, device, i);
    largest = std::max(largest, device.largest);
    stage.stop(7);
    EXPECT_EQ(device.last.x, 0.0F);
    EXPECT_EQ(stage.step(input_of(n, 0, i)), Status::kUnavailable);
    EXPECT_EQ(device.last.y, 0.0F);
  }
  EXPECT_GT(taken, kDraws / 10);
  EXPECT_EQ(largest, 1.0F);  // and it is not for want of force
}

TEST(HapticsStage, RefusedStageSettings_LeaveTheForceAsItWas) {
  const std::vector<float> bad = {std::numeric_limits<float>::quiet_NaN(), -1.0F,
                                  std::numeric_limits<float>::infinity()};
  Watched device;
  Watched twin_device;
  OutputStage stage(device);
  OutputStage twin(twin_device);
  EXPECT_EQ(stage.step({}), Status::kInvalidArgument);
  for (OutputStage* each : {&stage, &twin}) {
    ASSERT_EQ(each->configure(short_ramps()), Status::kOk);
    ASSERT_EQ(each->enable(), Status::kOk);
  }
  const auto refuse = [&stage](const StageSettings& settings) {
    EXPECT_EQ(stage.configure(settings), Status::kInvalidArgument);
  };
  for (int i = 0; i < 300; ++i) {
    const float number = bad[static_cast<std::size_t>(i % 3)];
    StageSettings settings = short_ramps();
    float* const places[] = {&settings.dt,
                             &settings.gain.x(),
                             &settings.gain.y(),
                             &settings.end_stop.start,
                             &settings.end_stop.stiffness,
                             &settings.end_stop.damping,
                             &settings.speed_limit.limit,
                             &settings.speed_limit.proportional,
                             &settings.speed_limit.integral,
                             &settings.slew_rate};
    *places[i % 10] = number;
    refuse(settings);
    const StageInput input = input_of(test::some_of<float>(7, i), 0, i);
    EXPECT_EQ(stage.step(input), twin.step(input));
    EXPECT_TRUE(test::same_bytes(device.last, twin_device.last));
  }
}

TEST(HapticsStage, PartsOfTheStage_KeepTheirPromisesForNumbers) {
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<float> n = test::some_of<float>(12, i);
    if (!std::all_of(n.begin(), n.end(), [](float x) { return is_finite(x); })) continue;
    const ForceShare force = clipped({n[0], n[1]});
    EXPECT_LE(force.share.cwiseAbs().maxCoeff(), 1.0F);
    EXPECT_GE(force.excess, 0.0F);
    const EndStopSettings stop{std::abs(n[2]), std::abs(n[3]), std::abs(n[4])};
    if (validate(stop) == Status::kOk) {
      const float push = end_stop_push(stop, n[5], n[6]);
      EXPECT_TRUE(push >= 0.0F && push <= 1.0F);
      EXPECT_LE(std::abs(with_end_stop(force.share.x(), push, n[5])), 1.0F);
    }
    SpeedLimiter speed;
    if (speed.configure({std::abs(n[7]), std::abs(n[8]), std::abs(n[9])}, 1) == Status::kOk) {
      const float left = speed.limited(n[0], n[6]);
      EXPECT_TRUE(n[0] < 0.0F ? left >= n[0] && left <= 0.0F : left >= 0.0F && left <= n[0]);
    }
    SlewLimiter slew;
    if (slew.configure(std::abs(n[10])) != Status::kOk) continue;
    const float first = slew.towards(n[0]);
    EXPECT_EQ(slew.configure(-1.0F), Status::kInvalidArgument);
    const float then = slew.towards(n[1]);
    EXPECT_TRUE(std::min(first, n[1]) <= then && then <= std::max(first, n[1]));
  }
}

TEST(HapticsStage, LongestRamp_IsExactAtBothEnds) {
  ForceRamp ramp;
  ASSERT_EQ(ramp.configure({1000000, 1000000}), Status::kOk);
  EXPECT_EQ(ramp.configure({-1, 1}), Status::kInvalidArgument);
  for (int i = 0; i < 1000000; ++i) ramp.advance(true);
  EXPECT_EQ(ramp.share(), 1.0F);
  for (int i = 0; i < 2000000; ++i) ramp.advance(false);
  EXPECT_EQ(ramp.share(), 0.0F);
  EXPECT_EQ(ramp.silences(), 1U);
}

}  // namespace
}  // namespace batuta
