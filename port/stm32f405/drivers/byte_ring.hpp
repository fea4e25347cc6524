// SPDX-License-Identifier: MIT
#pragma once
// A ring of bytes between an interrupt handler and the program: one writer, one reader, no lock.

#include <array>
#include <atomic>
#include <cstdint>

namespace batuta::stm32f405 {

/// Holds kSize bytes. The counts run freely; their difference is what is inside.
template <std::uint32_t kSize>
class ByteRing {
  static_assert(kSize > 0 && (kSize & (kSize - 1U)) == 0, "ByteRing: a power of two");

 public:
  /// By the writer. @returns false: full, the byte is not taken
  bool push(std::uint8_t byte) {
    const std::uint32_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) == kSize) return false;
    bytes_[head % kSize] = byte;
    head_.store(head + 1U, std::memory_order_release);
    return true;
  }

  /// By the reader. @returns false: empty, `byte` unchanged
  bool pop(std::uint8_t& byte) {
    const std::uint32_t tail = tail_.load(std::memory_order_relaxed);
    if (head_.load(std::memory_order_acquire) == tail) return false;
    byte = bytes_[tail % kSize];
    tail_.store(tail + 1U, std::memory_order_release);
    return true;
  }

  bool empty() const {
    return head_.load(std::memory_order_acquire) == tail_.load(std::memory_order_acquire);
  }

 private:
  std::array<std::uint8_t, kSize> bytes_{};
  std::atomic<std::uint32_t> head_{0};
  std::atomic<std::uint32_t> tail_{0};
};

}  // namespace batuta::stm32f405
