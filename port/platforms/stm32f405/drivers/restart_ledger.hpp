// SPDX-License-Identifier: MIT
#pragma once
// How often in a row the part has restarted by itself. A fault that comes back at once must not
// become a motor that jerks a hundred times a second: after kMaxRestarts the board parks, without
// force, until somebody presses reset or takes the power away.

#include <cstdint>

#include "platforms/stm32f405/drivers/reset_cause.hpp"

namespace batuta::stm32f405 {

/// Lies in RAM that no start clears; after power-on it holds anything.
struct RestartLedger {
  std::uint32_t restarts;
  std::uint32_t check;
};

inline constexpr std::uint32_t kMaxRestarts = 3;
inline constexpr std::uint32_t kLedgerKey = 0xB47A7A5EU;  ///< check = restarts ^ key

inline void write_restarts(RestartLedger& ledger, std::uint32_t restarts) {
  ledger.restarts = restarts;
  ledger.check = restarts ^ kLedgerKey;
}

/// 0 where the ledger holds nonsense.
constexpr std::uint32_t restarts_in(const RestartLedger& ledger) {
  return (ledger.restarts ^ kLedgerKey) == ledger.check ? ledger.restarts : 0U;
}

/// At every start, first of all.
/// @param fault_recorded  decides where the part does not tell the cause, or whose a software reset
///   is: this port records a fault before its own, a debugger does not
/// @returns true: run | false: restarted too often, park
inline bool may_run(RestartLedger& ledger, ResetCause cause, bool fault_recorded) {
  const bool may_be_own = cause == ResetCause::kSoftware || cause == ResetCause::kUnknown;
  const bool by_itself = cause == ResetCause::kWatchdog || (may_be_own && fault_recorded);
  if (!by_itself) {
    write_restarts(ledger, 0);
    return true;
  }
  const std::uint32_t before = restarts_in(ledger);
  if (before >= kMaxRestarts) return false;
  write_restarts(ledger, before + 1U);
  return true;
}

/// After kHealthyTicks ticks without a fault: what happened before has nothing to do with what may
/// happen now.
inline constexpr std::uint32_t kHealthyTicks = 10000;
inline void note_healthy(RestartLedger& ledger) {
  write_restarts(ledger, 0);
}

}  // namespace batuta::stm32f405
