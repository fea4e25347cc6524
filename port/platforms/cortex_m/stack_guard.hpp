// SPDX-License-Identifier: MIT
#pragma once
// What lies below the stack is out of reach, so that an overflow faults at its first access.

namespace batuta::cortex_m {

/// Armv6-M and Armv7-M: the last region of the MPU forbids the 64 KB below the stack's bottom,
/// which costs no memory. Without an MPU, and for frames larger than that, what is below RAM has to
/// fault by itself. Armv8-M has its stack limit register instead, set at reset; nothing is done
/// here.
void guard_stack();

}  // namespace batuta::cortex_m
