// SPDX-License-Identifier: MIT
#pragma once
// The callbacks of TinyUSB's HID device class, each in one line of a firmware: pid.md has the
// lines. Nothing of TinyUSB is included: its hid_report_type_t is an enumeration with the numbers
// of HID.

#include "shared/hid_pid/device.hpp"

namespace batuta::pid::tinyusb {

/// For tud_hid_set_report_cb(). TinyUSB has taken the id off what came by SET_REPORT; what came by
/// the OUT endpoint is output, still begins with its id, and is called number 0.
/// @param type  hid_report_type_t
/// @returns as DeviceBase::receive()
inline Status set_report(DeviceBase& device, std::uint8_t id, int type, const std::uint8_t* bytes,
                         std::uint16_t size) {
  if (id != 0) return device.receive(static_cast<ReportType>(type), id, bytes, size);
  if (size == 0) return device.receive(ReportType::kOutput, 0, bytes, 0);
  return device.receive(ReportType::kOutput, bytes[0], bytes + 1, size - 1);
}

/// For tud_hid_get_report_cb(). TinyUSB puts the id before what is written.
/// @returns bytes written | 0: there is no such report; TinyUSB stalls the request
inline std::uint16_t get_report(const DeviceBase& device, std::uint8_t id, int type,
                                std::uint8_t* bytes, std::uint16_t room) {
  const auto asked = static_cast<ReportType>(type);
  if (asked == ReportType::kOutput) return 0;
  return static_cast<std::uint16_t>(asked == ReportType::kInput
                                        ? device.answer_input(id, bytes, room)
                                        : device.answer(id, bytes, room));
}

}  // namespace batuta::pid::tinyusb
