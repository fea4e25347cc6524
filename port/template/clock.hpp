// SPDX-License-Identifier: MIT
#pragma once
// Time of the platform.

#include "batuta/port/clock.hpp"

namespace batuta::port_template {

class TemplateClock final : public Clock {
 private:
  Microseconds do_now() override;
};

}  // namespace batuta::port_template
