// SPDX-License-Identifier: MIT
#pragma once
// Why the part started, from RCC_CSR (RM0090 7.3.21).

#include <cstdint>

#include "platforms/stm32f405/registers/rcc.hpp"

namespace batuta::stm32f405 {

enum class ResetCause : std::uint8_t {
  kUnknown,   ///< no flag is set: an emulator, or flags cleared by a boot loader
  kPowerOn,   ///< also a brown-out
  kPin,       ///< the reset button, or a debugger
  kWatchdog,  ///< independent or window watchdog
  kSoftware,  ///< this port's own, after a fault, or a debugger's
  kLowPower,  ///< never used here
};

/// The pin's flag is set by every other cause too, because a reset from inside pulls the pin: it
/// counts last.
constexpr ResetCause reset_cause(std::uint32_t csr) {
  if ((csr & (Rcc::kCsrIwdgrstf | Rcc::kCsrWwdgrstf)) != 0) return ResetCause::kWatchdog;
  if ((csr & Rcc::kCsrSftrstf) != 0) return ResetCause::kSoftware;
  if ((csr & Rcc::kCsrLpwrrstf) != 0) return ResetCause::kLowPower;
  if ((csr & (Rcc::kCsrPorrstf | Rcc::kCsrBorrstf)) != 0) return ResetCause::kPowerOn;
  if ((csr & Rcc::kCsrPinrstf) != 0) return ResetCause::kPin;
  return ResetCause::kUnknown;
}

}  // namespace batuta::stm32f405
