// SPDX-License-Identifier: MIT
#pragma once
// The motors behind the stick.

#include "batuta/port/force.hpp"

namespace batuta::port_template {

class TemplateForce final : public ForceDevice {
 private:
  Status do_write(const ForceCommand& command) override;
};

}  // namespace batuta::port_template
