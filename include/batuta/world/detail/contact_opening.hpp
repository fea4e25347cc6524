// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: what opens gaps that are too narrow (src/world/world.md, "Opening"). Included by
// contact_groups.hpp.

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

/// Whether a contact is too narrow.
template <class Traits>
bool is_narrow(const LastingContact<Traits>& contact) {
  using Scalar = typename Traits::Scalar;
  constexpr Scalar kNarrow = Scalar(0.4);  // of D
  bool is_one = false;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar limit = point.normal > Scalar(0) ? kNarrow * contact.rest_gap : Scalar(0);
    is_one = is_one || point.gap < limit;
  }
  return is_one;
}

/// Whether one of those that were solved is.
template <class SceneT>
bool is_opening_needed(const ContactGroups<SceneT>& groups) {
  bool is_needed = false;
  for (int k = 0; k < groups.solved_count; ++k) {  // Bound: kMaxContacts
    is_needed = is_needed || is_narrow(groups.solved_at(k));
  }
  return is_needed;
}

/// How deep two of each group are in each other, for all of the group. @pre join_all()
template <class SceneT>
void find_deepest(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  bool is_any = false;
  for (int k = 0; k < groups.solved_count; ++k) {  // Bound: kMaxContacts
    const auto& contact = groups.solved_at(k);
    auto& deepest = bodies.states[root_of(bodies, groups, contact)].deepest;
    deepest = max_of(deepest, -least_gap(contact));
    is_any = is_any || least_gap(contact) < Scalar_of<SceneT>(0);
  }
  for (int k = 0; k < groups.solved_count && is_any; ++k) {  // Bound: kMaxContacts
    const auto& contact = groups.solved_at(k);
    const auto deepest = bodies.states[root_of(bodies, groups, contact)].deepest;
    for (const std::size_t slot : {a_of<SceneT>(contact), b_of<SceneT>(contact)}) {  // Bound: 2
      if (!bodies.is_led(slot)) bodies.states[slot].deepest = deepest;
    }
  }
}

/// A velocity for one step that opens the gaps of contacts that press.
template <class SceneT>
void open_gaps(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  using Scalar = Scalar_of<SceneT>;
  find_held(bodies, groups);
  if (!is_opening_needed(groups)) return;
  find_deepest(bodies, groups);
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

/// Of a contact in a group that something holds: the lower one counts as held while gaps are
/// opened, so that its opening lifts all that lies on it (world.md, "Opening"). Not where the upper
/// one cannot give way, because it is fixed or pressed down by such a one: both would be held then,
/// and their gap could not open. @pre who lies on the upper one was looked at before
template <class SceneT>
void find_below(Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
                LastingContactOf<SceneT>& contact) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kUpright = Scalar(0.5);  // beside each other: neither is below
  const Scalar gravity = length(bodies.settings.gravity_W);
  const Scalar down = bodies.settings.gravity_W.dot(contact.points[0].normal_W);
  if (!contact.is_held || !(std::abs(down) > kUpright * gravity)) return;
  const bool is_A_below = down > Scalar(0);
  const std::size_t a = a_of<SceneT>(contact);
  const std::size_t b = b_of<SceneT>(contact);
  const std::size_t upper = is_A_below ? b : a;
  if (groups.solved[upper].inverse_mass > Scalar(0) && !bodies.states[upper].is_capped) {
    contact.below = is_A_below ? 1 : 2;
  } else if (is_narrow(contact)) {
    bodies.states[is_A_below ? a : b].is_capped = true;
  }
}

/// What something holds, and what counts as held: from the top down.
template <class SceneT>
void find_held(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  join_all(bodies, groups, false);
  for (int k = groups.solved_count - 1; k >= 0; --k) {  // Bound: kMaxContacts
    auto& contact = groups.solved_at(k);
    contact.is_held = groups.joined.is_held(root_of(bodies, groups, contact));
    if constexpr (SceneT::kGravity) find_below(bodies, groups, contact);
  }
}

/// How far what opens the gaps of a contact may take a body in what is left of a step, m: kFar of
/// D, and as far as any two of its group are in each other, because who is brought out of one lies
/// on others. Between two that give way to each other there would be no end to it.
template <class SceneT>
Scalar_of<SceneT> furthest_way(const Bodies<SceneT>& bodies,
                               const LastingContactOf<SceneT>& contact) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kFar = 64;
  const Scalar of_group = max_of(bodies.states[a_of<SceneT>(contact)].deepest,
                                 bodies.states[b_of<SceneT>(contact)].deepest);
  return kFar * contact.rest_gap + max_of(of_group, -least_gap(contact));
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

/// One side of a contact, with what opens gaps for its velocity: the lower one counts as held, and
/// who is opened no more. @param side  0: A, 1: B
template <class SceneT>
SolvedBody<Scalar_of<SceneT>> opening_side(const Bodies<SceneT>& bodies,
                                           const ContactGroups<SceneT>& groups,
                                           const LastingContactOf<SceneT>& contact,
                                           std::size_t side) {
  const std::size_t slot = side == 0 ? a_of<SceneT>(contact) : b_of<SceneT>(contact);
  const auto& state = bodies.states[slot];
  SolvedBody<Scalar_of<SceneT>> body = groups.solved[slot];
  body.v_W = state.opening.v_W;
  body.w_W = state.opening.w_W;
  const bool stays = contact.below == side + 1 || !state.is_opened;
  if (stays) body.inverse_mass = 0;
  if (stays || !contact.is_held) body.inverse_inertia_W.setZero();
  return body;
}

/// One contact, with the velocities that open gaps. What would take one of the two too far is left
/// out; and where nothing holds them, all that only one of the two would follow: the common centre
/// stays. @param share  of what is missing, in a step
template <class SceneT>
Scalar_of<SceneT> visit_opening(Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
                                LastingContactOf<SceneT>& contact, Scalar_of<SceneT> share) {
  using Scalar = Scalar_of<SceneT>;
  const std::size_t a = a_of<SceneT>(contact);
  const std::size_t b = b_of<SceneT>(contact);
  const bool both = bodies.states[a].is_opened && bodies.states[b].is_opened;
  if (!both && !contact.is_held) return Scalar(0);
  SolvedBody<Scalar> A = opening_side(bodies, groups, contact, 0);
  SolvedBody<Scalar> B = opening_side(bodies, groups, contact, 1);
  auto& points = contact.points;
  const Scalar front = points.front().opening;
  const Scalar back = points.back().opening;
  const Scalar change = relax_opening(contact, A, B, bodies.dt, share);
  if (!(change > Scalar(0))) return change;
  const Twist<Scalar> of_A = {A.v_W, A.w_W};
  const Twist<Scalar> of_B = {B.v_W, B.w_W};
  const Scalar furthest = furthest_way(bodies, contact);
  if (goes_too_far(bodies, a, of_A, furthest) || goes_too_far(bodies, b, of_B, furthest)) {
    points.front().opening = front;
    points.back().opening = back;
    return Scalar(0);
  }
  bodies.states[a].opening = of_A;
  bodies.states[b].opening = of_B;
  bodies.states[a].is_held = bodies.states[a].is_held || contact.is_held;
  bodies.states[b].is_held = bodies.states[b].is_held || contact.is_held;
  return change;
}

}  // namespace batuta::detail
