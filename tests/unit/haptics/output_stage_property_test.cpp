// SPDX-License-Identifier: MIT
// What an output stage promises whatever goes in: any settings that it takes, any demand, any
// motion of the stick, any pattern of silences.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "stage_rig.hpp"

namespace batuta {
using namespace haptics;
namespace {

using test::alive;
using test::StageRig;

constexpr int kSteps = 120;
/// A product of two shares rounds once, each of their sums once more.
constexpr float kRounding = 4 * std::numeric_limits<float>::epsilon();

float number(float most) {
  return static_cast<float>(*rc::gen::inRange(-1000, 1001)) * most / 1000;
}
float positive(float most) {
  return static_cast<float>(*rc::gen::inRange(1, 1001)) * most / 1000;
}
RampSettings any_ramp() {
  return {*rc::gen::inRange(0, 20), *rc::gen::inRange(1, 30)};
}

StageSettings any_settings() {
  StageSettings settings;
  settings.dt = positive(0.002F);
  settings.gain = {positive(2), positive(2)};
  settings.end_stop = {positive(1), std::abs(number(30)), std::abs(number(1))};
  settings.speed_limit = {positive(20), std::abs(number(1)), std::abs(number(100))};
  settings.slew_rate = positive(1000);
  settings.samples = any_ramp();
  settings.commands = any_ramp();
  settings.fade = *rc::gen::inRange(1, 60);
  return settings;
}

/// Now and then a number that is none, or the largest one.
float any_number(float most) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  switch (*rc::gen::inRange(0, 40)) {
    case 0:
      return std::numeric_limits<float>::quiet_NaN();
    case 1:
      return kInfinity;
    case 2:
      return -kLargest;
    default:
      return number(most);
  }
}

/// All, a part, now and then what is no share.
float any_allowed() {
  const int which = *rc::gen::inRange(0, 10);
  if (which < 5) return 1;
  return which < 9 ? std::abs(number(1)) : any_number(2);
}

StageInput any_input() {
  StageInput input;
  input.demanded = {any_number(3), any_number(3)};
  input.position = {any_number(1.2F), any_number(1.2F)};
  input.velocity = {any_number(40), any_number(40)};
  input.allowed = any_allowed();
  input.clipped = *rc::gen::inRange(0, 2) > 0;
  input.excess = std::abs(any_number(3));
  input.fresh_sample = *rc::gen::inRange(0, 3) > 0;
  input.fresh_command = *rc::gen::inRange(0, 3) > 0;
  return input;
}

float largest(const Vec2<float>& v) {
  return std::fmax(std::abs(v.x()), std::abs(v.y()));
}

/// As output_stage.hpp has it: numbers, the demand as a share of the range too.
bool is_usable(const StageInput& input, const StageSettings& settings) {
  return is_finite(Vec2<float>(input.demanded.cwiseProduct(settings.gain))) &&
         is_finite(input.position) && is_finite(input.velocity) && input.allowed >= 0 &&
         input.allowed <= 1 && is_finite(input.excess);
}

/// The most that a share may change in a step: by the slew limit, and by the ramps, of which the
/// least decides: it changes no faster than the fastest of them.
/// @param leap  of what the demander allows
float fastest(const StageSettings& settings, float leap) {
  const auto shortest =
      std::min({settings.samples.length, settings.commands.length, settings.fade});
  const float ramps = std::fmax(1.0F / static_cast<float>(shortest), leap);
  return settings.slew_rate * settings.dt + ramps + kRounding;
}

RC_GTEST_PROP(OutputStage, WhateverGoesIn_IsInRange_AndNoFasterThanAllowed, ()) {
  const StageSettings settings = any_settings();
  StageRig rig(settings);
  Vec2<float> last = rig.last();
  float allowed = 1;
  for (int i = 0; i < kSteps; ++i) {
    if (*rc::gen::inRange(0, 20) == 0) rig.stage.disable();
    if (*rc::gen::inRange(0, 10) == 0) (void)rig.stage.enable();
    const StageInput input = any_input();
    const bool usable = is_usable(input, settings);
    RC_ASSERT(rig.stage.step(input) == (usable ? Status::kOk : Status::kInvalidArgument));
    const float before = std::exchange(allowed, usable ? input.allowed : allowed);
    const Vec2<float> told = rig.last();
    RC_ASSERT(is_finite(told));
    RC_ASSERT(largest(told) <= allowed);
    RC_ASSERT(largest(told - last) <= fastest(settings, std::abs(allowed - before)));
    last = told;
  }
  RC_ASSERT(rig.motor.told.size() == kSteps + 1U);
}

/// Once all ramps are up, the slew limit alone decides.
RC_GTEST_PROP(OutputStage, InHealth_TheSlewLimitIsExact, ()) {
  const StageSettings settings = any_settings();
  StageRig rig(settings);
  for (int i = 0; i < 60; ++i) rig.run(1, alive({number(2), number(2)}));
  Vec2<float> last = rig.last();
  for (int i = 0; i < kSteps; ++i) {
    const Vec2<float> told = rig.run(1, alive({number(2), number(2)}));
    RC_ASSERT(largest(told - last) <= settings.slew_rate * settings.dt + kRounding);
    last = told;
  }
}

RC_GTEST_PROP(OutputStage, Silence_TakesAConstantForceWithoutEverAddingToIt, ()) {
  StageSettings settings = any_settings();
  settings.slew_rate = 2 / settings.dt;
  StageRig rig(settings);
  StageInput input = alive({number(2), number(2)});
  input.position = {number(1.2F), number(1.2F)};
  rig.run(60, input);  // all ramps are up
  const bool stick = *rc::gen::arbitrary<bool>();
  (stick ? input.fresh_sample : input.fresh_command) = false;
  const RampSettings& ramp = stick ? settings.samples : settings.commands;
  Vec2<float> last = rig.last();
  for (int i = 1; i <= ramp.silent_after + ramp.length; ++i) {
    const Vec2<float> told = rig.run(1, input);
    RC_ASSERT(std::abs(told.x()) <= std::abs(last.x()) && std::abs(told.y()) <= std::abs(last.y()));
    RC_ASSERT(i > ramp.silent_after || told == last);
    last = told;
  }
  RC_ASSERT(last == Vec2<float>(0, 0));
}

RC_GTEST_PROP(OutputStage, FadingIn_IsBoundedByItsSteps, ()) {
  const StageSettings settings = any_settings();
  StageRig rig(settings);
  rig.stage.disable();
  for (int i = 0; i < 60; ++i) (void)rig.stage.step(any_input());
  RC_ASSERT(rig.last() == Vec2<float>(0, 0));
  (void)rig.stage.enable();
  for (int i = 1; i <= settings.fade; ++i) {
    (void)rig.stage.step(any_input());
    RC_ASSERT(largest(rig.last()) <= static_cast<float>(i) / static_cast<float>(settings.fade));
  }
}

RC_GTEST_PROP(OutputStage, Stopped_NothingBringsTheForceBack, ()) {
  StageRig rig(any_settings());
  for (int i = 0; i < 60; ++i) (void)rig.stage.step(any_input());
  rig.stage.stop(0);
  for (int i = 0; i < 60; ++i) {
    (void)rig.stage.enable();
    RC_ASSERT(rig.stage.step(any_input()) == Status::kUnavailable);
    RC_ASSERT(rig.last() == Vec2<float>(0, 0));
  }
}

/// The same steps, the same bits: nothing is remembered but what configure() resets.
RC_GTEST_PROP(OutputStage, ConfiguredAgain_IsLikeANewOne, ()) {
  const StageSettings settings = any_settings();
  StageRig used(any_settings());
  for (int i = 0; i < 60; ++i) (void)used.stage.step(any_input());
  (void)used.stage.configure(settings);
  (void)used.stage.enable();
  StageRig fresh(settings);
  for (int i = 0; i < 60; ++i) {
    const StageInput input = any_input();
    (void)used.stage.step(input);
    (void)fresh.stage.step(input);
    RC_ASSERT(used.last() == fresh.last());
    RC_ASSERT(used.stage.last_command().own == fresh.stage.last_command().own);
  }
}

/// The least of all ramps, not their product, and whatever else there is of the demand stays.
RC_GTEST_PROP(OutputStage, WhatIsAllowed_IsOneRampAmongOthers, ()) {
  const StageSettings settings = any_settings();
  StageRig all(settings);
  StageRig part(settings);
  float allowed = 1;
  for (int i = 0; i < kSteps; ++i) {
    StageInput input = any_input();
    if (is_usable(input, settings)) allowed = input.allowed;
    (void)part.stage.step(input);
    input.allowed = input.allowed >= 0 && input.allowed <= 1 ? 1 : input.allowed;
    (void)all.stage.step(input);
    const ForceCommand& told = part.stage.last_command();
    RC_ASSERT(told.own == std::fmin(all.stage.last_command().own, allowed));
    if (told.own == all.stage.last_command().own) RC_ASSERT(part.last() == all.last());
  }
}

}  // namespace
}  // namespace batuta
