# SPDX-License-Identifier: MIT
# QEMU's machine with an STM32F405RG. The image is the one for a real board: see stm32f405.md.
set(BATUTA_BOARD_MACHINE netduinoplus2)
set(BATUTA_BOARD_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/stm32f405rg.ld)
