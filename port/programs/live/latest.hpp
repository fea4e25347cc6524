// SPDX-License-Identifier: MIT
#pragma once
// The latest value from one thread to another. Neither waits for the other: of three places, one is
// being written, one is being read, and the third lies between the two and is exchanged.

#include <array>
#include <atomic>

namespace batuta::host {

/// For exactly one thread that puts and one that takes. T is copied. Allocates: never.
template <class T>
class Latest {
 public:
  /// What was put before and has not been taken is overwritten. Bound: no loop.
  void put(const T& value) {
    places_[writing_] = value;
    writing_ = between_.exchange(writing_ | kFresh, std::memory_order_acq_rel) & kPlace;
  }

  /// @returns whether something was put since the last call; if not, `value` is unchanged.
  /// Bound: no loop.
  bool take(T& value) {
    if ((between_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    reading_ = between_.exchange(reading_, std::memory_order_acq_rel) & kPlace;
    value = places_[reading_];
    return true;
  }

 private:
  static constexpr unsigned kPlace = 3;
  static constexpr unsigned kFresh = 4;

  std::array<T, 3> places_{};
  unsigned writing_ = 0;
  std::atomic<unsigned> between_{1};
  unsigned reading_ = 2;
};

}  // namespace batuta::host
