// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: contacts that last, solved before anybody moves. Included by contact_groups.hpp.

#include "batuta/world/detail/contact_choice.hpp"

namespace batuta::detail {

/// Contacts of one group, in the order in which they are visited: from the first one to before the
/// last one.
struct GroupRange {
  int first = 0;
  int last = 0;
};

/// What gravity makes in half of what is left of the step, m/s, of what a contact gives to A, where
/// one of the two holds the other: between two that fall it is nothing.
template <class SceneT>
Vec3<Scalar_of<SceneT>> carried_by([[maybe_unused]] const Bodies<SceneT>& bodies,
                                   [[maybe_unused]] const LastingContactOf<SceneT>& contact) {
  using Scalar = Scalar_of<SceneT>;
  Vec3<Scalar> carried_W = Vec3<Scalar>::Zero();
  if constexpr (SceneT::kGravity) {
    const bool A_holds = bodies.holds(a_of<SceneT>(contact));
    const Scalar half = (bodies.dt - bodies.now) / 2;
    if (A_holds != bodies.holds(b_of<SceneT>(contact))) {
      carried_W = (A_holds ? half : -half) * bodies.settings.gravity_W;
    }
  }
  return carried_W;
}

/// What the impulses of a group, given to velocities as they are, add to the energy at first order,
/// and to that of the room that is used up, J.
template <class SceneT>
Scalar_of<SceneT> work_of(const ContactGroups<SceneT>& groups, GroupRange group) {
  using Scalar = Scalar_of<SceneT>;
  Scalar sum = 0;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    const auto& contact = groups.solved_at(k);
    for (int i = 0; i < contact.count; ++i) {  // Bound: 2
      const auto& point = contact.points[static_cast<std::size_t>(i)];
      sum += power_of(point, groups.solved[a_of<SceneT>(contact)],
                      groups.solved[b_of<SceneT>(contact)]);
    }
  }
  return sum;
}

/// The bodies of a group as they are, to the last bit: what is at rest stays so.
template <class SceneT>
void take_back(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups, GroupRange group) {
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    groups.load(bodies, a_of<SceneT>(groups.solved_at(k)));
    groups.load(bodies, b_of<SceneT>(groups.solved_at(k)));
  }
}

/// The impulses of the last step, as far as they take energy: along their ray the energy is a
/// parabola (world.md, "Warm start"). @returns what that adds, J, <= 0
template <class SceneT>
Scalar_of<SceneT> warm_up(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups,
                          GroupRange group) {
  using Scalar = Scalar_of<SceneT>;
  const auto give = [&](Scalar share) {
    for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
      const auto& contact = groups.solved_at(k);
      push_share(contact, groups.solved[a_of<SceneT>(contact)],
                 groups.solved[b_of<SceneT>(contact)], share);
    }
  };
  constexpr Scalar kOfLift = Scalar(1) / 16;  // more than that throws up what they carry
  const Scalar slope = work_of(groups, group);
  Scalar lift = 0;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    const auto& contact = groups.solved_at(k);
    const Vec3<Scalar> carried_W = carried_by(bodies, contact);
    for (int i = 0; i < contact.count; ++i) {  // Bound: 2
      lift += carried_W.dot(impulse_at(contact.points[static_cast<std::size_t>(i)]).J_W);
    }
  }
  give(Scalar(1));
  const Scalar bend = work_of(groups, group) - slope;
  Scalar share = bend > Scalar(0) ? clamp(-slope / bend, Scalar(0), Scalar(1)) : Scalar(0);
  if (slope + lift + bend / 2 < kOfLift * lift) share = 1;
  if (share > Scalar(0)) {
    if (share < Scalar(1)) give(share - 1);
  } else {
    take_back(bodies, groups, group);
  }
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    scale_impulses(groups.solved_at(k), share);
  }
  return min_of(Scalar(0), share * slope + share * share * bend / 2);
}

/// The change of a velocity that matters to a contact: so much of D in what is left of the step, or
/// less where the gap is nearly closed, because the search would call what is left contact.
template <class Traits, class Scalar>
Scalar least_change(const LastingContact<Traits>& contact, Scalar time) {
  constexpr Scalar kEnough = Scalar(1) / 64;   // of D
  constexpr Scalar kOfGap = Scalar(1) / 8;     // of the gap
  constexpr Scalar kLeast = Scalar(1) / 1024;  // of D
  const Scalar D = contact.rest_gap;
  return min_of(kEnough * D, max_of(kOfGap * least_gap(contact), kLeast * D)) / time;
}

