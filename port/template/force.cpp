// SPDX-License-Identifier: MIT
#include "template/force.hpp"

namespace batuta::port_template {

// Must: bring the force to `command` as soon as the actuator can, the latest command winning over
// those before it; let the force fall to zero by itself where commands stop coming (the longest
// pause is the port's to state). Must not: wait until the actuator has taken the command, or queue
// commands. Returns kOk, or kUnavailable where the device is gone. Stay private: nobody but the
// output stage gives commands, and they are finite and within -1 ... 1, so that only what the
// actuator needs beyond that is checked here. Where an emergency stop comes from an interrupt,
// this may be interrupted by itself.
Status TemplateForce::do_write(const ForceCommand& /*command*/) {
  return Status::kUnavailable;
}

}  // namespace batuta::port_template
