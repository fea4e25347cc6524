// SPDX-License-Identifier: MIT
#pragma once
// A list with room for N items and no more.

#include <array>
#include <cstddef>

#include "batuta/core/assert.hpp"

namespace batuta {

/// Up to N items in the order of their coming; what does not fit is refused, and the caller counts
/// it.
template <class T, int N>
class FixedList {
  static_assert(N >= 1, "FixedList: room for at least one item");

 public:
  /// What it holds.
  using value_type = T;
  /// Goes over the items in the order of their coming.
  using const_iterator = const T*;
  /// The same: items are changed by operator[].
  using iterator = const_iterator;
  static constexpr int kCapacity = N;  ///< N.

  /// Puts an item behind the last one. @returns false: the list is full, and nothing was changed
  bool push(const T& item) {
    if (size_ == N) return false;
    items_[static_cast<std::size_t>(size_)] = item;
    ++size_;
    return true;
  }
  /// Puts the last item in the place of item i. @pre 0 <= i < size()
  void remove_swapping(int i) {
    BATUTA_ASSERT(i >= 0 && i < size_);
    --size_;
    items_[static_cast<std::size_t>(i)] = items_[static_cast<std::size_t>(size_)];
  }
  /// Takes all items away.
  void clear() { size_ = 0; }
  /// Items in use, 0 ... N.
  int size() const { return size_; }
  /// Whether there is no item.
  bool empty() const { return size_ == 0; }
  /// The i-th item. @pre 0 <= i < size()
  T& operator[](int i) {
    BATUTA_ASSERT(i >= 0 && i < size_);
    return items_[static_cast<std::size_t>(i)];
  }
  /// The i-th item. @pre 0 <= i < size()
  const T& operator[](int i) const {
    BATUTA_ASSERT(i >= 0 && i < size_);
    return items_[static_cast<std::size_t>(i)];
  }
  /// What is in use. Bound: N items.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    size_ = ar.count(size_, N);
    const int shown = ar.shaping() ? 1 : size_;
    for (int i = 0; i < shown; ++i) ar(items_[static_cast<std::size_t>(i)]);  // Bound: N
  }
  /// The first item.
  const T* begin() const { return items_.data(); }
  /// Behind the last item in use.
  const T* end() const { return items_.data() + size_; }

 private:
  std::array<T, static_cast<std::size_t>(N)> items_{};
  int size_ = 0;
};

}  // namespace batuta
