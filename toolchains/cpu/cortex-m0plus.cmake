# SPDX-License-Identifier: MIT
# Armv6-M: no FPU, no hardware division.
set(BATUTA_CPU_FLAGS "-mcpu=cortex-m0plus -mthumb -mfloat-abi=soft")
