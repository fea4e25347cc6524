// SPDX-License-Identifier: MIT
// What the processor calls where it cannot go on. The stack may be what broke, so the entry moves
// to a stack of its own before anything else.
#include <cstdint>

#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/registers.hpp"
#include "platforms/cortex_m/vectors.hpp"

extern "C" {

extern std::uint32_t batuta_stack_bottom[];  // of the linker script
extern std::uint32_t batuta_stack_top[];

[[gnu::naked, gnu::used]] void batuta_fault_entry() {
  __asm volatile(
      ".syntax unified\n"
      "mrs r0, msp\n"
      "ldr r2, =batuta_fault_stack_top\n"
#if __ARM_ARCH >= 8
      "movs r3, #0\n"
      "msr msplim, r3\n"
#endif
      "mov sp, r2\n"
      "bl batuta_fault\n"
      ".ltorg\n");
}

/// @param main_stack  stack pointer at the entry: the frame of the exception, if it could be stored
[[noreturn, gnu::used]] void batuta_fault(std::uintptr_t main_stack);
}

namespace {

using batuta::cortex_m::FaultCode;
using batuta::cortex_m::Register;

constexpr std::uint32_t kMemFaultAddressValid = 1U << 7;
constexpr std::uint32_t kBusFaultAddressValid = 1U << 15;
/// The exception's frame could not be stored, by MPU, bus or (Armv8-M) stack limit.
constexpr std::uint32_t kStackingFailed = (1U << 4) | (1U << 12) | (1U << 20);

/// Addresses so far below the stack are taken for the stack's.
constexpr std::uintptr_t kBelowStack = 0x10000U;

/// Words of an exception frame; the seventh is the program counter.
constexpr std::uintptr_t kFrameBytes = 32;
constexpr std::uint32_t kFrameProgramCounter = 24;

std::uint32_t exception_number() {
  std::uint32_t number = 0;
  __asm volatile("mrs %0, ipsr" : "=r"(number));
  return number;
}

/// The FPU may still owe the store of its registers into a frame that is not in memory any more.
void forget_fp_registers() {
#ifdef __ARM_FP
  constexpr std::uint32_t kLazyStoreActive = 1U;
  batuta::cortex_m::kFpContext.clear(kLazyStoreActive);
#endif
}

bool is_below_stack(std::uintptr_t address) {
  const auto bottom = reinterpret_cast<std::uintptr_t>(batuta_stack_bottom);
  return address < bottom && bottom - address <= kBelowStack;
}

bool is_stack_overflow(std::uintptr_t stack, std::uint32_t status) {
  if (is_below_stack(stack) || (status & kStackingFailed) != 0) return true;
  if ((status & kMemFaultAddressValid) != 0) {
    return is_below_stack(batuta::cortex_m::kMemFaultAddress.read());
  }
  return (status & kBusFaultAddressValid) != 0 &&
         is_below_stack(batuta::cortex_m::kBusFaultAddress.read());
}

/// Where the program was; 0 where the frame is not in the stack.
std::uint32_t program_counter(std::uintptr_t stack) {
  const auto bottom = reinterpret_cast<std::uintptr_t>(batuta_stack_bottom);
  const auto top = reinterpret_cast<std::uintptr_t>(batuta_stack_top);
  if (stack < bottom || stack > top - kFrameBytes) return 0;
  return Register(static_cast<std::uint32_t>(stack) + kFrameProgramCounter).read();
}

}  // namespace

void batuta_fault(std::uintptr_t main_stack) {
  __asm volatile("cpsid i" ::: "memory");
  batuta_board_force_off();  // first of all; enter_safe_state() does it again
  forget_fp_registers();
  const std::uint32_t status = batuta::cortex_m::kFaultStatus.read();
  if (is_stack_overflow(main_stack, status)) {
    enter_safe_state(FaultCode::kStackOverflow, main_stack, status);
  }
  constexpr std::uint32_t kHardFaultNumber = 3;
  const std::uint32_t number = exception_number();
  enter_safe_state(
      FaultCode::kHardFault, program_counter(main_stack),
      number == kHardFaultNumber ? status : batuta::cortex_m::kUnexpectedInterrupt | number);
}
