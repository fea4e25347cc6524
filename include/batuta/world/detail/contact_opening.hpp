// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: what opens gaps that are too narrow (src/world/world.md, "Opening"). Included by
// contact_groups.hpp.

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

/// Whether a contact that was solved is too narrow.
template <class SceneT>
bool ContactGroups<SceneT>::is_opening_needed() const {
  constexpr Scalar kNarrow = Scalar(0.4);  // of D
  bool is_needed = false;
  for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
    const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    for (int i = 0; i < contact.count; ++i) {  // Bound: 2
      const auto& point = contact.points[static_cast<std::size_t>(i)];
      const Scalar limit = point.normal > Scalar(0) ? kNarrow * contact.rest_gap : Scalar(0);
      is_needed = is_needed || point.gap < limit;
    }
  }
  return is_needed;
}

/// A velocity for one step that opens the gaps of contacts that press.
template <class SceneT>
void ContactGroups<SceneT>::open(BodiesT& bodies) {
  find_held(bodies);
  if (!is_opening_needed()) return;
  constexpr Scalar kShare = Scalar(0.5);      // of what is missing, in a step
  constexpr Scalar kEnough = Scalar(1) / 32;  // of D, in the step
  for (int s = 0; s < kOpeningSweeps; ++s) {  // Bound: kOpeningSweeps
    bool is_done = true;
    for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
      const int at = s % 2 == 0 ? k : solved_count_ - 1 - k;
      Contact& contact = contacts_[order_[static_cast<std::size_t>(at)]];
      const Scalar change = visit_opening(bodies, contact, kShare);
      is_done = is_done && !(change > kEnough * contact.rest_gap / bodies.dt);
    }
    if (is_done) return;
  }
}

/// In a group that something holds, what lies below counts as held while gaps are opened: its
/// opening lifts all that lies on it (world.md, "Opening").
template <class SceneT>
void ContactGroups<SceneT>::find_held(const BodiesT& bodies) {
  unite(bodies, false);
  for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
    Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    const std::size_t a = a_of(contact);
    const std::size_t b = b_of(contact);
    contact.is_held = held_[root_of(bodies.is_led(a) ? b : a)];
    if constexpr (SceneT::kGravity) {
      constexpr Scalar kUpright = Scalar(0.5);  // beside each other: neither is below
      const Scalar gravity = length(bodies.settings.gravity_W);
      const Scalar down = bodies.settings.gravity_W.dot(contact.points[0].normal_W);
      if (contact.is_held && std::abs(down) > kUpright * gravity) {
        contact.below = down > Scalar(0) ? 1 : 2;
      }
    }
  }
}

/// One contact, with the velocities that open gaps. @param share  of what is missing, in a step
template <class SceneT>
Scalar_of<SceneT> ContactGroups<SceneT>::visit_opening(BodiesT& bodies, Contact& contact,
                                                       Scalar share) {
  std::array<SolvedBody<Scalar>, 2> sides;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    const std::size_t slot = i == 0 ? a_of(contact) : b_of(contact);
    sides[i] = solved_[slot];
    sides[i].v_W = bodies.states[slot].opening.v_W;
    sides[i].w_W = bodies.states[slot].opening.w_W;
    if (contact.below == i + 1) sides[i].inverse_mass = 0;
    if (contact.below == i + 1 || !contact.is_held) sides[i].inverse_inertia_W.setZero();
  }
  const Scalar change = relax_opening(contact, sides[0], sides[1], bodies.dt, share);
  if (!(change > Scalar(0))) return change;
  bodies.states[a_of(contact)].opening = {sides[0].v_W, sides[0].w_W};
  bodies.states[b_of(contact)].opening = {sides[1].v_W, sides[1].w_W};
  return change;
}

}  // namespace batuta::detail
