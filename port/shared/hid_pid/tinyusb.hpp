// SPDX-License-Identifier: MIT
#pragma once
// The callbacks of TinyUSB's HID device class, each in one line of a firmware: hid_pid.md has
// the lines. Nothing of TinyUSB is included: its hid_report_type_t is an enumeration with the
// numbers of HID.

#include <cstring>
#include <type_traits>

#include "shared/hid_pid/device.hpp"

namespace batuta::pid::tinyusb {

/// TinyUSB hands on the byte that the host sent, whatever it is. C may read it; C++ may not read an
/// enumeration that holds none of its numbers.
/// @tparam Type  hid_report_type_t
template <typename Type>
ReportType number_of(const Type& type) {
  std::underlying_type_t<Type> number{};
  std::memcpy(&number, &type, sizeof(number));
  return static_cast<ReportType>(number);
}

/// For tud_hid_set_report_cb(). TinyUSB has taken the id off what came by SET_REPORT, but for a
/// single byte, which is taken for a report without its id; what came by the OUT endpoint is
/// output (of no type before TinyUSB 0.16), still begins with its id, and is called number 0.
/// @param type  hid_report_type_t
/// @returns as DeviceBase::receive()
template <typename Type>
Status set_report(DeviceBase& device, std::uint8_t id, const Type& type, const std::uint8_t* bytes,
                  std::uint16_t size) {
  const ReportType said = number_of(type);
  const bool is_packet = id == 0 && (said == ReportType::kOutput || said == ReportType{0});
  return is_packet && size > 0 ? device.receive(ReportType::kOutput, bytes[0], bytes + 1, size - 1)
                               : device.receive(said, id, bytes, size);
}

/// For tud_hid_get_report_cb(). TinyUSB puts the id before what is written.
/// @returns bytes written | 0: there is no such report; TinyUSB then sends the id alone, and stalls
/// where the host named none or wants no more than one byte
template <typename Type>
std::uint16_t get_report(const DeviceBase& device, std::uint8_t id, const Type& type,
                         std::uint8_t* bytes, std::uint16_t room) {
  const ReportType asked = number_of(type);
  int size = 0;
  if (asked == ReportType::kInput) size = device.answer_input(id, bytes, room);
  if (asked == ReportType::kFeature) size = device.answer(id, bytes, room);
  return static_cast<std::uint16_t>(size);
}

}  // namespace batuta::pid::tinyusb
