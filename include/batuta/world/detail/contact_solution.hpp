// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: contacts that last, solved before anybody moves. Included by contact_groups.hpp.

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

template <class SceneT>
void ContactGroups<SceneT>::load(const BodiesT& bodies, std::size_t slot) {
  SolvedBody<Scalar>& solved = solved_[slot];
  const auto& body = bodies.actor(slot).body;
  const auto& state = bodies.states[slot];
  solved = {};
  solved.place_W = place_now(bodies, slot);
  if (state.asleep) return;
  const bool is_led = bodies.is_led(slot);
  const Twist<Scalar> twist = is_led ? state.plan.motion.twist : twist_of(body);
  solved.v_W = twist.v_W;
  solved.w_W = twist.w_W;
  if (is_led) return;
  solved.inverse_inertia_W = inverse_inertia_W(body);
  solved.inverse_mass = body.inverse_mass;
}

template <class SceneT>
Scalar_of<SceneT> ContactGroups<SceneT>::rest_speed(const BodiesT& bodies) const {
  Scalar speed = bodies.settings.rest_speed;
  if constexpr (SceneT::kGravity) {
    speed = max_of(speed, bodies.dt * length(bodies.settings.gravity_W));
  }
  return speed;
}

/// Whether a contact is between two of which one can be moved, and that go alone.
template <class SceneT>
bool ContactGroups<SceneT>::may_last(const BodiesT& bodies, const Contact& contact) const {
  if (!contact.is_kept || is_welded(bodies, contact)) return false;
  return !bodies.is_led(a_of(contact)) || !bodies.is_led(b_of(contact));
}

/// A contact lasts unless it is a blow: by the velocities before gravity, faster than rest. One
/// that lasted goes on unless it is faster than that by kSurely.
/// @param rest  what counts as rest, m/s. @pre the contact is prepared
template <class SceneT>
bool ContactGroups<SceneT>::bounces([[maybe_unused]] const BodiesT& bodies,
                                    [[maybe_unused]] const Contact& contact,
                                    [[maybe_unused]] Scalar rest) const {
  if constexpr (SceneT::kRestitution) {
    constexpr Scalar kSurely = 4;
    const std::size_t a = a_of(contact);
    const std::size_t b = b_of(contact);
    Scalar approach = fastest_approach(contact, solved_[a], solved_[b]);
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
void ContactGroups<SceneT>::choose(const BodiesT& bodies) {
  const Scalar rest = rest_speed(bodies);
  solved_count_ = 0;
  for (int i = 0; i < contacts_.size(); ++i) {  // Bound: kMaxContacts
    Contact& contact = contacts_[i];
    const std::size_t a = a_of(contact);
    const std::size_t b = b_of(contact);
    contact.is_solved = false;
    contact.below = 0;
    contact.is_held = false;
    if (!may_last(bodies, contact)) continue;
    prepare(contact, solved_[a], solved_[b], bodies.dt);
    contact.is_solved = !bounces(bodies, contact, rest);
    if (contact.is_solved) {
      order_[static_cast<std::size_t>(solved_count_++)] = static_cast<Slot>(i);
    } else {
      scale_impulses(contact, Scalar(0));
    }
  }
}

template <class SceneT>
std::size_t ContactGroups<SceneT>::root_of(std::size_t slot) {
  while (root_[slot] != slot) {  // Bound: kMaxBodies
    root_[slot] = root_[root_[slot]];
    slot = root_[slot];
  }
  return slot;
}

/// Groups of bodies that contacts join. What is led belongs to none: it holds those that it
/// touches. @param loaded_only  contacts that press
template <class SceneT>
void ContactGroups<SceneT>::unite(const BodiesT& bodies, bool loaded_only) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    root_[slot] = static_cast<Slot>(slot);
    held_[slot] = false;
  }
  for (int pass = 0; pass < 2; ++pass) {          // Bound: 2: who is joined, then who holds
    for (int i = 0; i < contacts_.size(); ++i) {  // Bound: kMaxContacts
      const Contact& contact = contacts_[i];
      if (!contact.is_solved || (loaded_only && !is_loaded(contact))) continue;
      if (pass == 0) {
        join(bodies, contact);
      } else {
        hold(bodies, contact);
      }
    }
  }
}

