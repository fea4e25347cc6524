// SPDX-License-Identifier: MIT
#include "batuta/fencing/observation.hpp"

namespace batuta::fencing {

bool DelayedObservation::look(const Observation& now, std::int32_t step_us) {
  const bool due = since_us_ >= kLookUs;
  if (due) {
    apart_us_ = since_us_;
    since_us_ = 0;  // never sooner than kLookUs after the last one, so that no sight is known early
    latest_ = static_cast<std::int16_t>((latest_ + 1) % kKept);
    kept_[static_cast<std::size_t>(latest_)] = now;
    if (looks_ < kKept) ++looks_;
  }
  since_us_ += step_us;
  return due;
}

}  // namespace batuta::fencing
