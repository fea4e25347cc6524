// SPDX-License-Identifier: MIT
// TinyUSB's callbacks have no argument to tell one stick from another: there is one, here.

#include "shared/usb_stick/tinyusb_device.hpp"

#include "shared/hid_pid/tinyusb.hpp"
#include "tusb.h"

namespace batuta::usb {
namespace {

UsbStick* connected = nullptr;
StringDescriptor told_string;  // TinyUSB sends it from here

Host host_now() {
  if (!tud_mounted()) return Host::kAway;
  return tud_suspended() ? Host::kAsleep : Host::kAwake;
}

}  // namespace

void connect(UsbStick* stick) {
  connected = stick;
}

void run(UsbStick& stick, const InputSample* fresh, Microseconds now) {
  tud_task();
  stick.tick(fresh, host_now(), now);
  if (!tud_hid_ready()) return;
  const InputReport report = stick.next_report();
  (void)tud_hid_report(report.id, report.bytes.data(), report.size);  // it was ready
}

}  // namespace batuta::usb

using batuta::usb::connected;

std::uint8_t const* tud_descriptor_device_cb(void) {
  return batuta::usb::kDeviceDescriptor.data();
}

std::uint8_t const* tud_descriptor_configuration_cb(std::uint8_t index) {
  return index == 0 ? batuta::usb::kConfiguration.data() : nullptr;  // TinyUSB stalls
}

std::uint16_t const* tud_descriptor_string_cb(std::uint8_t index, std::uint16_t /*language*/) {
  using namespace batuta::usb;
  const Identity identity = connected != nullptr ? connected->identity() : Identity();
  return write_string(identity, index, told_string) ? told_string.data() : nullptr;
}

std::uint8_t const* tud_hid_descriptor_report_cb(std::uint8_t /*instance*/) {
  return batuta::usb::PidDevice::report_descriptor().data();
}

std::uint16_t tud_hid_get_report_cb(std::uint8_t /*instance*/, std::uint8_t report_id,
                                    hid_report_type_t report_type, std::uint8_t* buffer,
                                    std::uint16_t reqlen) {
  if (connected == nullptr) return 0;
  return batuta::pid::tinyusb::get_report(connected->effects(), report_id, report_type, buffer,
                                          reqlen);
}

void tud_hid_set_report_cb(std::uint8_t /*instance*/, std::uint8_t report_id,
                           hid_report_type_t report_type, std::uint8_t const* buffer,
                           std::uint16_t bufsize) {
  if (connected == nullptr) return;
  // What is refused is counted: effects().counters().
  (void)batuta::pid::tinyusb::set_report(connected->effects(), report_id, report_type, buffer,
                                         bufsize);
}

void tud_umount_cb(void) {
  if (connected != nullptr) connected->leave();
}

void tud_suspend_cb(bool /*remote_wakeup_en*/) {
  if (connected != nullptr) connected->sleep();
}