/// Does something to both bodies of a contact, and adds what that changed to what is known of them.
template <class SceneT, class Change>
void watch(ContactGroups<SceneT>& groups, const LastingContactOf<SceneT>& contact,
           const Change& change) {
  using Scalar = Scalar_of<SceneT>;
  const std::array<std::size_t, 2> slots = {a_of<SceneT>(contact), b_of<SceneT>(contact)};
  std::array<Vec3<Scalar>, 4> before;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    before[2 * i] = groups.solved[slots[i]].v_W;
    before[2 * i + 1] = groups.solved[slots[i]].w_W;
  }
  change(groups.solved[slots[0]], groups.solved[slots[1]]);
  const auto& point = contact.points[0];
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    const auto& solved = groups.solved[slots[i]];
    const Vec3<Scalar> arm_W = point.arm_A_W + (groups.solved[slots[0]].place_W - solved.place_W);
    const Scalar reach = arm_W.cwiseAbs().sum();
    groups.changes.changed[slots[i]] += (solved.v_W - before[2 * i]).cwiseAbs().sum() +
                                        reach * (solved.w_W - before[2 * i + 1]).cwiseAbs().sum();
  }
}

/// One visit. @param energy  what was added to that of the group so far, J, <= 0: the visit adds
/// its part  @returns the largest change along a normal, m/s
template <class SceneT>
Scalar_of<SceneT> visit_contact(ContactGroups<SceneT>& groups, LastingContactOf<SceneT>& contact,
                                Scalar_of<SceneT>& energy,
                                const Vec3<Scalar_of<SceneT>>& carried_W) {
  using Scalar = Scalar_of<SceneT>;
  Scalar most = 0;
  watch(groups, contact, [&](SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
    most = relax(contact, A, B, energy, carried_W);
  });
  return most;
}

/// One sweep, up or down. A contact whose bodies have changed by much less than what matters since
/// its last visit is passed over. @returns whether nothing changed by enough to matter
template <class SceneT>
bool sweep_once(ContactGroups<SceneT>& groups, GroupRange group, bool is_up, Scalar_of<SceneT> time,
                Scalar_of<SceneT>& energy) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kUnseen = Scalar(1) / 4;
  auto& changes = groups.changes;
  bool is_done = true;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    const int at = is_up ? k : group.last - 1 - (k - group.first);
    const std::size_t i = groups.order[static_cast<std::size_t>(at)];
    auto& contact = groups.contacts[static_cast<int>(i)];
    const Scalar enough = least_change(contact, time);
    const Scalar changed =
        changes.changed[a_of<SceneT>(contact)] + changes.changed[b_of<SceneT>(contact)];
    if (!(changed - changes.seen[i] > kUnseen * enough)) continue;
    changes.seen[i] = changed;
    const Scalar change = visit_contact(groups, contact, energy, Vec3<Scalar>::Zero());
    is_done = is_done && !(change > enough);
  }
  return is_done;
}

/// Between two sweeps: on, the way that they lead (world.md, "Sweeps that are ahead").
/// @param led  how far the sweep before the last one has led, J; becomes that of the last one
template <class SceneT>
void go_on_ahead(ContactGroups<SceneT>& groups, GroupRange group, Scalar_of<SceneT>& led,
                 Scalar_of<SceneT>& energy) {
  using Scalar = Scalar_of<SceneT>;
  Scalar now = 0;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    now += led_by_sweep(groups.solved_at(k));
  }
  const Scalar share = now < led ? now / led : Scalar(0);
  led = now;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    auto& contact = groups.solved_at(k);
    watch(groups, contact, [&](SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
      go_ahead(contact, A, B, share, energy);
    });
  }
}

