# SPDX-License-Identifier: MIT
# Arm MPS2+ with AN385: Cortex-M3 (also runs code for Cortex-M0+).
set(BATUTA_BOARD_MACHINE mps2-an385)
set(BATUTA_BOARD_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/mps2.ld)
