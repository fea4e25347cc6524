# SPDX-License-Identifier: MIT
# Armv8.1-M. Without MVE: its vector arithmetic flushes subnormal numbers to zero, scalar arithmetic does not.
set(BATUTA_CPU_FLAGS "-mcpu=cortex-m55+nomve -mthumb -mfloat-abi=hard -mfpu=auto")
