// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: what a blow passes on through a group. Included by contact_groups.hpp.

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

template <class SceneT>
void ContactGroups<SceneT>::mark(BodiesT& bodies, std::size_t slot) {
  if (is_dirty_[slot]) return;
  if (bodies.is_led(slot)) return load(bodies, slot);
  is_dirty_[slot] = true;
  changed_[slot] += kNoticed;
  dirty_.push(static_cast<Slot>(slot));
  bodies.advance_to_now(slot);
  bodies.states[slot].changed = bodies.is_changed = true;
  load(bodies, slot);
}

/// A contact where its bodies are now; what it spent so far cannot be taken back.
template <class SceneT>
void ContactGroups<SceneT>::refresh(BodiesT& bodies, Contact& contact) {
  const std::size_t a = a_of(contact);
  const std::size_t b = b_of(contact);
  mark(bodies, a);
  mark(bodies, b);
  const Scalar left = bodies.dt - bodies.now;
  if (contact.is_solved) {
    const Scalar span = bodies.dt - contact.since;
    if (span > Scalar(0)) spend(contact, 1 - left / span);
  }
  contact.since = bodies.now;
  const Capsule<Scalar> A_W = bodies.shape_W(contact.pair.first);
  const Capsule<Scalar> B_W = bodies.shape_W(contact.pair.second);
  contact.is_new = !contact.is_solved;
  find_points(contact, A_W, B_W, closest_points(A_W.axis, B_W.axis), solved_[a].place_W);
  prepare(contact, solved_[a], solved_[b], left);
  contact.is_solved = true;
}

/// How far a point may close in what is left of the step, m: `share` of D; or less where the gap is
/// nearly closed, because the search would call what is left contact at once (world.md, "Blows").
template <class SceneT>
Scalar_of<SceneT> ContactGroups<SceneT>::may_close(const BodiesT& bodies, const Contact& contact,
                                                   Scalar gap, Scalar share) const {
  constexpr Scalar kOfGap = Scalar(1) / 4;
  constexpr Scalar kLeast = Scalar(1) / 4096;  // of D, in a whole step
  const Scalar least = kLeast * contact.rest_gap * ((bodies.dt - bodies.now) / bodies.dt);
  return min_of(share * contact.rest_gap, max_of(kOfGap * gap, least));
}

/// Whether the bodies of a contact that was looked at have changed by so little since then that it
/// need not be looked at again.
/// @param changed  what visits changed of both since then, m/s
template <class SceneT>
bool ContactGroups<SceneT>::is_settled(const BodiesT& bodies, const Contact& contact,
                                       Scalar changed, Scalar share) const {
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
bool ContactGroups<SceneT>::is_worth(const BodiesT& bodies, const Contact& contact, Scalar share,
                                     bool is_struck) const {
  const Scalar left = bodies.dt - bodies.now;
  const Scalar most = share * contact.rest_gap;
  const std::size_t a = a_of(contact);
  const std::size_t b = b_of(contact);
  const Twist<Scalar>& A = bodies.states[a].opening;
  const Twist<Scalar>& B = bodies.states[b].opening;
  bool is_worth = false;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar u =
        point.normal_W.dot(velocity_across(point, solved_[a], solved_[b])) + point.room;
    const Scalar opening =
        point.normal_W.dot((A.v_W - B.v_W) + (A.w_W.cross(point.arm_A_W) -
                                              B.w_W.cross(arm_B(point, solved_[a], solved_[b]))));
    const Scalar may_close = this->may_close(bodies, contact, point.gap, share);
    const bool pulls = u * left > most && point.normal > Scalar(0);
    const Scalar by_opening = is_struck ? min_of(opening, Scalar(0)) : opening;
    is_worth = is_worth || (u + by_opening) * left < -may_close || pulls;
  }
  return is_worth;
}

/// Of what is missing to the gap of a contact, in a step: where two are in each other, all of it in
/// what is left, or eight times as fast as in a whole step; else nothing (world.md, "Blows").
template <class SceneT>
Scalar_of<SceneT> ContactGroups<SceneT>::share_to_open(const BodiesT& bodies,
                                                       const Contact& contact) const {
  constexpr Scalar kFastest = 8;
  const Scalar left = bodies.dt - bodies.now;
  if (!(least_gap(contact) < Scalar(0)) || !(left > Scalar(0))) return Scalar(0);
  return min_of(bodies.dt / left, kFastest);
}

/// One visit, and what it changes goes into the momenta.
template <class SceneT>
void ContactGroups<SceneT>::relax_now(BodiesT& bodies, Contact& contact, Scalar& energy) {
  std::array<PointImpulse<Scalar>, 2> before;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    before[k] = impulse_at(contact.points[k]);
  }
  visit(contact, energy, carried_by(bodies, contact));
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    const PointImpulse<Scalar> after = impulse_at(contact.points[k]);
    give_at(bodies, contact, contact.points[k],
            {after.J_W - before[k].J_W, after.rolling_W - before[k].rolling_W});
  }
  visit_opening(bodies, contact, share_to_open(bodies, contact));
}

