// SPDX-License-Identifier: MIT
// Two zeros between ones, as the cable carries them: no byte of it is zero.
#include "shared/link/cobs.hpp"

int main() {
  const std::uint8_t bytes[] = {1, 0, 0, 1};
  std::uint8_t stuffed[5] = {};
  if (batuta::link::cobs_encode(bytes, 4, stuffed) != 5) return 1;
  for (const std::uint8_t byte : stuffed) {
    if (byte == 0) return 1;
  }
  return 0;
}
