// SPDX-License-Identifier: MIT
// The other end of uart_test.py: sends back what comes, or does not read at all.
//   uart echo COUNT    ends after COUNT bytes have come; 0 where none was lost
//   uart flood COUNT   reads nothing until COUNT bytes have come, then counts what is there
#include "platforms/mps2/uart.hpp"

#include "checks.hpp"
#include "platforms/mps2/board.hpp"

namespace {

using namespace batuta;

mps2::Uart uart;

std::uint32_t number_of(const char* text) {
  std::uint32_t number = 0;
  for (; *text != '\0'; ++text) number = number * 10 + static_cast<std::uint32_t>(*text - '0');
  return number;
}

void echo(std::uint32_t count) {
  std::uint8_t bytes[100];
  // Bound: the test's time-out.
  for (std::uint32_t done = 0; done < count;) {
    const int come = uart.read(bytes, sizeof bytes);
    for (int sent = 0; sent < come;) sent += uart.write(bytes + sent, come - sent);
    done += static_cast<std::uint32_t>(come);
  }
}

/// @returns how many of the bytes were kept
std::uint32_t flood(std::uint32_t count) {
  // Bound: the test's time-out.
  while (uart.overruns() + mps2::Uart::kReceiveCapacity < count) {
  }
  std::uint8_t bytes[100];
  std::uint32_t kept = 0;
  for (int come = 1; come > 0; kept += static_cast<std::uint32_t>(come)) {
    come = uart.read(bytes, sizeof bytes);
  }
  return kept;
}

}  // namespace

int main() {
  char line[512];
  char mode[8];
  char count_text[12];
  Checks check;
  check.that(!uart.start(0) && !uart.start(mps2::kBoard.clock_hz), "impossible rates are refused");
  check.that(uart.start(1'000'000), "a possible rate");
  check.that(semihosting::read_command_line(line, sizeof line) > 0 &&
                 semihosting::word_of(line, 1, mode, sizeof mode) > 0 &&
                 semihosting::word_of(line, 2, count_text, sizeof count_text) > 0,
             "arguments");
  const std::uint32_t count = number_of(count_text);
  if (mode[0] == 'e') {
    echo(count);
    check.that(uart.overruns() == 0, "nothing was lost");
  } else {
    check.that(flood(count) == mps2::Uart::kReceiveCapacity, "a full ring was kept");
    check.that(uart.overruns() == count - mps2::Uart::kReceiveCapacity, "the rest was counted");
  }
  check.end();
}
