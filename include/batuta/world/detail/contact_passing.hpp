// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: what a blow passes on through a group. Included by contact_groups.hpp.

#include "batuta/world/detail/bent_course.hpp"
#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

/// A body is where it is now, and a blow has changed it. One that was led when its contacts were
/// prepared, and is not any more, is softer than they know: a blow takes a body out of a hand.
template <class SceneT>
void mark(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups, std::size_t slot) {
  if (groups.changes.is_dirty[slot]) return;
  if (bodies.is_led(slot)) return groups.load(bodies, slot);
  groups.changes.mark(slot);
  groups.look_again(slot);
  bodies.advance_to_now(slot);
  bodies.states[slot].changed = bodies.is_changed = true;
  const bool was_led = !(groups.solved[slot].inverse_mass > 0);
  groups.load(bodies, slot);
  if (was_led) groups.prepare_again(slot);
}

/// A contact where its bodies are now; what it spent so far cannot be taken back.
template <class SceneT>
void refresh(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups,
             LastingContactOf<SceneT>& contact) {
  using Scalar = Scalar_of<SceneT>;
  const std::size_t a = a_of<SceneT>(contact);
  const std::size_t b = b_of<SceneT>(contact);
  mark(bodies, groups, a);
  mark(bodies, groups, b);
  const Scalar left = bodies.dt - bodies.now;
  if (contact.is_solved) {
    const Scalar span = bodies.dt - contact.since;
    if (span > Scalar(0)) spend(contact, 1 - left / span);
  }
  contact.since = bodies.now;
  contact.is_moved = false;
  const Capsule<Scalar> A_W = bodies.shape_W(contact.pair.first);
  const Capsule<Scalar> B_W = bodies.shape_W(contact.pair.second);
  contact.is_new = !contact.is_solved;
  find_points(contact, A_W, B_W, closest_points(A_W.axis, B_W.axis), groups.solved[a].place_W,
              off_middle(bodies, a, b));
  prepare(contact, groups.solved[a], groups.solved[b], left);
  contact.is_solved = true;
}

/// How far a point may close in what is left of the step, m: `share` of D; or less where the gap is
/// nearly closed, because the search would call what is left contact at once (world.md, "Blows").
template <class SceneT>
Scalar_of<SceneT> may_close(const Bodies<SceneT>& bodies, const LastingContactOf<SceneT>& contact,
                            Scalar_of<SceneT> gap, Scalar_of<SceneT> share) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kOfGap = Scalar(1) / 4;
  constexpr Scalar kLeast = Scalar(1) / 4096;  // of D, in a whole step
  const Scalar least = kLeast * contact.rest_gap * ((bodies.dt - bodies.now) / bodies.dt);
  return min_of(share * contact.rest_gap, max_of(kOfGap * gap, least));
}

/// Whether the bodies of a contact that was looked at have changed by so little since then that it
/// need not be looked at again.
/// @param changed  what visits changed of both since then, m/s
template <class SceneT>
bool is_settled(const Bodies<SceneT>& bodies, const LastingContactOf<SceneT>& contact,
                Scalar_of<SceneT> changed, Scalar_of<SceneT> share) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kUnseen = Scalar(1) / 4;
  const Scalar gap = contact.count > 1 ? min_of(contact.points[0].gap, contact.points[1].gap)
                                       : contact.points[0].gap;
  return changed * (bodies.dt - bodies.now) < kUnseen * may_close(bodies, contact, gap, share);
}

/// Whether a contact is approached, or pulls, by more than matters in what is left of the step:
/// `share` of D; or less where the gap is nearly closed, because the search would call what is left
/// contact at once (world.md, "Blows"). One that was struck is not excused by an opening that holds
/// it apart: each answer would find the same approach.
template <class SceneT>
bool is_worth(const Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
              const LastingContactOf<SceneT>& contact, Scalar_of<SceneT> share, bool is_struck) {
  using Scalar = Scalar_of<SceneT>;
  const Scalar left = bodies.dt - bodies.now;
  const Scalar most = share * contact.rest_gap;
  const std::size_t a = a_of<SceneT>(contact);
  const std::size_t b = b_of<SceneT>(contact);
  const Twist<Scalar>& A = bodies.states[a].opening;
  const Twist<Scalar>& B = bodies.states[b].opening;
  bool is_worth = false;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar u =
        point.normal_W.dot(velocity_across(point, groups.solved[a], groups.solved[b])) + point.room;
    const Scalar opening = point.normal_W.dot(
        (A.v_W - B.v_W) + (A.w_W.cross(point.arm_A_W) -
                           B.w_W.cross(arm_B(point, groups.solved[a], groups.solved[b]))));
    const Scalar may_close = detail::may_close(bodies, contact, point.gap, share);
    const bool pulls = u * left > most && point.normal > Scalar(0);
    const Scalar by_opening = is_struck ? min_of(opening, Scalar(0)) : opening;
    is_worth = is_worth || (u + by_opening) * left < -may_close || pulls;
  }
  return is_worth;
}

