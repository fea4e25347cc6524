// SPDX-License-Identifier: MIT
#pragma once
// Commands for a device under test, by the only way that there is: an output stage that changes
// nothing of what is in range.

#include "batuta/haptics/output_stage.hpp"

namespace batuta::test {

/// Settings with which step() tells the demand itself: from the first step on, whatever the stick
/// does, as soon as both kinds of freshness are there.
inline haptics::StageSettings plain_stage_settings() {
  haptics::StageSettings settings;
  settings.dt = 1;
  settings.gain = {1.0F, 1.0F};
  settings.end_stop.stiffness = 0;
  settings.speed_limit.proportional = 0;
  settings.speed_limit.integral = 0;
  settings.slew_rate = 2;
  settings.samples = {0, 1};
  settings.commands = {0, 1};
  settings.fade = 1;
  return settings;
}

class PlainForce {
 public:
  explicit PlainForce(ForceDevice& device) : stage_(device) {
    (void)stage_.configure(plain_stage_settings());
    (void)stage_.enable();
  }

  /// @returns as OutputStage::step()
  Status write(const ForceCommand& command) {
    haptics::StageInput input;
    input.time = command.time;
    input.demanded = {command.x, command.y};
    input.fresh_sample = true;
    input.fresh_command = true;
    return stage_.step(input);
  }

 private:
  haptics::OutputStage stage_;
};

}  // namespace batuta::test
