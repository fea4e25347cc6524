// SPDX-License-Identifier: MIT

#include "shared/link/fields.hpp"

#include <cstring>
#include <limits>

namespace batuta::link {
namespace {

static_assert(sizeof(float) == sizeof(std::uint32_t) && std::numeric_limits<float>::is_iec559,
              "a float on the wire is the 32 bits of IEEE 754");

// memcpy is the language's way to see the bits of one number; structures are never copied so.
std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

float from_bits(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::uint32_t read_bytes(const std::uint8_t* bytes, int count) {
  std::uint32_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = (value << 8U) | bytes[i];  // Bound: 4
  return value;
}

void write_bytes(std::uint32_t value, std::uint8_t* bytes, int count) {
  for (int i = 0; i < count; ++i, value >>= 8U) {  // Bound: 4
    bytes[i] = static_cast<std::uint8_t>(value & 0xFFU);
  }
}

}  // namespace

/// Writes `count` bytes of the value, or reads as many and returns what they say.
std::uint32_t Fields::move(std::uint32_t value, int count) {
  require(size_ - position_ >= count);
  if (!good_) return value;
  const int at = position_;
  position_ += count;
  if (source_ != nullptr) return read_bytes(source_ + at, count);
  write_bytes(value, target_ + at, count);
  return value;
}

void Fields::u8(std::uint8_t& value) {
  value = static_cast<std::uint8_t>(move(value, 1));
}

void Fields::u16(std::uint16_t& value) {
  value = static_cast<std::uint16_t>(move(value, 2));
}

void Fields::u32(std::uint32_t& value) {
  value = move(value, 4);
}

void Fields::real(float& value) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  real(value, -kLargest, kLargest);
}

void Fields::real(float& value, float low, float high) {
  value = from_bits(move(bits_of(value), 4));
  require(value >= low && value <= high);  // false for a NaN
}

}  // namespace batuta::link
