// SPDX-License-Identifier: MIT
#pragma once
// A name for an object in a Pool: passed by value, never dangling. All bits zero is the null
// handle.

#include <cstdint>

#include "batuta/core/assert.hpp"

namespace batuta {

/// The name of an object in a Pool. It stays valid where the object is, and is found out where the
/// object is gone.
/// @tparam T  what the handle names; handles of different types do not mix.
template <class T>
struct Handle {
  std::uint16_t index1 = 0;  ///< slot + 1; 0 for the null handle
  std::uint16_t pool = 0;  ///< the number its pool was given, so that a foreign handle is detected
  /// That of the slot when the object was made; never 0 for an object
  std::uint32_t generation = 0;

  /// Whether it names nothing, as one that was never set.
  constexpr bool is_null() const { return index1 == 0; }
  /// Whether both name the same object.
  friend constexpr bool operator==(Handle a, Handle b) {
    return a.index1 == b.index1 && a.pool == b.pool && a.generation == b.generation;
  }
  /// Whether they name different objects.
  friend constexpr bool operator!=(Handle a, Handle b) { return !(a == b); }
};

}  // namespace batuta
