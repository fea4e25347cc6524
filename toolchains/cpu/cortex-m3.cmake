# SPDX-License-Identifier: MIT
# Armv7-M: no FPU.
set(BATUTA_CPU_FLAGS "-mcpu=cortex-m3 -mthumb -mfloat-abi=soft")
