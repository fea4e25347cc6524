# SPDX-License-Identifier: MIT
# Arm MPS2+ with AN500: Cortex-M7 with double-precision FPU.
set(BATUTA_BOARD_MACHINE mps2-an500)
set(BATUTA_BOARD_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/mps2.ld)
