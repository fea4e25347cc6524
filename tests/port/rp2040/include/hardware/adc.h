// SPDX-License-Identifier: MIT
#pragma once
// What the port uses of the Pico SDK's header of this name, by the same signatures.

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void adc_init(void);
void adc_gpio_init(unsigned gpio);
void adc_select_input(unsigned input);
uint16_t adc_read(void);

#ifdef __cplusplus
}
#endif
