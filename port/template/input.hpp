// SPDX-License-Identifier: MIT
#pragma once
// The stick.

#include "batuta/port/input.hpp"

namespace batuta::port_template {

class TemplateInput final : public InputDevice {
 private:
  Status do_read(Microseconds now, InputSample& sample) override;
};

}  // namespace batuta::port_template