/// Of what is missing to the gap of a contact, in a step: where two are in each other, all of it in
/// what is left, or eight times as fast as in a whole step; else nothing (world.md, "Blows").
template <class SceneT>
Scalar_of<SceneT> share_to_open(const Bodies<SceneT>& bodies,
                                const LastingContactOf<SceneT>& contact) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kFastest = 8;
  const Scalar left = bodies.dt - bodies.now;
  if (!(least_gap(contact) < Scalar(0)) || !(left > Scalar(0))) return Scalar(0);
  return min_of(bodies.dt / left, kFastest);
}

/// One visit, and what it changes goes into the momenta.
template <class SceneT>
void relax_now(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups,
               LastingContactOf<SceneT>& contact, Scalar_of<SceneT>& energy) {
  using Scalar = Scalar_of<SceneT>;
  std::array<PointImpulse<Scalar>, 2> before;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    before[k] = impulse_at(contact.points[k]);
  }
  visit_contact(groups, contact, energy, carried_by(bodies, contact));
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    const PointImpulse<Scalar> after = impulse_at(contact.points[k]);
    give_at(bodies, groups, contact, contact.points[k],
            {after.J_W - before[k].J_W, after.rolling_W - before[k].rolling_W});
  }
  visit_opening(bodies, groups, contact, share_to_open(bodies, contact));
}

/// Whether the two of a contact come at each other so many times faster than rest.
template <class SceneT>
bool is_faster(const Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
               const LastingContactOf<SceneT>& contact, int times) {
  using Scalar = Scalar_of<SceneT>;
  const std::size_t a = a_of<SceneT>(contact);
  const std::size_t b = b_of<SceneT>(contact);
  const Scalar approach = fastest_approach(contact, groups.solved[a], groups.solved[b]);
  return approach < -static_cast<Scalar>(times) * rest_speed(bodies);
}

/// A neighbour that is approached much faster than rest is struck in turn.
template <class SceneT, class Passing>
void pass_blow([[maybe_unused]] Bodies<SceneT>& bodies,
               [[maybe_unused]] ContactGroups<SceneT>& groups,
               [[maybe_unused]] LastingContactOf<SceneT>& contact,
               [[maybe_unused]] const Passing& passing) {
  if constexpr (SceneT::kRestitution) {
    constexpr int kSurely = 4;
    const std::size_t a = a_of<SceneT>(contact);
    const std::size_t b = b_of<SceneT>(contact);
    if (!is_faster(bodies, groups, contact, kSurely)) return;
    passing.blow(contact.pair);
    groups.load(bodies, a);
    groups.load(bodies, b);
    groups.look_again(a);
    groups.look_again(b);
  }
}

/// Two that cannot be answered in this step go on together.
template <class SceneT>
[[gnu::cold]] void drop(Bodies<SceneT>& bodies, ProxyPair pair) {
  ++bodies.report.contacts_dropped;
  bodies.weld(Bodies<SceneT>::body_of(pair.first), Bodies<SceneT>::body_of(pair.second), bodies.dt);
}

template <class SceneT>
template <class Struck, class Passing>
void ContactGroups<SceneT>::pass_on(BodiesT& bodies, const Struck& struck, const Passing& passing) {
  changes.clear();
  Scalar energy = 0;
  int last = kNone;
  for (const auto& one : struck) {  // Bound: the blows of a round
    Contact* contact = add(bodies, one.pair, rest_gap(bodies, one.pair));
    if (contact == nullptr) {
      drop(bodies, one.pair);
      continue;
    }
    if (is_welded(bodies, *contact)) continue;
    last = contacts.find(one.pair);
    changes.is_struck[static_cast<std::size_t>(last)] = true;
    refresh(bodies, *this, *contact);
  }
  if (last != kNone) relax_now(bodies, *this, contacts[last], energy);
  pass_around(bodies, *this, struck.size() > 1 ? kNone : last, energy, passing);
  if constexpr (SceneT::kGravity) {
    for (const Slot slot : changes.dirty) bodies.states[slot].loaded = false;  // Bound: kMaxBodies
    carry_loads(bodies, *this, true);
  }
}

