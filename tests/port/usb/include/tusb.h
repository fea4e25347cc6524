// SPDX-License-Identifier: MIT
#pragma once
// What the firmware uses of TinyUSB 0.18 and later, and nothing else of it: the same names and
// signatures, so that whatever compiles with this compiles with that. For tests, and for images
// that are linked where TinyUSB is not.

#include <stddef.h>
#include <stdint.h>

// Values of options that tusb_config.h names.
#define OPT_MODE_DEVICE 0x01
#define OPT_MODE_FULL_SPEED 0x10
#define OPT_OS_NONE 1

#include "shared/usb_stick/tusb_config.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
  HID_REPORT_TYPE_INVALID = 0,
  HID_REPORT_TYPE_INPUT,
  HID_REPORT_TYPE_OUTPUT,
  HID_REPORT_TYPE_FEATURE
} hid_report_type_t;

typedef enum {
  TUSB_ROLE_INVALID = 0,
  TUSB_ROLE_DEVICE = 1,
  TUSB_ROLE_HOST = 2,
} tusb_role_t;

typedef enum {
  TUSB_SPEED_FULL = 0,
  TUSB_SPEED_LOW = 1,
  TUSB_SPEED_HIGH = 2,
} tusb_speed_t;

typedef struct {
  tusb_role_t role;
  tusb_speed_t speed;
} tusb_rhport_init_t;

// What the firmware calls.
bool tusb_rhport_init(uint8_t rhport, const tusb_rhport_init_t* rh_init);
#define tusb_init() tusb_rhport_init(0, NULL)
void dcd_int_handler(uint8_t rhport);
#define tud_int_handler dcd_int_handler
void tud_task_ext(uint32_t timeout_ms, bool in_isr);
static inline void tud_task(void) {
  tud_task_ext(UINT32_MAX, false);
}
bool tud_mounted(void);
bool tud_suspended(void);
bool tud_hid_n_ready(uint8_t instance);
static inline bool tud_hid_ready(void) {
  return tud_hid_n_ready(0);
}
bool tud_hid_n_report(uint8_t instance, uint8_t report_id, void const* report, uint16_t len);
static inline bool tud_hid_report(uint8_t report_id, void const* report, uint16_t len) {
  return tud_hid_n_report(0, report_id, report, len);
}

// What the firmware defines.
uint8_t const* tud_descriptor_device_cb(void);
uint8_t const* tud_descriptor_configuration_cb(uint8_t index);
uint16_t const* tud_descriptor_string_cb(uint8_t index, uint16_t langid);
uint8_t const* tud_hid_descriptor_report_cb(uint8_t instance);
uint16_t tud_hid_get_report_cb(uint8_t instance, uint8_t report_id, hid_report_type_t report_type,
                               uint8_t* buffer, uint16_t reqlen);
void tud_hid_set_report_cb(uint8_t instance, uint8_t report_id, hid_report_type_t report_type,
                           uint8_t const* buffer, uint16_t bufsize);
void tud_umount_cb(void);
void tud_suspend_cb(bool remote_wakeup_en);
uint32_t tusb_time_millis_api(void);

#ifdef __cplusplus
}
#endif
