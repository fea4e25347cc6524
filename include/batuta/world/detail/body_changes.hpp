// SPDX-License-Identifier: MIT
#pragma once
// By how much visits to contacts have changed bodies, so that a contact is visited again only where
// that matters to it; and who was changed by blows (src/world/world.md, "Blows").

#include "batuta/core/fixed_list.hpp"
#include "batuta/world/detail/bodies.hpp"

namespace batuta::detail {

template <class SceneT>
class BodyChanges {
 public:
  using Scalar = Scalar_of<SceneT>;
  using Slot = std::uint16_t;

  /// Nothing has changed, and no contact was looked at.
  void clear();
  /// Something else than a visit has changed the body.
  void notice(std::size_t slot) { changed[slot] += kNoticed; }
  /// The same, by a blow. @pre it is not dirty yet
  void mark(std::size_t slot) {
    is_dirty[slot] = true;
    notice(slot);
    dirty.push(static_cast<Slot>(slot));
  }

 private:
  static constexpr std::size_t kSlots = Bodies<SceneT>::kSlots;
  static constexpr auto kContacts = static_cast<std::size_t>(SceneT::kMaxContacts);
  /// Added to what visits changed of a body where something else changed it, m/s.
  static constexpr Scalar kNoticed = 1;

 public:
  std::array<Scalar, kSlots> changed{};  ///< sum of what visits changed of a body, m/s
  /// Of both bodies of a contact together, when it was visited last.
  std::array<Scalar, kContacts> seen{};
  FixedList<Slot, SceneT::kMaxBodies> dirty;  ///< bodies that blows have changed
  std::array<bool, kSlots> is_dirty{};
  std::array<bool, kContacts> is_struck{};  ///< contacts
};

template <class SceneT>
void BodyChanges<SceneT>::clear() {
  dirty.clear();
  is_dirty.fill(false);
  is_struck.fill(false);
  changed.fill(0);
  seen.fill(0);
}

}  // namespace batuta::detail
