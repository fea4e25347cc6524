// SPDX-License-Identifier: MIT

#include "batuta/haptics/force_ramp.hpp"

namespace batuta::haptics {
namespace {

constexpr std::int32_t kLongest = 1000000;  // steps; exact in float

}  // namespace

Status validate(const RampSettings& settings) {
  const bool good = settings.silent_after >= 0 && settings.silent_after <= kLongest &&
                    settings.length > 0 && settings.length <= kLongest;
  return good ? Status::kOk : Status::kInvalidArgument;
}

Status ForceRamp::configure(const RampSettings& settings) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  *this = {};
  settings_ = settings;
  return Status::kOk;
}

void ForceRamp::advance(bool alive) {
  if (alive) {
    quiet_ = 0;
    silent_ = false;
  } else if (!silent_ && ++quiet_ > settings_.silent_after) {
    silent_ = true;
    ++silences_;
  }
  if (silent_ && level_ > 0) --level_;
  if (!silent_ && level_ < settings_.length) ++level_;
}

float ForceRamp::share() const {
  return static_cast<float>(level_) / static_cast<float>(settings_.length);
}

}  // namespace batuta::haptics
