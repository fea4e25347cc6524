// SPDX-License-Identifier: MIT
// In TinyUSB's place where it is not: an image of a board's main is linked whole, and its size is
// known but for that of the stack. There is never a host. Every callback is called as far as the
// linker can tell, or it would leave out what a host could ask for.

#include "tusb.h"

namespace {

// Nobody writes it; that is known to nobody but the reader.
volatile bool somebody_asks = false;

void answer_all() {
  uint8_t buffer[CFG_TUD_HID_EP_BUFSIZE] = {};
  (void)tud_descriptor_device_cb();
  (void)tud_descriptor_configuration_cb(0);
  (void)tud_descriptor_string_cb(0, 0);
  (void)tud_hid_descriptor_report_cb(0);
  const uint16_t size = tud_hid_get_report_cb(0, 1, HID_REPORT_TYPE_INPUT, buffer, sizeof buffer);
  tud_hid_set_report_cb(0, 0, HID_REPORT_TYPE_OUTPUT, buffer, size);
  tud_suspend_cb(false);
  tud_umount_cb();
}

}  // namespace

bool tusb_rhport_init(uint8_t /*rhport*/, const tusb_rhport_init_t* /*rh_init*/) {
  return true;
}

void dcd_int_handler(uint8_t /*rhport*/) {}

void tud_task_ext(uint32_t /*timeout_ms*/, bool /*in_isr*/) {
  if (somebody_asks) answer_all();
}

bool tud_mounted(void) {
  return somebody_asks;
}

bool tud_suspended(void) {
  return somebody_asks;
}

bool tud_hid_n_ready(uint8_t /*instance*/) {
  return somebody_asks;
}

bool tud_hid_n_report(uint8_t /*instance*/, uint8_t /*report_id*/, void const* /*report*/,
                      uint16_t /*len*/) {
  return somebody_asks;
}
