/* SPDX-License-Identifier: MIT */
/* Of Zephyr's PWM what the port uses, as its documentation declares it. */
#pragma once
#include <stdint.h>

struct device;

struct pwm_dt_spec {
  const struct device* dev;
  uint32_t channel;
  uint32_t period; /* ns */
  uint16_t flags;
};

bool pwm_is_ready_dt(const struct pwm_dt_spec* spec);
int pwm_set_pulse_dt(const struct pwm_dt_spec* spec, uint32_t pulse);
