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

/// How far what opens the gaps of a contact may take a body in what is left of a step, m: kFar of
/// D, and as far as the two are in each other. Between two that give way to each other there would
/// be no end to it.
template <class Traits>
typename Traits::Scalar furthest_way(const LastingContact<Traits>& contact) {
  using Scalar = typename Traits::Scalar;
  constexpr Scalar kFar = 8;
  return kFar * contact.rest_gap + max_of(Scalar(0), -least_gap(contact));
}

/// Whether an opening would take a body further than that, and further than what it is now.
template <class SceneT>
bool goes_too_far(const Bodies<SceneT>& bodies, std::size_t slot,
                  const Twist<Scalar_of<SceneT>>& opening, Scalar_of<SceneT> furthest) {
  const auto& actor = bodies.actor(slot);
  const auto now = most_speed(actor, bodies.states[slot].opening);
  const auto next = most_speed(actor, opening);
  return next > now && !(next * (bodies.dt - bodies.now) < furthest);
}

/// One contact, with the velocities that open gaps. What would take one of the two too far is left
/// out; and where nothing holds them, all that only one of the two would follow: the common centre
/// stays. @param share  of what is missing, in a step
template <class SceneT>
Scalar_of<SceneT> visit_opening(Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
                                LastingContactOf<SceneT>& contact, Scalar_of<SceneT> share) {
  using Scalar = Scalar_of<SceneT>;
  std::array<SolvedBody<Scalar>, 2> sides;
  const std::array<std::size_t, 2> slots = {a_of<SceneT>(contact), b_of<SceneT>(contact)};
  const bool both = bodies.states[slots[0]].is_opened && bodies.states[slots[1]].is_opened;
  if (!both && !contact.is_held) return Scalar(0);
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    sides[i] = groups.solved[slots[i]];
    sides[i].v_W = bodies.states[slots[i]].opening.v_W;
    sides[i].w_W = bodies.states[slots[i]].opening.w_W;
    const bool stays = contact.below == i + 1 || !bodies.states[slots[i]].is_opened;
    if (stays) sides[i].inverse_mass = 0;
    if (stays || !contact.is_held) sides[i].inverse_inertia_W.setZero();
  }
  constexpr std::size_t kPoints = LastingContactOf<SceneT>::kPoints;
  std::array<Scalar, kPoints> before;
  for (std::size_t k = 0; k < kPoints; ++k) {  // Bound: 2
    before[k] = contact.points[k].opening;
  }
  const Scalar change = relax_opening(contact, sides[0], sides[1], bodies.dt, share);
  if (!(change > Scalar(0))) return change;
  const Twist<Scalar> A = {sides[0].v_W, sides[0].w_W};
  const Twist<Scalar> B = {sides[1].v_W, sides[1].w_W};
  const Scalar furthest = furthest_way(contact);
  if (goes_too_far(bodies, slots[0], A, furthest) || goes_too_far(bodies, slots[1], B, furthest)) {
    for (std::size_t k = 0; k < kPoints; ++k) {  // Bound: 2
      contact.points[k].opening = before[k];
    }
    return Scalar(0);
  }
  bodies.states[slots[0]].opening = A;
  bodies.states[slots[1]].opening = B;
  for (const std::size_t slot : slots) {  // Bound: 2
    bodies.states[slot].is_held = bodies.states[slot].is_held || contact.is_held;
  }
  return change;
}

}  // namespace batuta::detail
