// SPDX-License-Identifier: MIT
#pragma once
// The latest value from an interrupt handler to the program it interrupts: two slots and a count.
// One writer, which the reader cannot interrupt; one reader.

#include <array>
#include <atomic>
#include <cstdint>

namespace batuta::stm32f405 {

template <class T>
class Latest {
 public:
  /// By the interrupt handler.
  void put(const T& value) {
    const std::uint32_t next = count_.load(std::memory_order_relaxed) + 1U;
    slots_[next % 2U] = value;
    count_.store(next, std::memory_order_release);
  }

  /// Values put since the start, modulo 2^32.
  std::uint32_t count() const { return count_.load(std::memory_order_acquire); }

  /// The latest value, whole, or nothing where values keep coming in between.
  /// @returns the count that came with it, or 0
  /// Bound: kTries copies.
  std::uint32_t copy(T& value) const {
    for (int i = 0; i < kTries; ++i) {  // Bound: kTries
      const std::uint32_t before = count();
      if (before == 0) return 0;
      const T copied = slots_[before % 2U];
      std::atomic_signal_fence(std::memory_order_acq_rel);  // the copy before the second look
      if (count_.load(std::memory_order_acquire) != before) continue;  // put() came in between
      value = copied;
      return before;
    }
    return 0;
  }

 private:
  static constexpr int kTries = 3;

  std::array<T, 2> slots_{};
  std::atomic<std::uint32_t> count_{0};
};

}  // namespace batuta::stm32f405
