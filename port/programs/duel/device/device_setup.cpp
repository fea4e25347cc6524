// SPDX-License-Identifier: MIT

#include "programs/duel/device/device_setup.hpp"

#include <utility>

namespace batuta::host {
using namespace fencing;

std::string DeviceSetup::open(const OpenedSource& left, const OpenedSource& right,
                              const Patience& patience) {
  sources_ = {left.source.get(), right.source.get()};
  if (left.line.empty() && right.line.empty()) return {};
  if (!left.line.empty() && !right.line.empty()) {
    return right.line + ": one device at a time; the left fencer has one already";
  }
  const Side device_side = left.line.empty() ? Side::kRight : Side::kLeft;
  const OpenedSource& device = device_side == Side::kLeft ? left : right;
  OpenedSerialPort opened = SerialPort::open(device.line, device.baud);
  if (!opened.port) return opened.error;
  port_ = std::move(opened.port);
  const auto wait = [port = port_.get()](int timeout_ms) { (void)port->wait_readable(timeout_ms); };
  link_ = std::make_unique<DeviceLink>(Line{*port_, clock_, wait}, patience);
  if (device.own_stick) {
    follow_device(device_side);
  } else {
    partner_ = std::make_unique<PacedPartner>(*link_);
  }
  return {};
}

/// Free mode: the runner reads what the device reports, on both sides.
void DeviceSetup::follow_device(Side device_side) {
  std::array<Source*, 2> locals = sources_;
  locals[index_of(device_side)] = nullptr;
  for (std::size_t side = 0; side < 2; ++side) {  // Bound: 2
    const Source* const source = sources_[side];
    faces_[side] =
        std::make_unique<ReportedStick>(source->description(), source->duration(), source);
    sources_[side] = faces_[side].get();
  }
  partner_ = std::make_unique<FreePartner>(
      *link_, std::array<ReportedStick*, 2>{faces_[0].get(), faces_[1].get()}, locals);
}

}  // namespace batuta::host
