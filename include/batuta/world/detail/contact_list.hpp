// SPDX-License-Identifier: MIT
#pragma once
// Contacts that last, as a list; and those of each body, as a chain through it. What is done with
// them: contact_groups.hpp.

#include "batuta/core/fixed_list.hpp"
#include "batuta/world/detail/bodies.hpp"
#include "batuta/world/detail/lasting_contact.hpp"

namespace batuta::detail {

/// What the contacts of a scene are made of, and one of them.
template <class SceneT>
using ContactTraitsOf = ContactTraits<Scalar_of<SceneT>, SceneT::kFriction,
                                      SceneT::kRollingResistance, SceneT::kLineContact>;
template <class SceneT>
using LastingContactOf = LastingContact<ContactTraitsOf<SceneT>>;

/// The bodies of a contact.
template <class SceneT>
std::size_t a_of(const LastingContactOf<SceneT>& contact) {
  return Proxies<SceneT>::body_of(contact.pair.first);
}
template <class SceneT>
std::size_t b_of(const LastingContactOf<SceneT>& contact) {
  return Proxies<SceneT>::body_of(contact.pair.second);
}

/// How far from the middle of a gap towards A the points of a contact lie, in gaps. Where one of
/// the two is led they lie on the other: what turns it there is its own radius (world.md, "Where").
template <class SceneT>
Scalar_of<SceneT> off_middle(const Bodies<SceneT>& bodies, std::size_t a, std::size_t b) {
  using Scalar = Scalar_of<SceneT>;
  if (bodies.is_led(b)) return Scalar(1) / 2;
  return bodies.is_led(a) ? Scalar(-1) / 2 : Scalar(0);
}

/// Whether a contact presses.
template <class Traits>
bool is_loaded(const LastingContact<Traits>& contact) {
  using Scalar = typename Traits::Scalar;
  return contact.points.front().normal > Scalar(0) ||
         (contact.count > 1 && contact.points.back().normal > Scalar(0));
}

template <class SceneT>
class ContactList {
 public:
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  using Contact = LastingContactOf<SceneT>;
  using Slot = std::uint16_t;
  static constexpr int kNone = -1;

  int size() const { return contacts_.size(); }
  Contact& operator[](int i) { return contacts_[i]; }
  const Contact& operator[](int i) const { return contacts_[i]; }
  /// The first contact of a body, or kNone.
  int first_of(std::size_t slot) const { return first_of_[slot] - 1; }
  /// The one that follows contact i among those of a body, or kNone. @pre it is one of the body's
  int next_of(int i, std::size_t slot) const {
    return next_[static_cast<std::size_t>(i)][a_of<SceneT>(contacts_[i]) == slot ? 0 : 1] - 1;
  }
  /// The contact of a pair, or kNone. Bound: the contacts of one body.
  int find(ProxyPair pair) const;
  /// The same; a new one where there is none yet. kNone: there is no room.
  int find_or_add(ProxyPair pair);
  /// Forgets the contacts of which is_out(contact) says so, from the last one on.
  /// Bound: kMaxContacts.
  template <class IsOut>
  void remove_if(const IsOut& is_out);
  /// Calls found(other body) for all that a body is near. Bound: its contacts.
  template <class Found>
  void for_each_neighbour(std::size_t slot, const Found& found) const;
  /// The largest D of a body's contacts, m; 0: it has none. Bound: its contacts.
  Scalar widest_rest_gap(std::size_t slot) const;
  /// Whether contacts that were solved lead from the body to something that is led. Bound: its
  /// contacts.
  bool is_held_up(std::size_t slot) const;
  /// Reads no contact of a body that is not there.
  template <class Archive>
  void archive(Archive& ar, const BodiesT& bodies);

 private:
  void link_all();
  void link(int i);

  FixedList<Contact, SceneT::kMaxContacts> contacts_;
  std::array<Slot, BodiesT::kSlots> first_of_{};  ///< of a body's contacts, + 1; 0: none
  /// Behind a contact, among those of its first and of its second body, + 1; 0: none.
  std::array<std::array<Slot, 2>, static_cast<std::size_t>(SceneT::kMaxContacts)> next_{};
};

template <class SceneT>
int ContactList<SceneT>::find(ProxyPair pair) const {
  const std::size_t a = BodiesT::body_of(pair.first);
  int i = first_of(a);
  while (i != kNone && !is_same(contacts_[i].pair, pair)) i = next_of(i, a);  // Bound: as it says
  return i;
}

template <class SceneT>
int ContactList<SceneT>::find_or_add(ProxyPair pair) {
  int i = find(pair);
  if (i != kNone) return i;
  Contact contact;
  contact.pair = pair;
  if (!contacts_.push(contact)) return kNone;
  i = contacts_.size() - 1;
  link(i);
  return i;
}

template <class SceneT>
template <class Found>
void ContactList<SceneT>::for_each_neighbour(std::size_t slot, const Found& found) const {
  for (int i = first_of(slot); i != kNone; i = next_of(i, slot)) {  // Bound: the contacts of a body
    const Contact& contact = contacts_[i];
    found(a_of<SceneT>(contact) == slot ? b_of<SceneT>(contact) : a_of<SceneT>(contact));
  }
}

template <class SceneT>
Scalar_of<SceneT> ContactList<SceneT>::widest_rest_gap(std::size_t slot) const {
  Scalar widest = 0;
  for (int i = first_of(slot); i != kNone; i = next_of(i, slot)) {  // Bound: the contacts of a body
    widest = max_of(widest, contacts_[i].rest_gap);
  }
  return widest;
}

template <class SceneT>
bool ContactList<SceneT>::is_held_up(std::size_t slot) const {
  bool is_held = false;
  for (int i = first_of(slot); i != kNone; i = next_of(i, slot)) {  // Bound: the contacts of a body
    const Contact& contact = contacts_[i];
    is_held = is_held || (contact.is_solved && contact.is_held);
  }
  return is_held;
}

template <class SceneT>
template <class IsOut>
void ContactList<SceneT>::remove_if(const IsOut& is_out) {
  for (int i = contacts_.size() - 1; i >= 0; --i) {  // Bound: kMaxContacts
    if (is_out(contacts_[i])) contacts_.remove_swapping(i);
  }
  link_all();
}

template <class SceneT>
template <class Archive>
void ContactList<SceneT>::archive(Archive& ar, const BodiesT& bodies) {
  ar(contacts_);
  if (!ar.reading()) return;
  remove_if([&](const Contact& contact) {
    const bool good = contact.count <= Contact::kPoints && bodies.has_bodies(contact.pair);
    ar.require(good);
    return !good;
  });
}

template <class SceneT>
void ContactList<SceneT>::link(int i) {
  const Contact& contact = contacts_[i];
  auto& next = next_[static_cast<std::size_t>(i)];
  next = {first_of_[a_of<SceneT>(contact)], first_of_[b_of<SceneT>(contact)]};
  first_of_[a_of<SceneT>(contact)] = first_of_[b_of<SceneT>(contact)] = static_cast<Slot>(i + 1);
}

template <class SceneT>
void ContactList<SceneT>::link_all() {
  first_of_.fill(0);
  for (int i = 0; i < contacts_.size(); ++i) link(i);  // Bound: kMaxContacts
}

}  // namespace batuta::detail
