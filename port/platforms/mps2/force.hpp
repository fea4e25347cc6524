// SPDX-License-Identifier: MIT
#pragma once
// The board has no actuator: the force is a pair of words that a debugger, a test or a host can
// watch, and two LEDs that light while a part of it is not zero.

#include "batuta/port/force.hpp"

namespace batuta::mps2 {

class Force final : public ForceDevice {
 private:
  Status do_write(const ForceCommand& command) override;
};

/// What the actuator would be told now, in units of 2^-15 of its range, -32768 ... 32768.
struct ForceLevel {
  std::int32_t x;
  std::int32_t y;
};
ForceLevel force_level();

}  // namespace batuta::mps2
