// SPDX-License-Identifier: MIT

#include "fake_pico.hpp"

#include "hardware/adc.h"
#include "hardware/gpio.h"
#include "hardware/pwm.h"

namespace batuta::rp2040::test {

FakePico& fake_pico() {
  static FakePico pico;
  return pico;
}

}  // namespace batuta::rp2040::test

using batuta::rp2040::test::fake_pico;

void adc_init(void) {}
void adc_gpio_init(unsigned /*gpio*/) {}
void adc_select_input(unsigned input) {
  fake_pico().input = input;
}
uint16_t adc_read(void) {
  ++fake_pico().conversions;
  return fake_pico().counts.at(fake_pico().input);
}

void gpio_init(unsigned /*gpio*/) {}
void gpio_pull_down(unsigned /*gpio*/) {}
void gpio_set_function(unsigned gpio, gpio_function_t fn) {
  fake_pico().is_pulsed.at(gpio) = fn == GPIO_FUNC_PWM;
}
bool gpio_get(unsigned /*gpio*/) {
  return fake_pico().loop_closed;
}

unsigned pwm_gpio_to_slice_num(unsigned gpio) {
  return gpio / 2U % 8U;
}
void pwm_set_wrap(unsigned /*slice_num*/, uint16_t wrap) {
  fake_pico().wrap = wrap;
}
void pwm_set_gpio_level(unsigned gpio, uint16_t level) {
  fake_pico().levels.at(gpio) = level;
}
void pwm_set_enabled(unsigned /*slice_num*/, bool /*enabled*/) {}
