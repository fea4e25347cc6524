// SPDX-License-Identifier: MIT
#pragma once
// The number that no other part has: RM0090 section 39.1.

#include <array>
#include <cstdint>

namespace batuta::stm32f405 {

struct UniqueId {
  volatile std::uint32_t words[3];
};

/// As hexadecimal digits with a zero behind them: a serial number. Bound: 24 digits.
inline std::array<char, 25> serial_of(const UniqueId& id) {
  constexpr unsigned kDigitsOfWord = 8;
  std::array<char, 25> text{};
  for (unsigned i = 0; i < 3 * kDigitsOfWord; ++i) {
    const std::uint32_t word = id.words[i / kDigitsOfWord];
    const std::uint32_t shift = 4U * (kDigitsOfWord - 1U - i % kDigitsOfWord);
    text[i] = "0123456789ABCDEF"[(word >> shift) % 16U];
  }
  return text;
}

}  // namespace batuta::stm32f405
