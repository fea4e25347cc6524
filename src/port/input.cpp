// SPDX-License-Identifier: MIT
// The one place where what a device delivers is checked, whatever the port.

#include "batuta/port/input.hpp"

namespace batuta {
namespace {

/// False for NaN: every comparison with it is.
constexpr bool is_in_unit_range(float x) {
  return x >= -1.0F && x <= 1.0F;
}

}  // namespace

Status InputDevice::read(Microseconds now, InputSample& sample) {
  InputSample fresh = sample;
  const Status status = do_read(now, fresh);
  if (status != Status::kOk) return status;
  if (!is_in_unit_range(fresh.x) || !is_in_unit_range(fresh.y)) return Status::kInvalidArgument;
  sample = fresh;
  return Status::kOk;
}

}  // namespace batuta
