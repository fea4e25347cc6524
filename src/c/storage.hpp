// SPDX-License-Identifier: MIT
#pragma once
// Objects of the library in storage of a C program's. Each begins with a mark, so that storage in
// which nothing was made, or another kind of object, is told by a status.

#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>

namespace batuta::detail {

/// Whether an object may be placed into storage.
template <class T>
bool has_room(const void* storage, std::size_t bytes) {
  return storage != nullptr && bytes >= sizeof(T) &&
         reinterpret_cast<std::uintptr_t>(storage) % alignof(T) == 0;
}

/// Whether a type of batuta/c.h is storage for a T, and the next larger one in steps of 1 kB.
template <class T, class Storage>
constexpr bool holds_closely() {
  constexpr std::size_t kStep = 1024;
  return sizeof(T) <= sizeof(Storage) && sizeof(Storage) - sizeof(T) < kStep &&
         alignof(T) <= alignof(Storage);
}

/// Makes an object in storage that has_room().
/// @tparam T  its first member is `mark`, T::kMark
template <class T>
T* make_in(void* storage) {
  static_assert(std::is_trivially_destructible_v<T>, "storage of C is left without a word");
  ::new (storage) T;  // deviation: placement-new
  return std::launder(static_cast<T*>(storage));
}

/// The object that make_in() has put into storage; null: there is none.
/// @param storage  sizeof(T) bytes, or null
template <class T>
const T* found_in(const void* storage) {
  if (!has_room<T>(storage, sizeof(T))) return nullptr;
  std::uint32_t mark = 0;
  std::memcpy(&mark, storage, sizeof mark);
  return mark == T::kMark ? std::launder(static_cast<const T*>(storage)) : nullptr;
}
/// The same, to be changed.
template <class T>
T* found_in(void* storage) {
  return const_cast<T*>(found_in<T>(static_cast<const void*>(storage)));
}

}  // namespace batuta::detail