template <class SceneT>
void ContactGroups<SceneT>::join(const BodiesT& bodies, const Contact& contact) {
  if (bodies.is_led(a_of(contact)) || bodies.is_led(b_of(contact))) return;
  const std::size_t p = root_of(a_of(contact));
  const std::size_t q = root_of(b_of(contact));
  root_[max_of(p, q)] = static_cast<Slot>(min_of(p, q));
}

template <class SceneT>
void ContactGroups<SceneT>::hold(const BodiesT& bodies, const Contact& contact) {
  if (bodies.is_led(a_of(contact))) held_[root_of(b_of(contact))] = true;
  if (bodies.is_led(b_of(contact))) held_[root_of(a_of(contact))] = true;
}

/// Group by group, from the ground up; heap sort, because it neither recurses nor asks for room.
template <class SceneT>
void ContactGroups<SceneT>::order(const BodiesT& bodies) {
  Vec3<Scalar> down_W = Vec3<Scalar>::Zero();
  if constexpr (SceneT::kGravity) down_W = bodies.settings.gravity_W;
  unite(bodies, false);
  const auto group_of = [&](const Contact& contact) {
    const std::size_t a = a_of(contact);
    return root_of(bodies.is_led(a) ? b_of(contact) : a);
  };
  const auto precedes = [&](Slot x, Slot y) {
    const Contact& P = contacts_[x];
    const Contact& Q = contacts_[y];
    const std::size_t p = group_of(P);
    const std::size_t q = group_of(Q);
    if (p != q) return p < q;
    const Scalar low_p = down_W.dot(point_W(P));
    const Scalar low_q = down_W.dot(point_W(Q));
    if (low_p > low_q || low_q > low_p) return low_p > low_q;
    return batuta::detail::precedes(P.pair, Q.pair);
  };
  const auto end = order_.begin() + solved_count_;
  std::make_heap(order_.begin(), end, precedes);
  std::sort_heap(order_.begin(), end, precedes);
}

/// What gravity makes in half of what is left of the step, m/s, of what a contact gives to A, where
/// one of the two is led: between two that fall it is nothing.
template <class SceneT>
Vec3<Scalar_of<SceneT>> ContactGroups<SceneT>::carried_by(
    [[maybe_unused]] const BodiesT& bodies, [[maybe_unused]] const Contact& contact) const {
  Vec3<Scalar> carried_W = Vec3<Scalar>::Zero();
  if constexpr (SceneT::kGravity) {
    const bool led_A = bodies.is_led(a_of(contact));
    const Scalar half = (bodies.dt - bodies.now) / 2;
    if (led_A != bodies.is_led(b_of(contact))) {
      carried_W = (led_A ? half : -half) * bodies.settings.gravity_W;
    }
  }
  return carried_W;
}

