// SPDX-License-Identifier: MIT
#pragma once
// What the port uses of the Pico SDK's header of this name, by the same signatures.

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

unsigned pwm_gpio_to_slice_num(unsigned gpio);
void pwm_set_wrap(unsigned slice_num, uint16_t wrap);
void pwm_set_gpio_level(unsigned gpio, uint16_t level);
void pwm_set_enabled(unsigned slice_num, bool enabled);

#ifdef __cplusplus
}
#endif
