// SPDX-License-Identifier: MIT
#pragma once
// What the port uses of the Pico SDK's header of this name, by the same signatures.

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct repeating_timer {
  int64_t delay_us;
  void* user_data;
} repeating_timer_t;
typedef bool (*repeating_timer_callback_t)(repeating_timer_t* rt);

uint32_t time_us_32(void);
bool add_repeating_timer_us(int64_t delay_us, repeating_timer_callback_t callback, void* user_data,
                            repeating_timer_t* out);

#ifdef __cplusplus
}
#endif