/// The impulses of the last step, as far as they take energy: along their ray the energy is a
/// parabola (world.md, "Warm start"). @returns what that adds, J, <= 0
template <class SceneT>
Scalar_of<SceneT> ContactGroups<SceneT>::warm_up(const BodiesT& bodies, int first, int last) {
  const auto work = [&] {
    Scalar sum = 0;
    for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
      const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
      for (int i = 0; i < contact.count; ++i) {  // Bound: 2
        const auto& point = contact.points[static_cast<std::size_t>(i)];
        sum += power_of(point, solved_[a_of(contact)], solved_[b_of(contact)]);
      }
    }
    return sum;
  };
  const auto give = [&](Scalar share) {
    for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
      const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
      push_share(contact, solved_[a_of(contact)], solved_[b_of(contact)], share);
    }
  };
  constexpr Scalar kOfLift = Scalar(1) / 16;  // more than that throws up what they carry
  const Scalar slope = work();
  Scalar lift = 0;
  for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
    const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    const Vec3<Scalar> carried_W = carried_by(bodies, contact);
    for (int i = 0; i < contact.count; ++i) {  // Bound: 2
      lift += carried_W.dot(impulse_at(contact.points[static_cast<std::size_t>(i)]).J_W);
    }
  }
  give(Scalar(1));
  const Scalar bend = work() - slope;
  Scalar share = bend > Scalar(0) ? clamp(-slope / bend, Scalar(0), Scalar(1)) : Scalar(0);
  if (slope + lift + bend / 2 < kOfLift * lift) share = 1;
  if (share < Scalar(1)) give(share - 1);
  for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
    scale_impulses(contacts_[order_[static_cast<std::size_t>(k)]], share);
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
template <class SceneT>
template <class Change>
void ContactGroups<SceneT>::watch(Contact& contact, const Change& change) {
  const std::array<std::size_t, 2> slots = {a_of(contact), b_of(contact)};
  std::array<Vec3<Scalar>, 4> before;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    before[2 * i] = solved_[slots[i]].v_W;
    before[2 * i + 1] = solved_[slots[i]].w_W;
  }
  change(solved_[slots[0]], solved_[slots[1]]);
  const auto& point = contact.points[0];
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    const auto& solved = solved_[slots[i]];
    const Vec3<Scalar> arm_W = point.arm_A_W + (solved_[slots[0]].place_W - solved.place_W);
    const Scalar reach = arm_W.cwiseAbs().sum();
    changed_[slots[i]] += (solved.v_W - before[2 * i]).cwiseAbs().sum() +
                          reach * (solved.w_W - before[2 * i + 1]).cwiseAbs().sum();
  }
}

/// One visit. @param energy  what was added to that of the group so far, J, <= 0: the visit adds
/// its part  @returns the largest change along a normal, m/s
template <class SceneT>
Scalar_of<SceneT> ContactGroups<SceneT>::visit(Contact& contact, Scalar& energy,
                                               const Vec3<Scalar>& carried_W) {
  Scalar most = 0;
  watch(contact, [&](SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
    most = relax(contact, A, B, energy, carried_W);
  });
  return most;
}

/// One sweep, up or down. A contact whose bodies have changed by much less than what matters since
/// its last visit is passed over. @returns whether nothing changed by enough to matter
template <class SceneT>
bool ContactGroups<SceneT>::sweep_once(int first, int last, bool is_up, Scalar time,
                                       Scalar& energy) {
  constexpr Scalar kUnseen = Scalar(1) / 4;
  bool is_done = true;
  for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
    const int at = is_up ? k : last - 1 - (k - first);
    const std::size_t i = order_[static_cast<std::size_t>(at)];
    Contact& contact = contacts_[static_cast<int>(i)];
    const Scalar enough = least_change(contact, time);
    const Scalar changed = changed_[a_of(contact)] + changed_[b_of(contact)];
    if (!(changed - seen_[i] > kUnseen * enough)) continue;
    seen_[i] = changed;
    const Scalar change = visit(contact, energy, Vec3<Scalar>::Zero());
    is_done = is_done && !(change > enough);
  }
  return is_done;
}

/// Between two sweeps: on, the way that they lead (world.md, "Sweeps that are ahead").
/// @param led  how far the sweep before the last one has led, J; becomes that of the last one
template <class SceneT>
void ContactGroups<SceneT>::go_on_ahead(int first, int last, Scalar& led, Scalar& energy) {
  Scalar now = 0;
  for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
    now += led_by_sweep(contacts_[order_[static_cast<std::size_t>(k)]]);
  }
  const Scalar share = now < led ? now / led : Scalar(0);
  led = now;
  for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
    Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    watch(contact, [&](SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
      go_ahead(contact, A, B, share, energy);
    });
  }
}

