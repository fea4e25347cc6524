// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: what opens gaps that are too narrow (src/world/world.md, "Opening"). Included by
// contact_groups.hpp.

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

/// Whether a contact that was solved is too narrow.
template <class SceneT>
bool is_opening_needed(const ContactGroups<SceneT>& groups) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kNarrow = Scalar(0.4);  // of D
  bool is_needed = false;
  for (int k = 0; k < groups.solved_count; ++k) {  // Bound: kMaxContacts
    const auto& contact = groups.solved_at(k);
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
void open_gaps(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  using Scalar = Scalar_of<SceneT>;
  find_held(bodies, groups);
  if (!is_opening_needed(groups)) return;
  constexpr int kOpeningSweeps = 8;
  constexpr Scalar kShare = Scalar(0.5);      // of what is missing, in a step
  constexpr Scalar kEnough = Scalar(1) / 32;  // of D, in the step
  for (int s = 0; s < kOpeningSweeps; ++s) {  // Bound: kOpeningSweeps
    bool is_done = true;
    for (int k = 0; k < groups.solved_count; ++k) {  // Bound: kMaxContacts
      const int at = s % 2 == 0 ? k : groups.solved_count - 1 - k;
      auto& contact = groups.solved_at(at);
      const Scalar change = visit_opening(bodies, groups, contact, kShare);
      is_done = is_done && !(change > kEnough * contact.rest_gap / bodies.dt);
    }
    if (is_done) return;
  }
}

/// In a group that something holds, what lies below counts as held while gaps are opened: its
/// opening lifts all that lies on it (world.md, "Opening").
template <class SceneT>
void find_held(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  join_all(bodies, groups, false);
  for (int k = 0; k < groups.solved_count; ++k) {  // Bound: kMaxContacts
    auto& contact = groups.solved_at(k);
    contact.is_held = groups.joined.is_held(root_of(bodies, groups, contact));
    if constexpr (SceneT::kGravity) {
      using Scalar = Scalar_of<SceneT>;
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
Scalar_of<SceneT> visit_opening(Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
                                LastingContactOf<SceneT>& contact, Scalar_of<SceneT> share) {
  using Scalar = Scalar_of<SceneT>;
  std::array<SolvedBody<Scalar>, 2> sides;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    const std::size_t slot = i == 0 ? a_of<SceneT>(contact) : b_of<SceneT>(contact);
    sides[i] = groups.solved[slot];
    sides[i].v_W = bodies.states[slot].opening.v_W;
    sides[i].w_W = bodies.states[slot].opening.w_W;
    if (contact.below == i + 1) sides[i].inverse_mass = 0;
    if (contact.below == i + 1 || !contact.is_held) sides[i].inverse_inertia_W.setZero();
  }
  const Scalar change = relax_opening(contact, sides[0], sides[1], bodies.dt, share);
  if (!(change > Scalar(0))) return change;
  bodies.states[a_of<SceneT>(contact)].opening = {sides[0].v_W, sides[0].w_W};
  bodies.states[b_of<SceneT>(contact)].opening = {sides[1].v_W, sides[1].w_W};
  return change;
}

}  // namespace batuta::detail
