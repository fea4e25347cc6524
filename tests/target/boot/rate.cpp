// SPDX-License-Identifier: MIT
// With -icount shift=10 an instruction takes 1024 ns: that tells the rate of the board's clock, and
// that counting instructions is exact.
#include "checks.hpp"
#include "platforms/cortex_m/systick.hpp"
#include "platforms/mps2/board.hpp"

namespace {

using namespace batuta;

/// Executes 2 n + 1 instructions in its loop.
[[gnu::noinline]] void spend(std::uint32_t n) {
  __asm volatile(
      ".syntax unified\n"
      "0: subs %0, #1\n"
      "bne 0b\n"
      : "+l"(n)
      :
      : "cc");
}

std::uint64_t ticks_of(std::uint32_t n) {
  const std::uint64_t before = cortex_m::cycles();
  spend(n);
  return cortex_m::cycles() - before;
}

}  // namespace

int main() {
  Checks check;
  cortex_m::start_systick(cortex_m::longest_period(mps2::kBoard.clock_hz));
  const std::uint64_t few = ticks_of(1000);
  const std::uint64_t many = ticks_of(101'000);
  const std::uint64_t again = ticks_of(101'000);
  // 200,000 instructions of 1.024 us.
  const std::uint64_t expected = 204'800ULL * (mps2::kBoard.clock_hz / 1'000'000U);
  const std::uint64_t found = many - few;
  semihosting::write_unsigned(static_cast<std::uint32_t>(found));
  semihosting::write(" ticks, expected ");
  semihosting::write_unsigned(static_cast<std::uint32_t>(expected));
  semihosting::write("\n");
  constexpr std::uint64_t kInstruction = 33;  // ticks, at most, of one instruction
  check.that(found + kInstruction > expected && found < expected + kInstruction,
             "the clock's rate");
  check.that(again + kInstruction > many && again < many + kInstruction, "the same count again");
  check.end();
}
