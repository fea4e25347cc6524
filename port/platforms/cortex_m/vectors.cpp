// SPDX-License-Identifier: MIT
// The vector table behind its first word, the stack pointer (sections.ld): the core's exceptions.
// The board's interrupts follow in section .vectors.board.
#include "platforms/cortex_m/vectors.hpp"

extern "C" void batuta_reset();

BATUTA_WEAK_HANDLER(batuta_on_svcall)
BATUTA_WEAK_HANDLER(batuta_on_pendsv)
BATUTA_WEAK_HANDLER(batuta_on_systick)

extern "C" [[gnu::section(".vectors.core"),
             gnu::used]] constexpr batuta::cortex_m::Handler batuta_core_vectors[15] = {
    batuta_reset,
    batuta_fault_entry,  // NMI
    batuta_fault_entry,  // HardFault
    batuta_fault_entry,  // MemManage, BusFault, UsageFault, SecureFault: not enabled, so that they
    batuta_fault_entry,  // arrive as HardFault
    batuta_fault_entry, batuta_fault_entry, batuta_fault_entry,
    batuta_fault_entry, batuta_fault_entry, batuta_on_svcall,
    batuta_fault_entry,  // DebugMonitor
    batuta_fault_entry, batuta_on_pendsv,   batuta_on_systick,
};
