// SPDX-License-Identifier: MIT
#include "platforms/cortex_m/fault.hpp"

namespace batuta::cortex_m {
namespace {

struct CheckedRecord {
  FaultRecord record;
  std::uint32_t check;
};

// No initialiser: the start-up code must leave it alone.
[[gnu::section(".noinit.fault")]] union Kept {
  CheckedRecord checked;
  Kept() {}
} kept;

/// Memory after power-on is anything, and all zeros or all ones most likely: neither passes.
std::uint32_t check_word(const FaultRecord& record) {
  constexpr std::uint32_t kMark = 0xBA7C7A5EU;
  const auto code = static_cast<std::uint32_t>(record.code);
  return ((code * 31U + record.detail[0]) * 31U + record.detail[1]) ^ kMark;
}

}  // namespace

void record_fault(FaultCode code, std::uint32_t detail0, std::uint32_t detail1) {
  kept.checked.record = {code, {detail0, detail1}};
  kept.checked.check = check_word(kept.checked.record);
}

FaultRecord last_fault() {
  const CheckedRecord found = kept.checked;
  const bool exists = found.record.code <= FaultCode::kMainReturned;
  return exists && found.check == check_word(found.record) ? found.record : FaultRecord{};
}

FaultRecord take_last_fault() {
  const FaultRecord found = last_fault();
  record_fault(FaultCode::kNone, 0, 0);
  return found;
}

void enter_safe_state(FaultCode code, std::uint32_t detail0, std::uint32_t detail1) {
  __asm volatile("cpsid i" ::: "memory");
  batuta_board_force_off();
  record_fault(code, detail0, detail1);
  batuta_board_halt(code);
}

}  // namespace batuta::cortex_m
