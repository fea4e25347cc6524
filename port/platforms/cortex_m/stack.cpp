// SPDX-License-Identifier: MIT
#include "platforms/cortex_m/stack.hpp"

#include <cstdint>

#include "platforms/cortex_m/registers.hpp"

extern "C" std::uint32_t batuta_stack_bottom[];  // of the linker script
extern "C" std::uint32_t batuta_stack_top[];

namespace batuta::cortex_m {
namespace {

constexpr std::uint32_t kPaint = 0xA5A5A5A5U;  // as in startup.cpp

std::size_t bytes_between(const std::uint32_t* from, const std::uint32_t* to) {
  return reinterpret_cast<std::uintptr_t>(to) - reinterpret_cast<std::uintptr_t>(from);
}

}  // namespace

std::size_t stack_size() {
  return bytes_between(batuta_stack_bottom, batuta_stack_top);
}

std::size_t stack_used() {
  const volatile std::uint32_t* word = batuta_stack_bottom;
  // Bound: stack_size() / 4.
  while (word < batuta_stack_top && *word == kPaint) ++word;
  return bytes_between(const_cast<const std::uint32_t*>(word), batuta_stack_top);
}

void repaint_stack() {
  const InterruptLock lock;  // an interrupt's frame would be painted over
  std::uint32_t* here = nullptr;
  __asm volatile("mov %0, sp" : "=r"(here));
  // Bound: stack_size() / 4.
  for (volatile std::uint32_t* word = batuta_stack_bottom; word < here; ++word) *word = kPaint;
}

}  // namespace batuta::cortex_m
