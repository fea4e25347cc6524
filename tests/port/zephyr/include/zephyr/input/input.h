/* SPDX-License-Identifier: MIT */
/* Of Zephyr's input subsystem what the port uses; the codes are those of input-event-codes.h, which are Linux's. */
#pragma once
#include <stdint.h>

struct device;

struct input_event {
  const struct device* dev;
  uint8_t sync;
  uint8_t type;
  uint16_t code;
  int32_t value;
};

#define INPUT_EV_KEY 0x01
#define INPUT_EV_REL 0x02
#define INPUT_EV_ABS 0x03
#define INPUT_EV_MSC 0x04

#define INPUT_ABS_X 0x00
#define INPUT_ABS_Y 0x01
#define INPUT_ABS_Z 0x02
#define INPUT_ABS_RX 0x03
#define INPUT_ABS_RY 0x04
#define INPUT_REL_X 0x00
#define INPUT_REL_Y 0x01
#define INPUT_REL_RX 0x03
#define INPUT_REL_RY 0x04

#define INPUT_BTN_0 0x100
#define INPUT_BTN_9 0x109
#define INPUT_BTN_LEFT 0x110
#define INPUT_BTN_SOUTH 0x130
#define INPUT_BTN_THUMBR 0x13e
