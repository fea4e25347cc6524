// SPDX-License-Identifier: MIT
#include "platforms/cortex_m/fault.hpp"

std::uint32_t batuta_board_init() {
  batuta_board_force_off();  // clocks and pins are as the FPGA image sets them
  return 0;
}
