// SPDX-License-Identifier: MIT
#include "batuta/record/archive.hpp"

namespace batuta {
namespace {

constexpr std::uint64_t kFnvPrime = 1099511628211U;
constexpr std::uint32_t kChoice = 0x100;
constexpr std::uint32_t kReal = 0x20;
constexpr std::uint32_t kCount = 0x30;
constexpr std::uint32_t kNan = 0x7fc00000U;
constexpr std::uint64_t kLongNan = 0x7ff8000000000000U;
/// 2^30: 256 products of four are less than the largest float, 2^128.
constexpr float kLargestSane = 1 << 30;
constexpr float kUnitWithin = 1.0F / 512;  // of a squared length

static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559,
              "archive: floating-point numbers are the bits of IEEE 754");

}  // namespace

void Archive::mix(std::uint8_t byte) {
  digest_ = (digest_ ^ byte) * kFnvPrime;
}

void Archive::shape(std::uint32_t code) {
  for (unsigned shift = 0; shift < 32; shift += 8) {  // Bound: 4
    mix(static_cast<std::uint8_t>(code >> shift));
  }
}

std::uint32_t Archive::move(std::uint32_t value, int width) {
  if (!ok()) return value;
  const bool bounded = way_ == Way::kRead || way_ == Way::kWrite;
  if (bounded && size_ - position_ < width) {
    status_ = reading() ? Status::kInvalidArgument : Status::kPoolFull;
    return value;
  }
  std::uint32_t moved = 0;
  for (int i = 0; i < width; ++i) {  // Bound: 4
    const auto shift = static_cast<unsigned>(8 * i);
    auto byte = static_cast<std::uint8_t>(value >> shift);
    if (way_ == Way::kRead) byte = source_[position_];
    if (way_ == Way::kWrite) target_[position_] = byte;
    if (way_ == Way::kHash) mix(byte);
    moved |= std::uint32_t{byte} << shift;
    ++position_;
  }
  return moved;
}

/// Both halves or neither.
std::uint64_t Archive::move_long(std::uint64_t value) {
  const std::uint32_t low = move(static_cast<std::uint32_t>(value), 4);
  const std::uint32_t high = move(static_cast<std::uint32_t>(value >> 32U), 4);
  return ok() ? std::uint64_t{high} << 32U | low : value;
}

int Archive::count(int used, int room) {
  if (shaping()) {
    shape(kCount);
    shape(static_cast<std::uint32_t>(room));
    return used;
  }
  constexpr int kMostInByte = 255;
  const std::uint32_t moved = move(static_cast<std::uint32_t>(used), room > kMostInByte ? 4 : 1);
  if (ok() && moved > static_cast<std::uint32_t>(room)) status_ = Status::kInvalidArgument;
  return ok() ? static_cast<int>(moved) : used;
}

/// What a reader would refuse is not written either.
void Archive::choice(std::uint8_t& value, std::uint8_t last) {
  if (shaping()) return shape(kChoice + last);
  const auto moved = static_cast<std::uint8_t>(move(value, 1));
  if (ok() && moved > last) status_ = Status::kInvalidArgument;
  if (ok()) value = moved;
}

void Archive::note_quaternion(float squared_length) {
  all_sane_ = all_sane_ && std::abs(squared_length - 1) <= kUnitWithin;
}

// The sign and the payload of a NaN are left open by IEEE 754: all of them are one here. A number
// is only stored where it is read, for a processor may change a NaN that it copies.
void Archive::real(float& x) {
  if (shaping()) {
    scalar_size_ = sizeof x;
    return shape(kReal + sizeof x);
  }
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  bits = move(x == x ? bits : kNan, sizeof x);
  float moved = 0;
  std::memcpy(&moved, &bits, sizeof moved);
  all_sane_ = all_sane_ && std::abs(moved) <= kLargestSane;
  if (reading() && ok()) x = moved;
}

void Archive::real(double& x) {
  if (shaping()) {
    scalar_size_ = sizeof x;
    return shape(kReal + sizeof x);
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  bits = move_long(x == x ? bits : kLongNan);
  double moved = 0;
  std::memcpy(&moved, &bits, sizeof moved);
  all_sane_ = all_sane_ && std::abs(moved) <= static_cast<double>(kLargestSane);
  if (reading() && ok()) x = moved;
}

}  // namespace batuta