/// Whether a contact has anything to answer; remembers that it was looked at.
template <class SceneT>
bool is_due(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups, std::size_t i) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kLeast = Scalar(1) / 8;  // of D, in what is left of the step
  constexpr Scalar kLeastOfStruck = Scalar(1) / 64;
  auto& changes = groups.changes;
  const auto& contact = groups.contacts[static_cast<int>(i)];
  const Scalar changed =
      changes.changed[a_of<SceneT>(contact)] + changes.changed[b_of<SceneT>(contact)];
  if (!contact.is_solved || is_welded(bodies, contact)) return false;
  const Scalar share = changes.is_struck[i] ? kLeastOfStruck : kLeast;
  if (is_settled(bodies, contact, changed - changes.seen[i], share)) return false;
  changes.seen[i] = changed;
  if (contact.since < Scalar(0)) return true;  // woken: its points are of the time before it slept
  for (const std::size_t side : {a_of<SceneT>(contact), b_of<SceneT>(contact)}) {  // Bound: 2
    groups.solved[side].place_W = place_now(bodies, side);
  }
  return is_worth(bodies, groups, contact, share, changes.is_struck[i]);
}

/// A contact and its bodies are where they are now, and its bodies have changed.
template <class SceneT>
void bring_to_now(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups,
                  LastingContactOf<SceneT>& contact) {
  mark(bodies, groups, a_of<SceneT>(contact));
  mark(bodies, groups, b_of<SceneT>(contact));
  if (contact.since < bodies.now || contact.is_moved) refresh(bodies, groups, contact);
}

/// A sleeper that is to take something is no wall to it.
template <class SceneT, class Passing>
void wake_sides([[maybe_unused]] const Bodies<SceneT>& bodies,
                [[maybe_unused]] const LastingContactOf<SceneT>& contact,
                [[maybe_unused]] const Passing& passing) {
  if constexpr (SceneT::kSleep) {
    for (const std::size_t slot : {a_of<SceneT>(contact), b_of<SceneT>(contact)}) {  // Bound: 2
      if (bodies.is_asleep(slot)) passing.wake(slot);
    }
  }
}

/// Whether two that have been in contact in this step are on their way to it again: the search says
/// when they meet. Within a few D they are as good as there (world.md, "Blows").
template <class SceneT>
bool comes_from_afar(const Bodies<SceneT>& bodies, const ContactGroups<SceneT>& groups,
                     const LastingContactOf<SceneT>& contact) {
  constexpr int kNear = 4;  // D
  return least_gap(contact) > kNear * contact.rest_gap && is_faster(bodies, groups, contact, 1);
}

/// The i-th contact, of a body that has changed: what it has to answer is answered.
/// @param parts  the contact that was struck alone: it parts, and is not struck again; or kNone
/// @returns whether it had anything to answer
template <class SceneT, class Passing>
bool pass_to(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups, int i, int parts,
             Scalar_of<SceneT>& energy, const Passing& passing) {
  if (!is_due(bodies, groups, static_cast<std::size_t>(i))) return false;
  LastingContactOf<SceneT>& contact = groups.contacts[i];
  if (wins_by_chord(bodies, a_of<SceneT>(contact), b_of<SceneT>(contact), bodies.now)) {
    drop(bodies, contact.pair);
    return true;
  }
  wake_sides(bodies, contact, passing);
  bring_to_now(bodies, groups, contact);
  if (comes_from_afar(bodies, groups, contact)) return false;
  if (i != parts) pass_blow(bodies, groups, contact, passing);
  relax_now(bodies, groups, contact, energy);
  return true;
}

/// From body to body, until no contact of those that have changed has anything to answer.
/// @param parts  that of pass_to()
template <class SceneT, class Passing>
void pass_around(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups, int parts,
                 Scalar_of<SceneT> energy, const Passing& passing) {
  constexpr int kNone = ContactGroups<SceneT>::kNone;
  constexpr int kEventSweeps = 48;
  const auto& list = groups.contacts;
  bool is_done = false;
  for (int s = 0; s < kEventSweeps && !is_done; ++s) {  // Bound: kEventSweeps
    is_done = true;
    for (int d = 0; d < groups.changes.dirty.size(); ++d) {  // Bound: kMaxBodies
      const std::size_t slot = groups.changes.dirty[d];
      // Bound: the contacts of a body.
      for (int i = list.first_of(slot); i != kNone; i = list.next_of(i, slot)) {
        if (pass_to(bodies, groups, i, parts, energy, passing)) is_done = false;
      }
    }
  }
}

}  // namespace batuta::detail
