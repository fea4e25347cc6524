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