/// Up and down, until nothing changes by enough to matter.
/// @param energy  what was added to that of the group so far, J, <= 0
template <class SceneT>
void ContactGroups<SceneT>::sweep(int first, int last, Scalar time, Scalar energy) {
  constexpr Scalar kNever = -std::numeric_limits<Scalar>::max();
  constexpr int kFew = 3;               // contacts: so few need nobody ahead
  for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
    const std::size_t i = order_[static_cast<std::size_t>(k)];
    seen_[i] = kNever;
    for (auto& point : contacts_[static_cast<int>(i)].points) {  // Bound: 2
      point.start = point.normal;
      point.ahead = 0;
    }
  }
  Scalar led = 0;
  for (int s = 0; s < kMaxSweeps; ++s) {  // Bound: kMaxSweeps
    if (sweep_once(first, last, s % 2 == 0, time, energy)) return;
    if (last - first > kFew && s + 1 < kMaxSweeps) go_on_ahead(first, last, led, energy);
  }
}

template <class SceneT>
void ContactGroups<SceneT>::solve(BodiesT& bodies) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.states[slot].present && first_of_[slot] != 0) load(bodies, slot);
  }
  choose(bodies);
  if (solved_count_ == 0) return;
  changed_.fill(0);
  order(bodies);
  const auto group_at = [&](int k) {
    const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    return root_of(bodies.is_led(a_of(contact)) ? b_of(contact) : a_of(contact));
  };
  for (int first = 0; first < solved_count_;) {  // Bound: kMaxContacts
    int last = first + 1;
    while (last < solved_count_ && group_at(last) == group_at(first)) ++last;  // Bound: as above
    sweep(first, last, bodies.dt, warm_up(bodies, first, last));
    first = last;
  }
  for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
    give(bodies, contacts_[order_[static_cast<std::size_t>(k)]]);
  }
  carry_loads(bodies, false);
  open(bodies);
}

/// What was solved goes into the momenta.
template <class SceneT>
void ContactGroups<SceneT>::give(BodiesT& bodies, const Contact& contact) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    give_at(bodies, contact, point, impulse_at(point));
  }
}

/// One impulse at one point, to both.
template <class SceneT>
void ContactGroups<SceneT>::give_at(BodiesT& bodies, const Contact& contact,
                                    const ContactPoint<Traits>& point,
                                    const PointImpulse<Scalar>& given) {
  const std::size_t a = a_of(contact);
  const std::size_t b = b_of(contact);
  if (!bodies.is_led(a)) {
    auto& momentum = bodies.actor(a).body.momentum;
    momentum.linear_W += given.J_W;
    momentum.angular_W += point.arm_A_W.cross(given.J_W) + given.rolling_W;
  }
  if (!bodies.is_led(b)) {
    auto& momentum = bodies.actor(b).body.momentum;
    momentum.linear_W -= given.J_W;
    momentum.angular_W -= arm_B(point, solved_[a], solved_[b]).cross(given.J_W) + given.rolling_W;
  }
}

/// Who is pressed, in a group that something holds, goes with the velocity of the step's end.
template <class SceneT>
void ContactGroups<SceneT>::carry_loads(BodiesT& bodies, bool dirty_only) {
  if constexpr (SceneT::kGravity) {
    unite(bodies, true);
    for (int i = 0; i < contacts_.size(); ++i) {  // Bound: kMaxContacts
      const Contact& contact = contacts_[i];
      if (!contact.is_solved || !is_loaded(contact)) continue;
      carry_load(bodies, a_of(contact), dirty_only);
      carry_load(bodies, b_of(contact), dirty_only);
    }
  }
}

template <class SceneT>
void ContactGroups<SceneT>::carry_load(BodiesT& bodies, std::size_t slot, bool dirty_only) {
  if (dirty_only && !is_dirty_[slot]) return;
  if (!bodies.is_led(slot) && held_[root_of(slot)]) bodies.states[slot].loaded = true;
}

}  // namespace batuta::detail
