// SPDX-License-Identifier: MIT
#pragma once
// What pid.md's example needs of TinyUSB, by the signatures that its documentation gives: the
// callbacks that the stack calls, and what the firmware calls, which a test keeps. For tests only.

#include <cstdint>

extern "C" {
typedef enum {
  HID_REPORT_TYPE_INVALID = 0,
  HID_REPORT_TYPE_INPUT,
  HID_REPORT_TYPE_OUTPUT,
  HID_REPORT_TYPE_FEATURE
} hid_report_type_t;

std::uint8_t const* tud_hid_descriptor_report_cb(std::uint8_t instance);
std::uint16_t tud_hid_get_report_cb(std::uint8_t instance, std::uint8_t report_id,
                                    hid_report_type_t report_type, std::uint8_t* buffer,
                                    std::uint16_t reqlen);
void tud_hid_set_report_cb(std::uint8_t instance, std::uint8_t report_id,
                           hid_report_type_t report_type, std::uint8_t const* buffer,
                           std::uint16_t bufsize);
void tud_umount_cb(void);
void tud_suspend_cb(bool remote_wakeup_en);
}

bool tud_hid_ready();
bool tud_hid_report(std::uint8_t report_id, void const* report, std::uint16_t len);
