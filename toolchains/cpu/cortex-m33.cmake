# SPDX-License-Identifier: MIT
# Armv8-M with a single-precision FPU.
set(BATUTA_CPU_FLAGS "-mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16")
