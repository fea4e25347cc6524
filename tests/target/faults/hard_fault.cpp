// SPDX-License-Identifier: MIT
// What a processor refuses to do: hard_fault undefined|address|interrupt
#include "platforms/cortex_m/registers.hpp"
#include "push.hpp"

extern "C" {
extern const char undefined_instruction[];
extern const char bad_access[];
}

namespace {

/// Says where it will fault, then executes an instruction that does not exist.
void execute_undefined() {
  announce(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(undefined_instruction)));
  __asm volatile(
      ".global undefined_instruction\n"
      "undefined_instruction: udf #0\n");
}

/// Reads where there is no memory.
void read_nothing() {
  announce(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bad_access)));
  __asm volatile(
      ".global bad_access\n"
      "bad_access: ldr r0, [%0]\n" ::"l"(0xFFFFFFF0U)
      : "r0", "memory");
}

/// Raises PendSV, which nobody handles.
void interrupt_unexpectedly() {
  constexpr std::uint32_t kSetPendSv = 1U << 28;
  batuta::cortex_m::kInterruptControl.write(kSetPendSv);
  __asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace

int main() {
  push();
  switch (first_argument()) {
    case 'u':
      execute_undefined();
      break;
    case 'a':
      read_nothing();
      break;
    default:
      interrupt_unexpectedly();
  }
  batuta::semihosting::exit(0);
}