/// Up and down, until nothing changes by enough to matter.
/// @param energy  what was added to that of the group so far, J, <= 0
template <class SceneT>
void sweep_group(ContactGroups<SceneT>& groups, GroupRange group, Scalar_of<SceneT> time,
                 Scalar_of<SceneT> energy) {
  using Scalar = Scalar_of<SceneT>;
  constexpr int kMaxSweeps = 60;
  constexpr int kFew = 3;  // contacts: so few need nobody ahead
  const bool is_long = group.last - group.first > kFew;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    const std::size_t i = groups.order[static_cast<std::size_t>(k)];
    groups.changes.seen[i] = BodyChanges<SceneT>::kNever;
    for (auto& point : groups.contacts[static_cast<int>(i)].points) {  // Bound: 2
      point.start = point.normal;
      point.ahead = 0;
    }
  }
  Scalar led = 0;
  for (int s = 0; s < kMaxSweeps; ++s) {  // Bound: kMaxSweeps
    if (sweep_once(groups, group, s % 2 == 0, time, energy)) return;
    if (is_long && s + 1 < kMaxSweeps) go_on_ahead(groups, group, led, energy);
  }
}

/// One impulse at one point, to both.
template <class SceneT>
void give_at(Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
             const LastingContactOf<SceneT>& contact,
             const ContactPoint<ContactTraitsOf<SceneT>>& point,
             const PointImpulse<Scalar_of<SceneT>>& given) {
  const std::size_t a = a_of<SceneT>(contact);
  const std::size_t b = b_of<SceneT>(contact);
  if (!bodies.is_led(a)) {
    auto& momentum = bodies.actor(a).body.momentum;
    momentum.linear_W += given.J_W;
    momentum.angular_W += point.arm_A_W.cross(given.J_W) + given.rolling_W;
  }
  if (!bodies.is_led(b)) {
    auto& momentum = bodies.actor(b).body.momentum;
    momentum.linear_W -= given.J_W;
    momentum.angular_W -=
        arm_B(point, groups.solved[a], groups.solved[b]).cross(given.J_W) + given.rolling_W;
  }
}

/// What was solved goes into the momenta.
template <class SceneT>
void give(Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
          const LastingContactOf<SceneT>& contact) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    give_at(bodies, groups, contact, point, impulse_at(point));
  }
}

template <class SceneT>
void carry_load(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups, std::size_t slot,
                bool dirty_only) {
  if (dirty_only && !groups.changes.is_dirty[slot]) return;
  if (bodies.is_led(slot)) return;
  if (groups.joined.is_held(groups.joined.root_of(slot))) bodies.states[slot].loaded = true;
}

/// Who is pressed, in a group that something holds, goes with the velocity of the step's end.
template <class SceneT>
void carry_loads([[maybe_unused]] Bodies<SceneT>& bodies,
                 [[maybe_unused]] ContactGroups<SceneT>& groups, [[maybe_unused]] bool dirty_only) {
  if constexpr (SceneT::kGravity) {
    join_all(bodies, groups, true);
    for (int i = 0; i < groups.contacts.size(); ++i) {  // Bound: kMaxContacts
      const auto& contact = groups.contacts[i];
      if (!contact.is_solved || !is_loaded(contact)) continue;
      carry_load(bodies, groups, a_of<SceneT>(contact), dirty_only);
      carry_load(bodies, groups, b_of<SceneT>(contact), dirty_only);
    }
  }
}

template <class SceneT>
void ContactGroups<SceneT>::solve(BodiesT& bodies) {
  for (std::size_t slot = 0; slot < BodiesT::kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.states[slot].present && contacts.first_of(slot) != kNone) load(bodies, slot);
  }
  choose(bodies, *this);
  if (solved_count == 0) return;
  changes.changed.fill(0);
  put_in_order(bodies, *this);
  const auto group_at = [&](int k) { return root_of(bodies, *this, solved_at(k)); };
  for (int first = 0; first < solved_count;) {  // Bound: kMaxContacts
    int last = first + 1;
    while (last < solved_count && group_at(last) == group_at(first)) ++last;  // Bound: as above
    sweep_group(*this, {first, last}, bodies.dt, warm_up(bodies, *this, {first, last}));
    first = last;
  }
  for (int k = 0; k < solved_count; ++k) give(bodies, *this, solved_at(k));  // Bound: kMaxContacts
  carry_loads(bodies, *this, false);
  open_gaps(bodies, *this);
}

}  // namespace batuta::detail
