// SPDX-License-Identifier: MIT
#pragma once
// The fields of a message, one after the other, least significant byte first. One object reads or
// writes, by the same calls: a message's layout and ranges are written down once, for both ways.
// The first field that does not fit or is out of its range spoils the whole message.

#include <array>
#include <cstddef>
#include <cstdint>

namespace batuta::link {

/// Reads or writes the fields of one message. Every call: constant time. Allocates: never.
class Fields {
 public:
  /// Takes the fields from `bytes`. @pre it holds `size` bytes, size >= 0
  static Fields reader(const std::uint8_t* bytes, int size) { return {bytes, nullptr, size}; }
  /// Puts the fields into `bytes`. @pre it has room for `size` bytes
  static Fields writer(std::uint8_t* bytes, int size) { return {nullptr, bytes, size}; }

  void u8(std::uint8_t& value);
  void u16(std::uint16_t& value);
  void u32(std::uint32_t& value);
  /// The bits of an IEEE 754 binary32: any finite value.
  void real(float& value);
  /// The same from low to high.
  void real(float& value, float low, float high);
  template <std::size_t N>
  void reals(std::array<float, N>& values) {
    for (float& value : values) real(value);  // Bound: N
  }
  template <std::size_t N>
  void reals(std::array<float, N>& values, float low, float high) {
    for (float& value : values) real(value, low, high);  // Bound: N
  }
  /// Bit i of a byte is flag i; the bits without a flag are zero.
  template <class... Flags>
  void flags(Flags&... flag) {
    static_assert(sizeof...(Flags) <= 8, "flags: one byte");
    std::uint8_t byte = packed(flag...);
    u8(byte);
    require(byte < (1U << sizeof...(Flags)));
    ((flag = take_bit(byte)), ...);
  }
  /// An enumeration or a number, 0 ... limit - 1, in a byte.
  template <class Choice>
  void choice(Choice& value, int limit) {
    auto byte = static_cast<std::uint8_t>(value);
    u8(byte);
    require(byte < limit);
    value = static_cast<Choice>(byte);
  }

  /// What the range of a single field cannot say.
  void require(bool condition) { good_ = good_ && condition; }

  /// Every field was there and in its range.
  bool good() const { return good_; }
  /// Bytes read or written so far.
  int position() const { return position_; }

 private:
  Fields(const std::uint8_t* source, std::uint8_t* target, int size)
      : source_(source), target_(target), size_(size) {}

  template <class... Flags>
  static std::uint8_t packed(const Flags&... flag) {
    unsigned byte = 0;
    unsigned bit = 0;
    ((byte |= static_cast<unsigned>(flag ? 1U : 0U) << bit++), ...);
    return static_cast<std::uint8_t>(byte);
  }
  /// The lowest bit, which is then gone.
  static bool take_bit(std::uint8_t& byte) {
    const bool bit = byte % 2U != 0;
    byte = static_cast<std::uint8_t>(byte >> 1U);
    return bit;
  }
  std::uint32_t move(std::uint32_t value, int count);

  const std::uint8_t* source_;  ///< null: writing
  std::uint8_t* target_;        ///< null: reading
  int size_;
  int position_ = 0;
  bool good_ = true;
};

}  // namespace batuta::link
