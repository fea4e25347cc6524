// SPDX-License-Identifier: MIT
#pragma once
// From two sources to a bout with a device, where one of them names a serial line.

#include <memory>

#include "platforms/host/clock.hpp"
#include "programs/duel/device/device_partner.hpp"
#include "programs/serial/serial_port.hpp"

namespace batuta::host {

class DeviceSetup {
 public:
  /// Takes the sources, which must outlive this, and opens the line, if there is one.
  /// @returns empty | why not, in one line
  std::string open(const OpenedSource& left, const OpenedSource& right,
                   const Patience& patience = {});

  /// What the runner is to read.
  Source& source(fencing::Side side) { return *sources_[index_of(side)]; }
  /// Null: no device.
  DevicePartner* partner() { return partner_.get(); }

 private:
  void follow_device(fencing::Side device_side);

  HostClock clock_;
  std::unique_ptr<SerialPort> port_;
  std::unique_ptr<DeviceLink> link_;
  std::array<Source*, 2> sources_{};
  std::array<std::unique_ptr<ReportedStick>, 2> faces_;
  std::unique_ptr<DevicePartner> partner_;
};

}  // namespace batuta::host
