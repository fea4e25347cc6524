// SPDX-License-Identifier: MIT
#pragma once
// An output stage with a motor of memory.

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

#include "batuta/haptics/output_stage.hpp"

namespace batuta::test {

class MemoryMotor final : public ForceDevice {
 public:
  Status status = Status::kOk;
  std::vector<ForceCommand> told;
  std::function<void()> during_write;  ///< once, before the command arrives: an interrupt

 private:
  Status do_write(const ForceCommand& command) override {
    if (during_write) std::exchange(during_write, nullptr)();
    if (status == Status::kOk) told.push_back(command);
    return status;
  }
};

/// A sign of life, and a demand in shares of the range where the gain is 1.
inline haptics::StageInput alive(const Vec2<float>& demanded) {
  haptics::StageInput input;
  input.demanded = demanded;
  input.fresh_sample = true;
  input.fresh_command = true;
  return input;
}

/// Nothing but the ramps and the slew limit act on a demand within the range.
inline haptics::StageSettings open_settings() {
  haptics::StageSettings settings;
  settings.gain = {1, 1};
  settings.end_stop.stiffness = 0;
  settings.slew_rate = 2000;
  settings.samples = {10, 20};
  settings.commands = {5, 25};
  settings.fade = 40;
  return settings;
}

struct StageRig {
  MemoryMotor motor;
  haptics::OutputStage stage{motor};

  explicit StageRig(const haptics::StageSettings& settings = open_settings()) {
    EXPECT_EQ(stage.configure(settings), Status::kOk);
    EXPECT_EQ(stage.enable(), Status::kOk);
  }
  Vec2<float> last() const { return {motor.told.back().x, motor.told.back().y}; }
  /// So many steps with this input. @returns what the motor was told last
  Vec2<float> run(int steps, const haptics::StageInput& input) {
    for (int i = 0; i < steps; ++i) EXPECT_EQ(stage.step(input), Status::kOk);
    return last();
  }
};

}  // namespace batuta::test
