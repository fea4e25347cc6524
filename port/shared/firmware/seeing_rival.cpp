// SPDX-License-Identifier: MIT

#include "shared/firmware/seeing_rival.hpp"

namespace batuta::firmware {

Status SeeingRival::configure(const Settings& settings) {
  const Status status = opponent_.configure(settings.skill, settings.seed);
  if (status != Status::kOk) return status;
  settings_ = settings;
  sequence_ = 0;
  return Status::kOk;
}

InputSample SeeingRival::play(const fencing::Duel<>& duel, fencing::Side side,
                              std::int32_t step_us) {
  const fencing::StickPlace& place = opponent_.step(fencing::observation_of(duel, side), step_us);
  InputSample sample;
  sample.time = duel.steps() * static_cast<std::uint32_t>(step_us);  // modulo 2^32, as of a clock
  sample.x = place.blade.x();
  sample.y = place.blade.y();
  sample.feet_y = place.feet;
  sample.sequence = sequence_++;
  return sample;
}

}  // namespace batuta::firmware
