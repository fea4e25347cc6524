// SPDX-License-Identifier: MIT
// From reset to main(). Nothing touches an FP register before the FPU is enabled: a compiled
// function may do so in its first instruction, so the entry is assembly.
#include <cstdint>

#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/registers.hpp"
#include "platforms/cortex_m/stack_guard.hpp"

int batuta_main() __asm__("main");  // C++ does not let a program call main by its name

extern "C" {

// Of the linker script.
extern std::uint32_t batuta_vectors[];
extern std::uint32_t batuta_data[];
extern std::uint32_t batuta_data_end[];
extern const std::uint32_t batuta_data_load[];
extern std::uint32_t batuta_bss[];
extern std::uint32_t batuta_bss_end[];
extern void (*const batuta_init_array[])();
extern void (*const batuta_init_array_end[])();

[[gnu::naked, gnu::used]] void batuta_reset() {
  __asm volatile(
      ".syntax unified\n"
      // A debugger or boot loader may come here with interrupts on, on the other stack.
      "cpsid i\n"
      "movs r0, #0\n"
      "msr control, r0\n"
      "isb\n"
      "ldr r0, =batuta_stack_top\n"
      "mov sp, r0\n"
      "ldr r1, =batuta_stack_bottom\n"
#if __ARM_ARCH >= 8
      "msr msplim, r1\n"
#endif
      // The stack is painted to see later how deep it was used. Bound: its size / 4.
      "ldr r2, =0xA5A5A5A5\n"
      "0: str r2, [r1]\n"
      "adds r1, #4\n"
      "cmp r1, r0\n"
      "blo 0b\n"
      "movs r0, #0\n"
#ifdef __ARM_FP
      "ldr r1, =0xE000ED88\n"  // CPACR: coprocessors 10 and 11, full access
      "ldr r2, =0x00F00000\n"
      "ldr r0, [r1]\n"
      "orrs r0, r2\n"
      "str r0, [r1]\n"
      "dsb\n"
      "isb\n"
      "ldr r0, [r1]\n"
#endif
      "bl batuta_start\n"
      ".ltorg\n");
}

/// @param coprocessors  CPACR as it is after the FPU was enabled
[[noreturn, gnu::used]] void batuta_start(std::uint32_t coprocessors);
}

namespace {

using batuta::cortex_m::enter_safe_state;
using batuta::cortex_m::FaultCode;
using batuta::cortex_m::StartUpFailure;

[[noreturn]] void fail_start_up(StartUpFailure failure, std::uint32_t reason) {
  enter_safe_state(FaultCode::kStartUp, static_cast<std::uint32_t>(failure), reason);
}

/// The bits that stay clear where there is no FPU.
#ifdef __ARM_FP
constexpr std::uint32_t kFpuAccess = 0x00F00000U;
#else
constexpr std::uint32_t kFpuAccess = 0;
#endif

void initialise_variables() {
  const std::uint32_t* from = batuta_data_load;
  // Bound: the size of .data.
  for (std::uint32_t* to = batuta_data; to < batuta_data_end; ++to) *to = *from++;
  // Bound: the size of .bss.
  for (std::uint32_t* to = batuta_bss; to < batuta_bss_end; ++to) *to = 0;
}

void run_constructors() {
  // Bound: as many as were linked.
  // cppcheck-suppress comparePointers ; deviation: linker-symbols
  for (const auto* at = batuta_init_array; at < batuta_init_array_end; ++at) {
    (*at)();
  }
}

}  // namespace

void batuta_start(std::uint32_t coprocessors) {
  // Where the table was found at reset is not where it is if a boot loader came first.
  batuta::cortex_m::kVectorTable.write(reinterpret_cast<std::uintptr_t>(batuta_vectors));
  __asm volatile("dsb\n isb" ::: "memory");
  batuta::cortex_m::guard_stack();
  initialise_variables();
  // cppcheck-suppress knownConditionTrueFalse ; deviation: no-fpu
  if ((coprocessors & kFpuAccess) != kFpuAccess) {
    fail_start_up(StartUpFailure::kNoFpu, coprocessors);
  }
  if (const std::uint32_t reason = batuta_board_init(); reason != 0) {
    fail_start_up(StartUpFailure::kBoard, reason);
  }
  run_constructors();
  __asm volatile("cpsie i" ::: "memory");
  enter_safe_state(FaultCode::kMainReturned, static_cast<std::uint32_t>(batuta_main()), 0);
}
