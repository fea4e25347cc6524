// SPDX-License-Identifier: MIT
#pragma once
// A name for an object in a Pool: passed by value, never dangling. All bits zero is the null
// handle.

#include <cstdint>

namespace batuta {

/// @tparam T  what the handle names; handles of different types do not mix.
template <class T>
struct Handle {
  std::uint16_t index1 = 0;  ///< slot + 1; 0 for the null handle
  std::uint16_t pool = 0;  ///< the number its pool was given, so that a foreign handle is detected
  std::uint32_t generation =
      0;  ///< that of the slot when the object was made; never 0 for an object

  constexpr bool is_null() const { return index1 == 0; }
  friend constexpr bool operator==(Handle a, Handle b) {
    return a.index1 == b.index1 && a.pool == b.pool && a.generation == b.generation;
  }
  friend constexpr bool operator!=(Handle a, Handle b) { return !(a == b); }
};

}  // namespace batuta
