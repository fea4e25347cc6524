// SPDX-License-Identifier: MIT

#include "shared/firmware/stage_settings.hpp"

namespace batuta::firmware {
using namespace haptics;

StageSettings stage_settings(const ForceSettings& settings, float dt) {
  constexpr float kFromEndToEnd = 2;  // shares
  StageSettings stage;
  stage.dt = dt;
  stage.gain = settings.gain();
  stage.end_stop.stiffness = 0;
  stage.speed_limit = settings.speed_limit;
  stage.slew_rate = kFromEndToEnd / dt;
  stage.samples = settings.ramp;
  stage.commands = settings.ramp;
  stage.fade = settings.ramp.length;
  return stage;
}

}  // namespace batuta::firmware
