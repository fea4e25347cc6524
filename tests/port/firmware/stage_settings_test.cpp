// SPDX-License-Identifier: MIT
#include "shared/firmware/stage_settings.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace batuta::firmware {
using namespace haptics;
namespace {

TEST(StageSettings, OfForceSettings_AreTakenByAStage) {
  for (const float dt : {1e-6F, 0.001F, 0.04F}) {
    for (const float full_scale : {1e-6F, 100.0F, 1e6F}) {
      const ForceSettings settings{full_scale, {7, 8}, {9, 0.5F, 0.25F}};
      const StageSettings stage = stage_settings(settings, dt);
      EXPECT_EQ(validate(stage), Status::kOk);
      EXPECT_EQ(stage.gain, settings.gain());
      EXPECT_EQ(stage.samples.silent_after, 7);
      EXPECT_EQ(stage.commands.length, 8);
      EXPECT_EQ(stage.fade, 8);
      EXPECT_EQ(stage.speed_limit.limit, 9);
      EXPECT_EQ(stage.end_stop.stiffness, 0);
    }
  }
}

// A bout that is started has a stage: what the forces' own check takes, the stage takes in steps of
// any length that a duel has.
TEST(StageSettings, OfAnyForceSettingsThatAreValid_AreValid) {
  constexpr float kMost = std::numeric_limits<float>::max();
  constexpr float kLeast = std::numeric_limits<float>::min();
  int valid = 0;
  for (const float scale : {0.0F, kLeast, 1.0F, 1e30F, kMost}) {
    for (const float limit : {0.0F, kLeast, 1.0F, kMost}) {
      for (const float gain : {0.0F, kLeast, 1.0F, kMost}) {
        for (const std::int32_t length : {0, 1, 1000000, 1000001}) {
          const ForceSettings settings{scale, {length, length}, {limit, gain, gain}};
          if (validate(settings) != Status::kOk) continue;
          ++valid;
          for (const float dt : {1e-4F, 1e-3F, 0.02F}) {
            EXPECT_EQ(validate(stage_settings(settings, dt)), Status::kOk) << scale << " " << dt;
          }
        }
      }
    }
  }
  EXPECT_GT(valid, 50);
}

/// Else a blow of one step would be weaker on the motor than it is told.
TEST(StageSettings, ABlow_IsWholeInOneStep) {
  for (const float dt : {1e-6F, 0.001F, 0.003F, 0.04F}) {
    const StageSettings stage = stage_settings({}, dt);
    EXPECT_GE(stage.slew_rate * stage.dt, 2.0F * (1 - std::numeric_limits<float>::epsilon()));
  }
  EXPECT_EQ(stage_settings({}, 0.001F).slew_rate * 0.001F, 2.0F);
}

}  // namespace
}  // namespace batuta::firmware
