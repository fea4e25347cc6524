// SPDX-License-Identifier: MIT
// The one place where a force is checked before it reaches a hand, whatever the port.

#include "batuta/port/force.hpp"

#include "unit_range.hpp"

namespace batuta {

Status ForceDevice::write(const ForceCommand& command) {
  if (is_in_unit_range(command.x) && is_in_unit_range(command.y)) return do_write(command);
  // A nonsensical force must not leave the last one on the hand: zero, even if the device then
  // fails as well.
  const Status zeroed = do_write({command.time, 0.0F, 0.0F});
  return zeroed == Status::kUnavailable ? zeroed : Status::kInvalidArgument;
}

}  // namespace batuta
