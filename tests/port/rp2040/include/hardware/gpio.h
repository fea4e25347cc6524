// SPDX-License-Identifier: MIT
#pragma once
// What the port uses of the Pico SDK's header of this name, by the same signatures.

#ifdef __cplusplus
extern "C" {
#endif

typedef enum gpio_function { GPIO_FUNC_PWM = 4 } gpio_function_t;

void gpio_init(unsigned gpio);
void gpio_pull_down(unsigned gpio);
void gpio_set_function(unsigned gpio, gpio_function_t fn);
bool gpio_get(unsigned gpio);

#ifdef __cplusplus
}
#endif
