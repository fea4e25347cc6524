// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: which contacts are solved, and in which order. Included by contact_groups.hpp.

#include <algorithm>

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

template <class SceneT>
void ContactGroups<SceneT>::load(const BodiesT& bodies, std::size_t slot) {
  SolvedBody<Scalar>& side = solved[slot];
  const auto& body = bodies.actor(slot).body;
  const auto& state = bodies.states[slot];
  side = {};
  side.place_W = place_now(bodies, slot);
  if (state.asleep) return;
  const bool is_led = bodies.is_led(slot);
  const Twist<Scalar> twist = is_led ? state.plan.motion.twist : twist_of(body);
  side.v_W = twist.v_W;
  side.w_W = twist.w_W;
  if (is_led) return;
  side.inverse_inertia_W = inverse_inertia_W(body);
  side.inverse_mass = body.inverse_mass;
}

/// What counts as rest, m/s.
template <class SceneT>
Scalar_of<SceneT> rest_speed(const Bodies<SceneT>& bodies) {
  using Scalar = Scalar_of<SceneT>;
  Scalar speed = bodies.settings.rest_speed;
  if constexpr (SceneT::kGravity) {
    speed = max_of(speed, bodies.dt * length(bodies.settings.gravity_W));
  }
  return speed;
}

/// Whether a contact is between two of which one can be moved, and that go alone.
template <class SceneT>
bool may_last(const Bodies<SceneT>& bodies, const LastingContactOf<SceneT>& contact) {
  if (!contact.is_kept || is_welded(bodies, contact)) return false;
  return !bodies.is_led(a_of<SceneT>(contact)) || !bodies.is_led(b_of<SceneT>(contact));
}

/// A contact lasts unless it is a blow: by the velocities before gravity, faster than rest. One
/// that lasted goes on unless it is faster than that by kSurely.
/// @param rest  what counts as rest, m/s. @pre the contact is prepared
template <class SceneT>
bool bounces([[maybe_unused]] const Bodies<SceneT>& bodies,
             [[maybe_unused]] const ContactGroups<SceneT>& groups,
             [[maybe_unused]] const LastingContactOf<SceneT>& contact,
             [[maybe_unused]] Scalar_of<SceneT> rest) {
  if constexpr (SceneT::kRestitution) {
    using Scalar = Scalar_of<SceneT>;
    constexpr Scalar kSurely = 4;
    const std::size_t a = a_of<SceneT>(contact);
    const std::size_t b = b_of<SceneT>(contact);
    Scalar approach = fastest_approach(contact, groups.solved[a], groups.solved[b]);
    if constexpr (SceneT::kGravity) {
      const Scalar fall = bodies.dt * contact.points[0].normal_W.dot(bodies.settings.gravity_W);
      if (bodies.falls(a)) approach -= fall;
      if (bodies.falls(b)) approach += fall;
    }
    const Scalar limit = contact.is_new ? rest : kSurely * rest;
    return approach < -limit &&
           pair_restitution(bodies.actor(a).restitution, bodies.actor(b).restitution) > Scalar(0);
  } else {
    return false;
  }
}

/// Which contacts are solved.
template <class SceneT>
void choose(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  using Scalar = Scalar_of<SceneT>;
  const Scalar rest = rest_speed(bodies);
  groups.solved_count = 0;
  for (int i = 0; i < groups.contacts.size(); ++i) {  // Bound: kMaxContacts
    auto& contact = groups.contacts[i];
    const std::size_t a = a_of<SceneT>(contact);
    const std::size_t b = b_of<SceneT>(contact);
    contact.is_solved = false;
    contact.below = 0;
    contact.is_held = false;
    if (!may_last(bodies, contact)) continue;
    prepare(contact, groups.solved[a], groups.solved[b], bodies.dt);
    contact.is_solved = !bounces(bodies, groups, contact, rest);
    if (contact.is_solved) {
      groups.order[groups.solved_count++] = static_cast<std::uint16_t>(i);
    } else {
      scale_impulses(contact, Scalar(0));
    }
  }
}

/// The lowest body of the group that a contact belongs to. @pre join_all()
template <class SceneT>
std::size_t root_of(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups,
                    const LastingContactOf<SceneT>& contact) {
  const std::size_t a = a_of<SceneT>(contact);
  return groups.joined.root_of(bodies.is_led(a) ? b_of<SceneT>(contact) : a);
}

/// Group by group, from the ground up; heap sort, because it neither recurses nor asks for room.
/// The keys are kept where sweeps will keep theirs (ContactPoint): each is computed once.
template <class SceneT>
void put_in_order(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  using Scalar = Scalar_of<SceneT>;
  Vec3<Scalar> down_W = Vec3<Scalar>::Zero();
  if constexpr (SceneT::kGravity) down_W = bodies.settings.gravity_W;
  join_all(bodies, groups, false);
  for (int k = 0; k < groups.solved_count; ++k) {  // Bound: kMaxContacts
    auto& contact = groups.solved_at(k);
    contact.points[0].start = static_cast<Scalar>(root_of(bodies, groups, contact));
    contact.points[0].ahead = down_W.dot(point_W(groups, contact));
  }
  const auto precedes = [&](std::uint16_t x, std::uint16_t y) {
    const auto& P = groups.contacts[x].points[0];
    const auto& Q = groups.contacts[y].points[0];
    if (P.start < Q.start || Q.start < P.start) return P.start < Q.start;
    if (P.ahead > Q.ahead || Q.ahead > P.ahead) return P.ahead > Q.ahead;
    return batuta::detail::precedes(groups.contacts[x].pair, groups.contacts[y].pair);
  };
  const auto end = groups.order.begin() + groups.solved_count;
  std::make_heap(groups.order.begin(), end, precedes);
  std::sort_heap(groups.order.begin(), end, precedes);
}

}  // namespace batuta::detail
