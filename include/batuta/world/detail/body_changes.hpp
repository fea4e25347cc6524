// SPDX-License-Identifier: MIT
#pragma once
// By how much visits to contacts have changed bodies, so that a contact is visited again only where
// that matters to it; and who was changed by blows (src/world/world.md, "Blows").

#include <limits>

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
  /// A blow has changed the body. @pre it is not dirty yet
  void mark(std::size_t slot) {
    is_dirty[slot] = true;
    dirty.push(static_cast<Slot>(slot));
  }

 private:
  static constexpr std::size_t kSlots = Bodies<SceneT>::kSlots;
  static constexpr auto kContacts = static_cast<std::size_t>(SceneT::kMaxContacts);

 public:
  /// Of a contact that is to be looked at, whatever its bodies have changed by.
  static constexpr Scalar kNever = -std::numeric_limits<Scalar>::max();

  std::array<Scalar, kSlots> changed{};  ///< sum of what visits changed of a body, m/s
  /// Of both bodies of a contact together, when it was visited last; or kNever.
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
  seen.fill(kNever);
}

}  // namespace batuta::detail
