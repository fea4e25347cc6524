// SPDX-License-Identifier: MIT
#pragma once
// What the port uses of the Pico SDK's header of this name, by the same signatures.

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void watchdog_enable(uint32_t delay_ms, bool pause_on_debug);
void watchdog_update(void);

#ifdef __cplusplus
}
#endif
