// SPDX-License-Identifier: MIT
#pragma once
// The host's clock.

#include "batuta/port/clock.hpp"

namespace batuta {

/// Monotonic time since an unknown start.
class HostClock final : public Clock {
 private:
  Microseconds do_now() override;
};

}  // namespace batuta
