// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"

#include <limits>

#include "lowest_bit.hpp"

namespace batuta {
namespace {

constexpr std::uint32_t kLastGeneration = std::numeric_limits<std::uint32_t>::max();

}  // namespace

int detail::PoolBase::find(std::uint16_t index1, std::uint16_t pool,
                           std::uint32_t generation) const {
  if (index1 == 0 || pool != number_) return kNoIndex;
  const std::size_t index = index1 - std::size_t{1};
  if (!is_live(index) || generations_[index] != generation) return kNoIndex;
  return static_cast<int>(index);
}

int detail::PoolBase::acquire() {
  for (std::size_t i = 0; i < capacity_; ++i) {  // Bound: N
    if (is_live(i) || generations_[i] == kLastGeneration) continue;
    ++generations_[i];
    live_[i / kBitsPerWord] |= bit_of(i);
    ++size_;
    return static_cast<int>(i);
  }
  return kNoIndex;
}

void detail::PoolBase::release(std::size_t index) {
  live_[index / kBitsPerWord] &= ~bit_of(index);
  --size_;
  if (generations_[index] == kLastGeneration) ++retired_;
}

void detail::PoolBase::copy_slots(const detail::PoolBase& other) {
  const std::size_t words = words_for(capacity_);
  // Bound: N.
  for (std::size_t i = 0; i < capacity_; ++i) generations_[i] = other.generations_[i];
  // Bound: N / 32.
  for (std::size_t word = 0; word < words; ++word) live_[word] = other.live_[word];
  size_ = other.size_;
  retired_ = other.retired_;
  number_ = other.number_;
}

bool detail::PoolBase::settle() {
  const std::size_t words = words_for(capacity_);
  bool good = true;
  size_ = 0;
  retired_ = 0;
  for (std::size_t i = 0; i < words * kBitsPerWord; ++i) {  // Bound: N, up to the end of its word
    std::uint32_t& word = live_[i / kBitsPerWord];
    const bool used = (word & bit_of(i)) != 0;
    if (used && (i >= capacity_ || generations_[i] == 0)) {
      word &= ~bit_of(i);
      good = false;
    } else if (used) {
      ++size_;
    } else if (i < capacity_ && generations_[i] == kLastGeneration) {
      ++retired_;
    }
  }
  return good;
}

std::size_t detail::PoolBase::next_live(std::size_t index) const {
  if (index >= capacity_) return capacity_;
  std::size_t word = index / kBitsPerWord;
  std::uint32_t bits = live_[word] & ~(bit_of(index) - 1U);
  const std::size_t words = words_for(capacity_);
  while (bits == 0 && ++word < words) bits = live_[word];  // Bound: N / 32
  return bits == 0 ? capacity_ : word * kBitsPerWord + detail::lowest_bit(bits);
}

void detail::PoolBase::clear() {
  for (std::size_t i = next_live(0); i < capacity_; i = next_live(i + 1)) release(i);  // Bound: N
}

}  // namespace batuta
