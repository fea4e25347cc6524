// SPDX-License-Identifier: MIT

#include "shared/firmware/stepped_bout.hpp"

namespace batuta::firmware {
using namespace fencing;

Status SteppedBout::start(const BoutSettings& settings) {
  DuelSettings<> duel = duel_settings();
  duel.step_us = settings.step_us;
  if (validate(settings.force) != Status::kOk) return Status::kInvalidArgument;
  const Status status = duel_.configure(duel, first_fencer<float>(), second_fencer<float>());
  if (status != Status::kOk) return status;
  fresh_ = {};
  believed_ = {};
  alive_ = {};
  return forces_.configure(settings.force);
}

Status SteppedBout::step(const InputSample* left, const InputSample* right) {
  const Status status = duel_.step(left, right);
  if (status != Status::kOk) return status;
  take(Side::kLeft, left);
  take(Side::kRight, right);
  forces_.advance(duel_, alive_);
  return Status::kOk;
}

void SteppedBout::take(Side side, const InputSample* sample) {
  fresh_[index_of(side)] = sample != nullptr;
  if (sample != nullptr) samples_[index_of(side)] = *sample;
  const std::uint32_t believed = duel_.stick(side).report().used;
  alive_[index_of(side)] = believed != believed_[index_of(side)];
  believed_[index_of(side)] = believed;
}

}  // namespace batuta::firmware
