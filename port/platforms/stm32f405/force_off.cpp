// SPDX-License-Identifier: MIT
// The force's end: two stores, each of which is enough, and which need no stack, no variable and no
// working clock.

#include "platforms/cortex_m/fault.hpp"
#include "platforms/stm32f405/board.hpp"
#include "platforms/stm32f405/drivers/bridge_force.hpp"
#include "platforms/stm32f405/memory_map.hpp"

void batuta_board_force_off() {
  using namespace batuta::stm32f405;
  tim8().bdtr = BridgeForce::kSafe;  // outputs forced low by the timer
  gpioc().moder = kPortCSafe;        // the pins taken from the timer; as outputs they are low
}
