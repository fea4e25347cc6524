// SPDX-License-Identifier: MIT
#pragma once
// A report descriptor, item by item, while the program is compiled: a field is written down with
// all that belongs to it, and what does not change from one field to the next is not said again.
// Source: Device Class Definition for HID 1.11, section 6.2.2.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "shared/hid_pid/usages.hpp"

namespace batuta::pid {

/// Which way a report goes: the prefix of its main items.
enum class Way : std::uint8_t { kInput = 0x80, kOutput = 0x90, kFeature = 0xB0 };
enum class Collection : std::uint8_t { kApplication = 1, kLogical = 2 };

/// What a number means, and how many bits it has.
struct Number {
  int low = 0;
  int high = 0;
  int physical_low = 0;
  int physical_high = 0;
  int bits = 0;
  int unit = 0;      ///< nibbles of the HID unit item; 0: none
  int exponent = 0;  ///< of ten
};

/// The items so far. Only for use in constant expressions: running out of room does not compile.
class Items {
 public:
  static constexpr std::size_t kRoom = 1024;

  constexpr void begin(Collection kind, Usage name) {
    usage(name);
    tell(0xA0, static_cast<unsigned>(kind));
  }
  constexpr void end() { put(0xC0); }
  /// What follows is in this report.
  constexpr void report(std::uint8_t id) { tell(0x84, id); }

  /// One value for each usage.
  constexpr void values(Way way, const Number& number, std::initializer_list<Usage> names) {
    describe(number, names.size());
    for (const Usage name : names) usage(name);  // Bound: the names
    tell(static_cast<std::uint8_t>(way), kVariable);
  }
  /// One value for each usage from `first` on.
  constexpr void values_from(Way way, const Number& number, Usage first, int count) {
    describe(number, static_cast<std::size_t>(count));
    page_of(first);
    tell(0x18, number_of(first));
    tell(0x28, number_of(first) + static_cast<unsigned>(count) - 1U);
    tell(static_cast<std::uint8_t>(way), kVariable);
  }
  /// One byte, which says by 1, 2, ... which of the usages holds.
  constexpr void choice(Way way, std::initializer_list<Usage> names) {
    const int count = static_cast<int>(names.size());
    describe({1, count, 1, count, 8}, 1);
    for (const Usage name : names) usage(name);  // Bound: the names
    tell(static_cast<std::uint8_t>(way), 0);
  }
  /// Bits that mean nothing.
  constexpr void padding(Way way, int bits) {
    global(0x74, size_, bits);
    global(0x94, count_, 1);
    tell(static_cast<std::uint8_t>(way), kConstant | kVariable);
  }

  constexpr std::size_t size() const { return used_; }
  constexpr std::uint8_t operator[](std::size_t i) const { return bytes_[i]; }

 private:
  static constexpr unsigned kConstant = 1;
  static constexpr unsigned kVariable = 2;
  static constexpr int kUnset = -0x40000000;

  static constexpr unsigned page(Usage name) { return static_cast<std::uint32_t>(name) >> 16U; }
  static constexpr unsigned number_of(Usage name) {
    return static_cast<std::uint32_t>(name) & 0xFFFFU;
  }

  constexpr void put(unsigned byte) { bytes_[used_++] = static_cast<std::uint8_t>(byte & 0xFFU); }
  /// An item whose data has no sign. Bound: 4 bytes.
  constexpr void tell(unsigned prefix, unsigned data) {
    if (data <= 0xFFU) return item(prefix, data, 1);
    item(prefix, data, data <= 0xFFFFU ? 2 : 4);
  }
  /// An item whose data has one. Bound: 4 bytes.
  constexpr void tell_signed(unsigned prefix, int data) {
    const auto bits = static_cast<unsigned>(data);
    if (data >= -0x80 && data <= 0x7F) return item(prefix, bits, 1);
    item(prefix, bits, data >= -0x8000 && data <= 0x7FFF ? 2 : 4);
  }
  constexpr void item(unsigned prefix, unsigned data, int bytes) {
    put(prefix | (bytes == 4 ? 3U : static_cast<unsigned>(bytes)));
    for (int i = 0; i < bytes; ++i, data >>= 8U) put(data);  // Bound: 4
  }
  /// Says a global item, unless it holds already.
  constexpr void global(unsigned prefix, int& current, int wanted) {
    if (current == wanted) return;
    tell_signed(prefix, wanted);
    current = wanted;
  }
  constexpr void page_of(Usage name) {
    const auto wanted = static_cast<int>(page(name));
    global(0x04, page_, wanted);
  }
  constexpr void usage(Usage name) {
    page_of(name);
    tell(0x08, number_of(name));
  }
  constexpr void describe(const Number& number, std::size_t count) {
    global(0x14, low_, number.low);
    global(0x24, high_, number.high);
    global(0x34, physical_low_, number.physical_low);
    global(0x44, physical_high_, number.physical_high);
    global(0x64, unit_, number.unit);
    global(0x54, exponent_, number.exponent);
    global(0x74, size_, number.bits);
    global(0x94, count_, static_cast<int>(count));
  }

  std::array<std::uint8_t, kRoom> bytes_{};
  std::size_t used_ = 0;
  int page_ = kUnset;
  int low_ = kUnset;
  int high_ = kUnset;
  int physical_low_ = kUnset;
  int physical_high_ = kUnset;
  int unit_ = kUnset;
  int exponent_ = kUnset;
  int size_ = kUnset;
  int count_ = kUnset;
};

}  // namespace batuta::pid
