// SPDX-License-Identifier: MIT
// In the Pico SDK's place where it is not: the image of the board's main is linked whole, and its
// size is known but for that of the SDK. Nothing is converted, nothing moves.

#include "hardware/adc.h"
#include "hardware/gpio.h"
#include "hardware/pwm.h"
#include "hardware/watchdog.h"
#include "pico/time.h"
#include "pico/unique_id.h"

namespace {

// Nobody writes them; that is known to nobody but the reader.
volatile uint32_t time_us = 0;
volatile uint16_t conversion = 0;

}  // namespace

void adc_init(void) {}
void adc_gpio_init(unsigned /*gpio*/) {}
void adc_select_input(unsigned /*input*/) {}
uint16_t adc_read(void) {
  return conversion;
}

void gpio_init(unsigned /*gpio*/) {}
void gpio_pull_down(unsigned /*gpio*/) {}
void gpio_set_function(unsigned /*gpio*/, gpio_function_t /*fn*/) {}
bool gpio_get(unsigned /*gpio*/) {
  return conversion != 0;
}

unsigned pwm_gpio_to_slice_num(unsigned gpio) {
  return gpio / 2U % 8U;
}
void pwm_set_wrap(unsigned /*slice_num*/, uint16_t /*wrap*/) {}
void pwm_set_gpio_level(unsigned /*gpio*/, uint16_t /*level*/) {}
void pwm_set_enabled(unsigned /*slice_num*/, bool /*enabled*/) {}

void watchdog_enable(uint32_t /*delay_ms*/, bool /*pause_on_debug*/) {}
void watchdog_update(void) {}

uint32_t time_us_32(void) {
  return time_us;
}
bool add_repeating_timer_us(int64_t delay_us, repeating_timer_callback_t callback, void* user_data,
                            repeating_timer_t* out) {
  *out = {delay_us, user_data};
  return callback(out);  // once: what it calls is linked
}

void pico_get_unique_board_id_string(char* id_out, unsigned /*len*/) {
  id_out[0] = '\0';
}
