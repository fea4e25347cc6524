// SPDX-License-Identifier: MIT
// The one place where a force is checked before it reaches a hand, whatever the port.

#include "batuta/port/force.hpp"

namespace batuta {
namespace {

/// False for NaN: every comparison with it is.
bool is_share(float x) {
  return x >= -1.0F && x <= 1.0F;
}

}  // namespace

Status ForceDevice::write(const ForceCommand& command) {
  if (is_share(command.x) && is_share(command.y)) return do_write(command);
  // A nonsensical force must not leave the last one on the hand: zero, even if the device then
  // fails as well.
  const Status zeroed = do_write({command.time, 0.0F, 0.0F});
  return zeroed == Status::kUnavailable ? zeroed : Status::kInvalidArgument;
}

}  // namespace batuta
