// SPDX-License-Identifier: MIT
// The part's interrupts, in the order of the NVIC, behind the core's own 16 vectors.

#include "platforms/cortex_m/vectors.hpp"

#include <array>

#include "platforms/cortex_m/registers.hpp"
#include "platforms/stm32f405/interrupts.hpp"

BATUTA_WEAK_HANDLER(batuta_on_adc)
BATUTA_WEAK_HANDLER(batuta_on_usart1)
BATUTA_WEAK_HANDLER(batuta_on_tim7)
BATUTA_WEAK_HANDLER(batuta_on_dma2_stream0)
BATUTA_WEAK_HANDLER(batuta_on_otg_fs)

namespace batuta::stm32f405 {
namespace {

using Table = std::array<cortex_m::Handler, kInterrupts>;

constexpr std::size_t index_of(Interrupt interrupt) {
  return static_cast<std::size_t>(interrupt);
}

constexpr Table make_table() {
  Table table{};
  for (auto& handler : table) handler = batuta_fault_entry;  // Bound: kInterrupts
  table[index_of(Interrupt::kAdc)] = batuta_on_adc;
  table[index_of(Interrupt::kUsart1)] = batuta_on_usart1;
  table[index_of(Interrupt::kTim7)] = batuta_on_tim7;
  table[index_of(Interrupt::kDma2Stream0)] = batuta_on_dma2_stream0;
  table[index_of(Interrupt::kOtgFs)] = batuta_on_otg_fs;
  return table;
}

}  // namespace

void enable(Interrupt interrupt, std::uint32_t priority) {
  constexpr cortex_m::Register kPriorities{0xE000E400U};  // NVIC_IPR0; the upper four bits count
  const auto number = static_cast<std::uint32_t>(interrupt);
  const cortex_m::Register word = kPriorities + number / 4U * 4U;
  const std::uint32_t shift = 8U * (number % 4U);
  word.write((word.read() & ~(0xFFU << shift)) | (priority << (shift + 4U)));
  cortex_m::enable_interrupt(number);
}

}  // namespace batuta::stm32f405

extern "C" [[gnu::section(".vectors.board"),
             gnu::used]] constexpr batuta::stm32f405::Table batuta_board_vectors =
    batuta::stm32f405::make_table();
