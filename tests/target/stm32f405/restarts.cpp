// SPDX-License-Identifier: MIT
// A program that fails as soon as it runs: says how it was started, then trips an assert. The board
// has to start it so many times and no more.

#include "batuta/core/assert.hpp"
#include "platforms/cortex_m/fault.hpp"
#include "platforms/stm32f405/board.hpp"
#include "platforms/stm32f405/drivers/usart_stream.hpp"
#include "platforms/stm32f405/interrupts.hpp"
#include "platforms/stm32f405/memory_map.hpp"

namespace {

batuta::stm32f405::UsartStream stream(batuta::stm32f405::usart1());

}  // namespace

void batuta_on_usart1() {
  stream.on_interrupt();
}

int main() {
  using namespace batuta;
  stream.start(stm32f405::brr_of(stm32f405::kClocks.pclk2_hz(), stm32f405::kBaud));
  const auto code = static_cast<std::uint32_t>(cortex_m::take_last_fault().code);
  const std::uint8_t line[] = {'s', 't', 'a', 'r', 't', ' ', static_cast<std::uint8_t>('0' + code),
                               '\n'};
  (void)stream.write(line, sizeof(line));
  batuta_trap(file_id(__FILE__), __LINE__);
}
