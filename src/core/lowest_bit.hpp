// SPDX-License-Identifier: MIT
#pragma once
// Where the lowest set bit of a word is: one instruction where the compiler knows it, else counted.

#include <cstddef>
#include <cstdint>

namespace batuta::detail {

/// Position of the lowest set bit, in C++ alone. @pre word != 0. Bound: 31.
constexpr std::size_t counted_lowest_bit(std::uint32_t word) {
  std::size_t position = 0;
  for (; (word & 1U) == 0 && position < 31; word >>= 1U) ++position;  // Bound: 31
  return position;
}

/// The same. @pre word != 0
inline std::size_t lowest_bit(std::uint32_t word) {
#if defined(__GNUC__) || defined(__clang__)
  return static_cast<std::size_t>(__builtin_ctz(word));
#else
  return counted_lowest_bit(word);
#endif
}

}  // namespace batuta::detail
