// SPDX-License-Identifier: MIT
#pragma once
// Which bodies contacts join to one group, and which groups are held (src/world/world.md, "Contacts
// that last"). A forest: the root of a tree is the lowest body of its group.

#include "batuta/world/detail/bodies.hpp"

namespace batuta::detail {

template <class SceneT>
class BodyGroups {
 public:
  using Slot = std::uint16_t;

  /// Each body is a group of its own, and nothing is held. Bound: kMaxBodies.
  void clear();
  /// The lowest body of the group. Shortens the way there. Bound: kMaxBodies.
  std::size_t root_of(std::size_t slot);
  /// The groups of the two are one from now on.
  void join(std::size_t a, std::size_t b);
  /// Something that is led carries the body's group.
  void hold(std::size_t slot) { held_[root_of(slot)] = true; }
  /// Whether something that is led carries the group of which the body is the lowest.
  bool is_held(std::size_t lowest) const { return held_[lowest]; }

 private:
  static constexpr std::size_t kSlots = Bodies<SceneT>::kSlots;

  std::array<Slot, kSlots> root_{};
  std::array<bool, kSlots> held_{};  ///< of a root
};

template <class SceneT>
void BodyGroups<SceneT>::clear() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    root_[slot] = static_cast<Slot>(slot);
    held_[slot] = false;
  }
}

template <class SceneT>
std::size_t BodyGroups<SceneT>::root_of(std::size_t slot) {
  while (root_[slot] != slot) {  // Bound: kMaxBodies
    root_[slot] = root_[root_[slot]];
    slot = root_[slot];
  }
  return slot;
}

template <class SceneT>
void BodyGroups<SceneT>::join(std::size_t a, std::size_t b) {
  const std::size_t p = root_of(a);
  const std::size_t q = root_of(b);
  root_[max_of(p, q)] = static_cast<Slot>(min_of(p, q));
}

}  // namespace batuta::detail
