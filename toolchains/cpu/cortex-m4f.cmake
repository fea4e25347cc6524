# SPDX-License-Identifier: MIT
# Armv7E-M with a single-precision FPU.
set(BATUTA_CPU_FLAGS "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16")