/// A neighbour that is approached much faster than rest is struck in turn.
template <class SceneT>
template <class Blow>
void ContactGroups<SceneT>::pass_blow(BodiesT& bodies, Contact& contact, const Blow& blow) {
  if constexpr (SceneT::kRestitution) {
    constexpr Scalar kSurely = 4;
    const std::size_t a = a_of(contact);
    const std::size_t b = b_of(contact);
    const Scalar approach = fastest_approach(contact, solved_[a], solved_[b]);
    if (!(approach < -kSurely * rest_speed(bodies))) return;
    blow(contact.pair);
    load(bodies, a);
    load(bodies, b);
    changed_[a] += kNoticed;
    changed_[b] += kNoticed;
  }
}

template <class SceneT>
template <class Struck, class Blow>
void ContactGroups<SceneT>::pass_on(BodiesT& bodies, const Struck& struck, const Blow& blow) {
  dirty_.clear();
  is_dirty_.fill(false);
  is_struck_.fill(false);
  changed_.fill(0);
  seen_.fill(0);
  Scalar energy = 0;
  int last = kNone;
  for (const auto& one : struck) {  // Bound: the blows of a round
    Contact* contact = add(bodies, one.pair, rest_gap(bodies, one.pair));
    if (contact == nullptr) {
      ++bodies.report.contacts_dropped;
      bodies.weld(BodiesT::body_of(one.pair.first), BodiesT::body_of(one.pair.second), bodies.dt);
      continue;
    }
    if (is_welded(bodies, *contact)) continue;
    last = find(one.pair);
    is_struck_[static_cast<std::size_t>(last)] = true;
    refresh(bodies, *contact);
  }
  if (last != kNone) relax_now(bodies, contacts_[last], energy);
  pass_around(bodies, struck.size() > 1 ? kNone : last, energy, blow);
  if constexpr (SceneT::kGravity) {
    for (const Slot slot : dirty_) bodies.states[slot].loaded = false;  // Bound: kMaxBodies
    carry_loads(bodies, true);
  }
}

/// Whether a contact has anything to answer; remembers that it was looked at.
template <class SceneT>
bool ContactGroups<SceneT>::is_due(BodiesT& bodies, std::size_t i) {
  constexpr Scalar kLeast = Scalar(1) / 8;  // of D, in what is left of the step
  constexpr Scalar kLeastOfStruck = Scalar(1) / 64;
  const Contact& contact = contacts_[static_cast<int>(i)];
  const Scalar changed = changed_[a_of(contact)] + changed_[b_of(contact)];
  if (!contact.is_solved || changed == seen_[i] || is_welded(bodies, contact)) return false;
  const Scalar share = is_struck_[i] ? kLeastOfStruck : kLeast;
  const bool was_seen = seen_[i] > Scalar(0);
  if (was_seen && is_settled(bodies, contact, changed - seen_[i], share)) return false;
  seen_[i] = changed;
  for (const std::size_t side : {a_of(contact), b_of(contact)}) {  // Bound: 2
    solved_[side].place_W = place_now(bodies, side);
  }
  return is_worth(bodies, contact, share, is_struck_[i]);
}

/// What a contact passes on. @param parts  as for pass_around()
template <class SceneT>
template <class Blow>
void ContactGroups<SceneT>::pass_at(BodiesT& bodies, int i, int parts, Scalar& energy,
                                    const Blow& blow) {
  Contact& contact = contacts_[i];
  if (contact.since < bodies.now) refresh(bodies, contact);
  mark(bodies, a_of(contact));
  mark(bodies, b_of(contact));
  if (i != parts) pass_blow(bodies, contact, blow);
  relax_now(bodies, contact, energy);
}

/// From body to body, until no contact of those that have changed has anything to answer.
/// @param parts  the contact that was struck alone: it parts, and is not struck again; or kNone
template <class SceneT>
template <class Blow>
void ContactGroups<SceneT>::pass_around(BodiesT& bodies, int parts, Scalar energy,
                                        const Blow& blow) {
  bool is_done = false;
  for (int s = 0; s < kEventSweeps && !is_done; ++s) {  // Bound: kEventSweeps
    is_done = true;
    for (int d = 0; d < dirty_.size(); ++d) {  // Bound: kMaxBodies
      const std::size_t slot = dirty_[d];
      int next = first_of_[slot];
      while (next != 0) {  // Bound: the contacts of a body
        const int i = next - 1;
        next = next_[static_cast<std::size_t>(i)][a_of(contacts_[i]) == slot ? 0 : 1];
        if (!is_due(bodies, static_cast<std::size_t>(i))) continue;
        is_done = false;
        pass_at(bodies, i, parts, energy, blow);
      }
    }
  }
}

}  // namespace batuta::detail
