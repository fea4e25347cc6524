// SPDX-License-Identifier: MIT
// The one place where what a device delivers is checked, whatever the port.

#include "batuta/port/input.hpp"

#include <initializer_list>

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
  for (const float at : {fresh.x, fresh.y, fresh.feet_x, fresh.feet_y}) {  // Bound: 4
    if (!is_in_unit_range(at)) return Status::kInvalidArgument;
  }
  sample = fresh;
  return Status::kOk;
}

}  // namespace batuta
