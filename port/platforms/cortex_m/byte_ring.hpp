// SPDX-License-Identifier: MIT
#pragma once
// Bytes from one writer to one reader, of which one may be an interrupt handler. No lock: each side
// writes its own index only, and a byte is stored before the index that publishes it.

#include <array>
#include <atomic>
#include <cstdint>

namespace batuta::cortex_m {

/// Holds up to `Capacity` bytes. @tparam Capacity  a power of two, at most 2^15
template <std::uint16_t Capacity>
class ByteRing {
  static_assert(Capacity > 0 && Capacity <= 0x8000 && (Capacity & (Capacity - 1)) == 0,
                "ByteRing: choose a power of two");

 public:
  /// The writer's. @returns false where it is full: the byte was not taken
  bool push(std::uint8_t byte) {
    const std::uint16_t end = end_.load(std::memory_order_relaxed);
    const std::uint16_t begin = begin_.load(std::memory_order_acquire);
    if (static_cast<std::uint16_t>(end - begin) == Capacity) return false;
    bytes_[end % Capacity] = byte;
    end_.store(static_cast<std::uint16_t>(end + 1), std::memory_order_release);
    return true;
  }

  /// The reader's. @returns false where it is empty: `byte` unchanged
  bool pop(std::uint8_t& byte) {
    const std::uint16_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return false;
    byte = bytes_[begin % Capacity];
    begin_.store(static_cast<std::uint16_t>(begin + 1), std::memory_order_release);
    return true;
  }

  /// By either side; the other may be about to change it.
  bool empty() const {
    return begin_.load(std::memory_order_acquire) == end_.load(std::memory_order_acquire);
  }

 private:
  std::array<std::uint8_t, Capacity> bytes_{};
  std::atomic<std::uint16_t> begin_{0};  ///< counts bytes read, modulo 2^16
  std::atomic<std::uint16_t> end_{0};    ///< counts bytes written, modulo 2^16
};

}  // namespace batuta::cortex_m
