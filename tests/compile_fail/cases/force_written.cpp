// SPDX-License-Identifier: MIT
// A program that tells a motor a force itself, past the output stage.
#include "batuta/haptics/output_stage.hpp"

class Motor final : public batuta::ForceDevice {
  batuta::Status do_write(const batuta::ForceCommand&) override { return batuta::Status::kOk; }
};

batuta::Status push(Motor& motor, batuta::haptics::OutputStage& stage);
batuta::Status push(Motor& motor, batuta::haptics::OutputStage& stage) {
  const batuta::ForceCommand command{0, 1.0F, 0.0F};
#if defined(PERMIT_MADE)
  return motor.write(command, batuta::ForcePermit());
#elif defined(PERMIT_BRACED)
  return motor.write(command, {});
#elif defined(PAST_THE_BASE)
  return motor.do_write(command);
#elif defined(AS_THE_BASE)
  return static_cast<batuta::ForceDevice&>(motor).do_write(command);
#elif defined(STAGE_COPIED)
  batuta::haptics::OutputStage second = stage;
  return second.step({});
#else
  (void)motor.off(command.time);
  return stage.step({});
#endif
}
