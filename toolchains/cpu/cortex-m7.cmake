# SPDX-License-Identifier: MIT
# Armv7E-M with a double-precision FPU.
set(BATUTA_CPU_FLAGS "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16")
