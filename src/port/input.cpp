// SPDX-License-Identifier: MIT
// The one place where what a device delivers is checked, whatever the port.

#include "batuta/port/input.hpp"

#include "unit_range.hpp"

namespace batuta {

Status InputDevice::read(Microseconds now, InputSample& sample) {
  InputSample fresh = sample;
  const Status status = do_read(now, fresh);
  if (status != Status::kOk) return status;
  if (!is_in_unit_range(fresh.x) || !is_in_unit_range(fresh.y)) return Status::kInvalidArgument;
  sample = fresh;
  return Status::kOk;
}

}  // namespace batuta
