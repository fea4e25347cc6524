# SPDX-License-Identifier: MIT
# Arm MPS3 with AN547: Cortex-M55; all runs in the secure state.
set(BATUTA_BOARD_MACHINE mps3-an547)
set(BATUTA_BOARD_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/an547.ld)
