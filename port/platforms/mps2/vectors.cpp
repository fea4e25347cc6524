// SPDX-License-Identifier: MIT
// The board's interrupts: UART 0, and the unexpected.
#include "platforms/cortex_m/vectors.hpp"

#include <array>
#include <cstddef>

#include "platforms/mps2/board.hpp"

BATUTA_WEAK_HANDLER(batuta_on_uart_receive)
BATUTA_WEAK_HANDLER(batuta_on_uart_transmit)

namespace batuta::mps2 {
namespace {

constexpr std::size_t kInterrupts = 64;
using Table = std::array<cortex_m::Handler, kInterrupts>;

constexpr Table make_table() {
  Table table{};
  for (auto& handler : table) handler = batuta_fault_entry;  // Bound: kInterrupts.
  table[kBoard.uart_receive_interrupt] = batuta_on_uart_receive;
  table[kBoard.uart_transmit_interrupt] = batuta_on_uart_transmit;
  return table;
}

}  // namespace
}  // namespace batuta::mps2

extern "C" [[gnu::section(".vectors.board"),
             gnu::used]] constexpr batuta::mps2::Table batuta_board_vectors =
    batuta::mps2::make_table();
