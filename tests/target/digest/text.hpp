// SPDX-License-Identifier: MIT
#pragma once
// A line of text, put together without a C library.

#include <array>
#include <cstddef>
#include <cstdint>

namespace batuta::digest {

/// What does not fit is cut off.
class Text {
 public:
  Text& operator<<(const char* text) {
    for (; *text != '\0'; ++text) put(*text);  // Bound: the length of the text
    return *this;
  }
  Text& operator<<(std::uint32_t number) {
    std::uint32_t unit = 1;
    while (number / unit >= 10) unit *= 10;                          // Bound: 9
    for (; unit > 0; unit /= 10) put(digit_of(number / unit % 10));  // Bound: 10
    return *this;
  }
  Text& hex(std::uint32_t word) {
    for (unsigned shift = 32; shift > 0; shift -= 4) put(digit_of(word >> (shift - 4) & 15U));
    return *this;
  }
  Text& hex(std::uint64_t words) {
    return hex(static_cast<std::uint32_t>(words >> 32U)).hex(static_cast<std::uint32_t>(words));
  }
  const char* c_str() const { return line_.data(); }

 private:
  static char digit_of(std::uint32_t value) { return "0123456789abcdef"[value]; }
  void put(char c) {
    if (length_ + 1 == line_.size()) return;
    line_[length_] = c;
    ++length_;
  }

  std::array<char, 120> line_{};
  std::size_t length_ = 0;
};

}  // namespace batuta::digest
