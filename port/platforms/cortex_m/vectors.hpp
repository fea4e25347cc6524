// SPDX-License-Identifier: MIT
#pragma once
// Exception handlers, and what a vector table is made of.

namespace batuta::cortex_m {
using Handler = void (*)();
}

/// Takes every exception that is a fault, or that nobody handles, to the safe state.
extern "C" void batuta_fault_entry();

// Handlers of the core's own exceptions that a program may define.
extern "C" void batuta_on_svcall();
extern "C" void batuta_on_pendsv();
extern "C" void batuta_on_systick();

/// Defines handler `name` for a program that defines none: the unexpected. It leaves the stack as
/// the exception left it.
#define BATUTA_WEAK_HANDLER(name)                    \
  extern "C" [[gnu::weak, gnu::naked]] void name() { \
    __asm volatile(                                  \
        "ldr r0, =batuta_fault_entry\n"              \
        "bx r0\n"                                    \
        ".ltorg\n");                                 \
  }
