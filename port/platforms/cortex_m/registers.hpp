// SPDX-License-Identifier: MIT
#pragma once
// The system registers that every Cortex-M has (or reads as zero), by their names in the Armv6-M,
// Armv7-M and Armv8-M manuals.

#include <cstdint>

namespace batuta::cortex_m {

/// A 32-bit device register.
class Register {
 public:
  constexpr explicit Register(std::uint32_t address) : address_(address) {}
  std::uint32_t read() const { return *pointer(); }
  void write(std::uint32_t value) const { *pointer() = value; }
  bool is_set(std::uint32_t bits) const { return (read() & bits) == bits; }
  void set(std::uint32_t bits) const { write(read() | bits); }
  void clear(std::uint32_t bits) const { write(read() & ~bits); }
  /// The register `bytes` further on.
  constexpr Register operator+(std::uint32_t bytes) const { return Register(address_ + bytes); }

 private:
  volatile std::uint32_t* pointer() const {
    // NOLINTNEXTLINE(performance-no-int-to-ptr) deviation: memory-mapped
    return reinterpret_cast<volatile std::uint32_t*>(address_);
  }
  std::uint32_t address_;
};

inline constexpr Register kSysTickControl{0xE000E010U};
inline constexpr Register kSysTickReload{0xE000E014U};
inline constexpr Register kSysTickCurrent{0xE000E018U};
inline constexpr Register kInterruptEnable{0xE000E100U};   ///< NVIC_ISER0, one bit an interrupt
inline constexpr Register kInterruptControl{0xE000ED04U};  ///< ICSR
inline constexpr Register kVectorTable{0xE000ED08U};       ///< VTOR
inline constexpr Register kResetControl{0xE000ED0CU};      ///< AIRCR
inline constexpr Register kFaultStatus{0xE000ED28U};       ///< CFSR; zero on Armv6-M
inline constexpr Register kMemFaultAddress{0xE000ED34U};   ///< MMFAR
inline constexpr Register kBusFaultAddress{0xE000ED38U};   ///< BFAR
inline constexpr Register kFpContext{0xE000EF34U};         ///< FPCCR

/// Lets interrupt `number` of the NVIC happen.
inline void enable_interrupt(std::uint32_t number) {
  (kInterruptEnable + number / 32U * 4U).write(1U << (number % 32U));
}

/// Starts the processor anew; memory keeps its contents.
[[noreturn]] inline void reset() {
  constexpr std::uint32_t kKeyAndRequest = 0x05FA0004U;
  __asm volatile("dsb" ::: "memory");
  kResetControl.write(kKeyAndRequest);
  __asm volatile("dsb" ::: "memory");
  for (;;) __asm volatile("");  // Bound: a few cycles, until the reset arrives.
}

/// No interrupt happens while one of these lives; what was before comes back, and what is pending
/// happens, before the next instruction. Nests.
class InterruptLock {
 public:
  InterruptLock() {
    __asm volatile("mrs %0, primask" : "=r"(before_));
    __asm volatile("cpsid i" ::: "memory");
  }
  ~InterruptLock() { __asm volatile("msr primask, %0\n isb" ::"r"(before_) : "memory"); }
  InterruptLock(const InterruptLock&) = delete;
  InterruptLock& operator=(const InterruptLock&) = delete;

 private:
  std::uint32_t before_ = 0;
};

}  // namespace batuta::cortex_m
