/* SPDX-License-Identifier: MIT */
#pragma once
/* TinyUSB's settings for the stick: one HID interface on the first port, full speed, no operating
 * system. The build gives CFG_TUSB_MCU. C: TinyUSB's own sources read it. */

#ifndef CFG_TUSB_MCU
#error "CFG_TUSB_MCU must be defined: OPT_MCU_STM32F4, OPT_MCU_RP2040"
#endif

#define CFG_TUSB_RHPORT0_MODE (OPT_MODE_DEVICE | OPT_MODE_FULL_SPEED)
#ifndef CFG_TUSB_OS /* the Pico SDK gives its own */
#define CFG_TUSB_OS OPT_OS_NONE
#endif
#ifndef CFG_TUSB_DEBUG
#define CFG_TUSB_DEBUG 0
#endif

#define CFG_TUD_ENABLED 1
#define CFG_TUD_ENDPOINT0_SIZE 64

#define CFG_TUD_HID 1
#define CFG_TUD_HID_EP_BUFSIZE 64 /* of a packet: the longest report has 18 with its number */
#define CFG_TUD_CDC 0
#define CFG_TUD_MSC 0
#define CFG_TUD_MIDI 0
#define CFG_TUD_VENDOR 0
