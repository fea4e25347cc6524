// SPDX-License-Identifier: MIT
#pragma once
// What the port uses of the Pico SDK's header of this name, by the same signatures.

#include <stdint.h>

#define PICO_UNIQUE_BOARD_ID_SIZE_BYTES 8

#ifdef __cplusplus
extern "C" {
#endif

void pico_get_unique_board_id_string(char* id_out, unsigned len);

#ifdef __cplusplus
}
#endif
