// SPDX-License-Identifier: MIT
// What the compiler expects of a C++ run-time library, without what the real one would bring along
// (the heap, the unwinder, text).
#include "platforms/cortex_m/fault.hpp"

extern "C" {
// NOLINTBEGIN(readability-identifier-naming) deviation: run-time-names

void* __dso_handle = nullptr;

// Destructors of static objects: the firmware never ends.
int __cxa_atexit(void (*)(void*), void*, void*) {
  return 0;
}
int __aeabi_atexit(void*, void (*)(void*), void*) {
  return 0;
}

// A call of an object that is not constructed yet, or no longer: an assert without a line.
[[noreturn]] void __cxa_pure_virtual() {
  batuta::cortex_m::enter_safe_state(batuta::cortex_m::FaultCode::kAssert, 0, 0);
}

// Named by libgcc's division routines; nothing unwinds.
[[gnu::weak]] void __aeabi_unwind_cpp_pr0() {}

// NOLINTEND(readability-identifier-naming) deviation: run-time-names
}
