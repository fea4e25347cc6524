# SPDX-License-Identifier: MIT
# Arm MPS2+ with AN505: Cortex-M33 with FPU and TrustZone; all runs in the secure state.
set(BATUTA_BOARD_MACHINE mps2-an505)
set(BATUTA_BOARD_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/an505.ld)
