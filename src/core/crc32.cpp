// SPDX-License-Identifier: MIT
// Half a byte at a time: 64 bytes of table where a whole byte at a time needs 1 kB, and a fifth of
// the time of one bit at a time.

#include "batuta/core/crc32.hpp"

#include <array>

namespace batuta {
namespace {

constexpr std::uint32_t kReflectedPolynomial = 0xEDB88320U;
constexpr int kEntries = 16;

constexpr std::uint32_t divide_nibble(std::uint32_t remainder) {
  for (int bit = 0; bit < 4; ++bit) {  // Bound: 4
    remainder = (remainder >> 1U) ^ ((remainder & 1U) != 0 ? kReflectedPolynomial : 0U);
  }
  return remainder;
}

constexpr std::array<std::uint32_t, kEntries> make_table() {
  std::array<std::uint32_t, kEntries> table{};
  for (std::uint32_t i = 0; i < kEntries; ++i) table[i] = divide_nibble(i);  // Bound: kEntries
  return table;
}

constexpr std::array<std::uint32_t, kEntries> kTable = make_table();

}  // namespace

std::uint32_t crc32(const std::uint8_t* bytes, int count) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (int i = 0; i < count; ++i) {  // Bound: count
    crc ^= bytes[i];
    crc = (crc >> 4U) ^ kTable[crc & 0xFU];
    crc = (crc >> 4U) ^ kTable[crc & 0xFU];
  }
  return ~crc;
}

}  // namespace batuta
