// SPDX-License-Identifier: MIT
#pragma once
// What differs between the boards: Arm application notes AN385, AN386, AN500 (one map), AN505 and
// AN547 (secure aliases of the peripherals).

#include <cstdint>

namespace batuta::mps2 {

struct Board {
  std::uint32_t clock_hz;
  std::uint32_t uart;    ///< base of UART 0
  std::uint32_t fpgaio;  ///< base of the LEDs and buttons
  std::uint32_t uart_receive_interrupt;
  std::uint32_t uart_transmit_interrupt;
};

inline constexpr Board an385{25'000'000, 0x40004000, 0x40028000, 0, 1};
inline constexpr Board an386 = an385;
inline constexpr Board an500 = an385;
inline constexpr Board an505{20'000'000, 0x50200000, 0x50302000, 32, 33};
inline constexpr Board an547{32'000'000, 0x59303000, 0x59302000, 33, 34};

/// The board that the program is built for.
inline constexpr Board kBoard = BATUTA_MPS2_BOARD;

}  // namespace batuta::mps2

/// The board's interrupt handlers that uart.cpp defines.
extern "C" void batuta_on_uart_receive();
extern "C" void batuta_on_uart_transmit();
