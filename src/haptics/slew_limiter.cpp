// SPDX-License-Identifier: MIT

#include "batuta/haptics/slew_limiter.hpp"

#include "batuta/core/types.hpp"

namespace batuta::haptics {

Status SlewLimiter::configure(float most) {
  if (!is_positive(most)) return Status::kInvalidArgument;
  most_ = most;
  last_ = 0;
  return Status::kOk;
}

float SlewLimiter::towards(float share) {
  const float change = share - last_;
  const float next = change > 0.0F ? last_ + most_ : last_ - most_;
  last_ = std::abs(change) <= most_ ? share : next;
  return last_;
}

}  // namespace batuta::haptics
