// SPDX-License-Identifier: MIT
#pragma once
// Contacts that last, solved together, group by group, before anybody moves; and what a blow passes
// on through a group (src/world/world.md). One of the five that make a step (general_world.hpp);
// what it does with one contact: lasting_contact.hpp.

#include <algorithm>

#include "batuta/world/detail/lasting_contact.hpp"
#include "batuta/world/detail/pairs.hpp"

namespace batuta::detail {

template <class SceneT>
class ContactGroups {
 public:
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  using PairsT = Pairs<SceneT>;
  using Slot = std::uint16_t;
  using Contact = LastingContact<Scalar>;
  static constexpr int kNone = -1;

  /// Which pairs are near enough to last. Where there is no room for one, its bodies are welded.
  /// Bound: kMaxPairs.
  void find_near(BodiesT& bodies, PairsT& pairs);
  /// Solves what lasts, with the velocities of the step's end. Bound: kMaxSweeps sweeps.
  void solve(BodiesT& bodies);
  /// After a blow of a pair: what lasts of it, and passes on. Marks who has changed.
  /// Bound: kEventSweeps sweeps.
  template <class Blow>
  void pass_on(BodiesT& bodies, PairsT& pairs, ProxyPair pair, const Blow& blow);
  /// Contacts of a body that wakes within a step are solved from now on.
  void wake(std::size_t slot);
  /// Groups of bodies that press on each other, for group_of() and is_held().
  void group_all(const BodiesT& bodies) { unite(bodies, true); }
  /// The lowest body of the group. @pre group_all()
  std::size_t group_of(std::size_t slot) { return root_of(slot); }
  /// Whether something that is led carries the group of which the body is the lowest.
  bool is_held(std::size_t lowest) const { return held_[lowest]; }
  /// What was solved is what the next step starts from.
  void end_step();
  /// Calls begun(pair, contact, impulse) for each contact that presses for the first time.
  template <class Begun>
  void tell_begun(const Begun& begun);
  /// Whether a pair's contact was solved in this step, and presses.
  bool presses(ProxyPair pair) const {
    const int i = find(pair);
    return i != kNone && contacts_[i].is_solved && is_loaded(contacts_[i]);
  }

  /// The contact of a pair, or kNone. Bound: the contacts of one body.
  int find(ProxyPair pair) const;
  int size() const { return contacts_.size(); }
  const Contact& operator[](int i) const { return contacts_[i]; }
  /// Calls found(other body) for all that a body is near. Bound: its contacts.
  template <class Found>
  void for_each_neighbour(std::size_t slot, const Found& found) const;
  /// Forgets the contacts of a body.
  void remove(std::size_t slot);
  void copy(const ContactGroups& saved) { *this = saved; }
  template <class Archive>
  void archive(Archive& ar, const BodiesT& bodies);

 private:
  static constexpr std::size_t kSlots = BodiesT::kSlots;
  static constexpr int kMaxSweeps = 20;
  static constexpr int kEventSweeps = 8;
  static constexpr int kOpeningSweeps = 4;

  static std::size_t a_of(const Contact& contact) { return BodiesT::body_of(contact.pair.first); }
  static std::size_t b_of(const Contact& contact) { return BodiesT::body_of(contact.pair.second); }
  bool is_near(const BodiesT& bodies, PairsT& pairs, ProxyPair pair, Scalar D,
               ClosestPoints<Scalar>& axes, Capsule<Scalar>& A_W, Capsule<Scalar>& B_W) const;
  Contact* add(const BodiesT& bodies, ProxyPair pair, Scalar D);
  void drop_far(const BodiesT& bodies);
  void link_all();
  void link(int i);
  void load(const BodiesT& bodies, std::size_t slot);
  void choose(const BodiesT& bodies);
  Scalar rest_speed(const BodiesT& bodies) const;
  void order(const BodiesT& bodies);
  std::size_t root_of(std::size_t slot);
  void unite(const BodiesT& bodies, bool loaded_only);
  void warm_up(int first, int last);
  void sweep(int first, int last, Scalar time);
  void give(BodiesT& bodies, const Contact& contact);
  void open(BodiesT& bodies);
  void carry_loads(BodiesT& bodies, bool dirty_only);
  bool is_worth(const Contact& contact, Scalar least) const;
  void refresh(BodiesT& bodies, Contact& contact);
  void relax_now(BodiesT& bodies, Contact& contact);
  template <class Blow>
  void pass_blow(BodiesT& bodies, Contact& contact, const Blow& blow);
  void mark(BodiesT& bodies, std::size_t slot);
  void end_opening(BodiesT& bodies, std::size_t slot);
  bool is_welded(const BodiesT& bodies, const Contact& contact) const {
    return bodies.states[a_of(contact)].group != BodiesT::kAlone ||
           bodies.states[b_of(contact)].group != BodiesT::kAlone;
  }
  static bool is_loaded(const Contact& contact) {
    return contact.points[0].normal > Scalar(0) ||
           (contact.count > 1 && contact.points[1].normal > Scalar(0));
  }

  FixedList<Contact, SceneT::kMaxContacts> contacts_;
  std::array<SolvedBody<Scalar>, kSlots> solved_{};
  std::array<Slot, kSlots> first_of_{};  ///< of a body's contacts, + 1; 0: none
  std::array<std::array<Slot, 2>, static_cast<std::size_t>(SceneT::kMaxContacts)> next_{};
  std::array<Slot, static_cast<std::size_t>(SceneT::kMaxContacts)> order_{};
  std::array<Slot, kSlots> root_{};
  std::array<bool, kSlots> held_{};  ///< of a root: something in its group is led
  /// The root of its group when gaps were opened; kSlots: in none, or in one that is held.
  std::array<Slot, kSlots> afloat_{};
  FixedList<Slot, SceneT::kMaxBodies> dirty_;
  std::array<bool, kSlots> is_dirty_{};
  int solved_count_ = 0;
};

// --- which contacts there are

template <class SceneT>
int ContactGroups<SceneT>::find(ProxyPair pair) const {
  const std::size_t a = BodiesT::body_of(pair.first);
  int next = first_of_[a];
  while (next != 0) {  // Bound: the contacts of a body
    const Contact& contact = contacts_[next - 1];
    if (is_same(contact.pair, pair)) return next - 1;
    next = next_[static_cast<std::size_t>(next - 1)][a_of(contact) == a ? 0 : 1];
  }
  return kNone;
}

template <class SceneT>
template <class Found>
void ContactGroups<SceneT>::for_each_neighbour(std::size_t slot, const Found& found) const {
  int next = first_of_[slot];
  while (next != 0) {  // Bound: the contacts of a body
    const Contact& contact = contacts_[next - 1];
    const bool is_first = a_of(contact) == slot;
    found(is_first ? b_of(contact) : a_of(contact));
    next = next_[static_cast<std::size_t>(next - 1)][is_first ? 0 : 1];
  }
}

template <class SceneT>
void ContactGroups<SceneT>::link(int i) {
  const Contact& contact = contacts_[i];
  auto& next = next_[static_cast<std::size_t>(i)];
  next = {first_of_[a_of(contact)], first_of_[b_of(contact)]};
  first_of_[a_of(contact)] = first_of_[b_of(contact)] = static_cast<Slot>(i + 1);
}

template <class SceneT>
void ContactGroups<SceneT>::link_all() {
  first_of_.fill(0);
  for (int i = 0; i < contacts_.size(); ++i) link(i);  // Bound: kMaxContacts
}

/// The normal that was known may tell already that a pair is not near.
template <class SceneT>
bool ContactGroups<SceneT>::is_near(const BodiesT& bodies, PairsT& pairs, ProxyPair pair, Scalar D,
                                    ClosestPoints<Scalar>& axes, Capsule<Scalar>& A_W,
                                    Capsule<Scalar>& B_W) const {
  constexpr Scalar kBeyondRounding = Scalar(1.01);
  A_W = bodies.shape_W(pair.first);
  B_W = bodies.shape_W(pair.second);
  const Vec3<Scalar> n = pairs.seed(pair);
  if (!is_zero(n)) {
    const Vec3<Scalar>& o = A_W.axis.a;
    const Scalar low = min_of(n.dot(B_W.axis.a - o), n.dot(B_W.axis.b - o));
    const Scalar high = max_of(Scalar(0), n.dot(A_W.axis.b - o));
    if (low - high - A_W.radius - B_W.radius > kBeyondRounding * D) return false;
  }
  axes = closest_points(A_W.axis, B_W.axis);
  pairs.keep_seed(pair, axes.normal_AB);
  return !(axes.distance - A_W.radius - B_W.radius > D);
}

/// Null: there is no room.
template <class SceneT>
typename ContactGroups<SceneT>::Contact* ContactGroups<SceneT>::add(const BodiesT& bodies,
                                                                    ProxyPair pair, Scalar D) {
  int i = find(pair);
  if (i == kNone) {
    Contact contact;
    contact.pair = pair;
    if (!contacts_.push(contact)) return nullptr;
    i = contacts_.size() - 1;
    link(i);
  }
  Contact& contact = contacts_[i];
  const auto& P = bodies.actor(a_of(contact));
  const auto& Q = bodies.actor(b_of(contact));
  if constexpr (SceneT::kFriction) contact.friction = pair_friction(P.friction, Q.friction);
  if constexpr (SceneT::kRollingResistance) {
    contact.rolling = pair_rolling(P.rolling_resistance, Q.rolling_resistance);
  }
  contact.rest_gap = D;
  contact.is_kept = true;
  return &contact;
}

template <class SceneT>
void ContactGroups<SceneT>::find_near(BodiesT& bodies, PairsT& pairs) {
  for (int i = 0; i < contacts_.size(); ++i) contacts_[i].is_kept = false;  // Bound: kMaxContacts
  for (int i = 0; i < pairs.candidates.size(); ++i) {                       // Bound: kMaxPairs
    const ProxyPair pair = pairs.candidates[i].pair;
    const std::size_t a = BodiesT::body_of(pair.first);
    const std::size_t b = BodiesT::body_of(pair.second);
    const Scalar D = pairs.rest_gap(bodies, pair);
    ClosestPoints<Scalar> axes;
    Capsule<Scalar> A_W;
    Capsule<Scalar> B_W;
    if (!is_near(bodies, pairs, pair, D, axes, A_W, B_W)) continue;
    const Scalar gap = axes.distance - A_W.radius - B_W.radius;
    if (gap < Scalar(0)) {
      ++bodies.report.overlaps_at_start;
      bodies.report.deepest_overlap = max_of(bodies.report.deepest_overlap, -gap);
    }
    Contact* contact = add(bodies, pair, D);
    if (contact == nullptr) {
      ++bodies.report.contacts_dropped;
      bodies.weld(a, b, bodies.dt);
      continue;
    }
    contact->is_new = !contact->is_solved;
    find_points(*contact, A_W, B_W, axes, SceneT::kLineContact);
  }
  drop_far(bodies);
}

/// Pairs of which neither moves were not looked at, and stay as they are.
template <class SceneT>
void ContactGroups<SceneT>::drop_far(const BodiesT& bodies) {
  const auto rests = [&bodies](std::size_t slot) {
    return bodies.states[slot].asleep || bodies.is_wall(slot);
  };
  for (int i = contacts_.size() - 1; i >= 0; --i) {  // Bound: kMaxContacts
    Contact& contact = contacts_[i];
    const bool sleeps = rests(a_of(contact)) && rests(b_of(contact));
    if (!contact.is_kept && !sleeps) contacts_.remove_swapping(i);
  }
  link_all();
}

template <class SceneT>
void ContactGroups<SceneT>::remove(std::size_t slot) {
  for (int i = contacts_.size() - 1; i >= 0; --i) {  // Bound: kMaxContacts
    if (a_of(contacts_[i]) == slot || b_of(contacts_[i]) == slot) contacts_.remove_swapping(i);
  }
  link_all();
}

// --- solving them

template <class SceneT>
void ContactGroups<SceneT>::load(const BodiesT& bodies, std::size_t slot) {
  SolvedBody<Scalar>& solved = solved_[slot];
  const auto& body = bodies.actor(slot).body;
  const auto& state = bodies.states[slot];
  if (state.asleep) {
    solved = {};
  } else if (bodies.is_led(slot)) {
    solved = {};
    solved.v_W = state.plan.motion.twist.v_W;
    solved.w_W = state.plan.motion.twist.w_W;
  } else {
    const Twist<Scalar> twist = twist_of(body);
    solved = {twist.v_W, twist.w_W, inverse_inertia_W(body), body.inverse_mass};
  }
}

template <class SceneT>
Scalar_of<SceneT> ContactGroups<SceneT>::rest_speed(const BodiesT& bodies) const {
  Scalar speed = bodies.settings.rest_speed;
  if constexpr (SceneT::kGravity) {
    speed = max_of(speed, bodies.dt * length(bodies.settings.gravity_W));
  }
  return speed;
}

/// A contact lasts unless it is a blow: by the velocities before gravity, faster than rest. One
/// that lasted goes on unless it is faster than that by kSurely.
template <class SceneT>
void ContactGroups<SceneT>::choose(const BodiesT& bodies) {
  constexpr Scalar kSurely = 4;
  const Scalar rest = rest_speed(bodies);
  solved_count_ = 0;
  for (int i = 0; i < contacts_.size(); ++i) {  // Bound: kMaxContacts
    Contact& contact = contacts_[i];
    const std::size_t a = a_of(contact);
    const std::size_t b = b_of(contact);
    contact.is_solved = false;
    if (!contact.is_kept || (bodies.is_led(a) && bodies.is_led(b))) continue;
    if (bodies.states[a].group != BodiesT::kAlone || bodies.states[b].group != BodiesT::kAlone)
      continue;
    prepare(contact, solved_[a], solved_[b], position_of(bodies.actor(a)),
            position_of(bodies.actor(b)), bodies.dt);
    Scalar approach = fastest_approach(contact, solved_[a], solved_[b]);
    if constexpr (SceneT::kGravity) {
      const Scalar fall = bodies.dt * contact.points[0].normal_W.dot(bodies.settings.gravity_W);
      if (bodies.falls(a)) approach -= fall;
      if (bodies.falls(b)) approach += fall;
    }
    bool bounces = false;
    if constexpr (SceneT::kRestitution) {
      const Scalar limit = contact.is_new ? rest : kSurely * rest;
      bounces = approach < -limit && pair_restitution(bodies.actor(a).restitution,
                                                      bodies.actor(b).restitution) > Scalar(0);
    }
    contact.is_solved = !bounces;
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
      const std::size_t a = a_of(contact);
      const std::size_t b = b_of(contact);
      const bool led_a = bodies.is_led(a);
      const bool led_b = bodies.is_led(b);
      if (pass == 1) {
        if (led_a) held_[root_of(b)] = true;
        if (led_b) held_[root_of(a)] = true;
      } else if (!led_a && !led_b) {
        const std::size_t p = root_of(a);
        const std::size_t q = root_of(b);
        root_[max_of(p, q)] = static_cast<Slot>(min_of(p, q));
      }
    }
  }
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
    const Scalar low_p = down_W.dot(P.points[0].point_W);
    const Scalar low_q = down_W.dot(Q.points[0].point_W);
    if (low_p > low_q || low_q > low_p) return low_p > low_q;
    return batuta::detail::precedes(P.pair, Q.pair);
  };
  const auto end = order_.begin() + solved_count_;
  std::make_heap(order_.begin(), end, precedes);
  std::sort_heap(order_.begin(), end, precedes);
}

/// The impulses of the last step, as far as they take energy: along their ray the energy is a
/// parabola, and its least is taken (world.md, "Warm start").
template <class SceneT>
void ContactGroups<SceneT>::warm_up(int first, int last) {
  const auto work = [&] {
    Scalar sum = 0;
    for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
      const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
      for (int i = 0; i < contact.count; ++i) {  // Bound: 2
        const auto& point = contact.points[static_cast<std::size_t>(i)];
        const auto u = velocity_across(point, solved_[a_of(contact)], solved_[b_of(contact)]);
        sum += impulse_of(point).dot(u) + point.normal * point.room;
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
  const Scalar slope = work();
  give(Scalar(1));
  const Scalar bend = work() - slope;
  const Scalar share = bend > Scalar(0) ? clamp(-slope / bend, Scalar(0), Scalar(1)) : Scalar(0);
  if (share < Scalar(1)) give(share - 1);
  for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
    scale_impulses(contacts_[order_[static_cast<std::size_t>(k)]], share);
  }
}

/// Up and down, until nothing changes by enough to matter.
template <class SceneT>
void ContactGroups<SceneT>::sweep(int first, int last, Scalar time) {
  constexpr Scalar kEnough = Scalar(1) / 32;  // of D, in what is left of the step
  for (int s = 0; s < kMaxSweeps; ++s) {      // Bound: kMaxSweeps
    bool is_done = true;
    for (int k = first; k < last; ++k) {  // Bound: kMaxContacts
      const int at = s % 2 == 0 ? k : last - 1 - (k - first);
      Contact& contact = contacts_[order_[static_cast<std::size_t>(at)]];
      const Scalar change = relax(contact, solved_[a_of(contact)], solved_[b_of(contact)]);
      is_done = is_done && !(change > kEnough * contact.rest_gap / time);
    }
    if (is_done) return;
  }
}

template <class SceneT>
void ContactGroups<SceneT>::solve(BodiesT& bodies) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.states[slot].present && first_of_[slot] != 0) load(bodies, slot);
  }
  choose(bodies);
  if (solved_count_ == 0) return;
  order(bodies);
  const auto group_at = [&](int k) {
    const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    return root_of(bodies.is_led(a_of(contact)) ? b_of(contact) : a_of(contact));
  };
  for (int first = 0; first < solved_count_;) {  // Bound: kMaxContacts
    int last = first + 1;
    while (last < solved_count_ && group_at(last) == group_at(first)) ++last;
    warm_up(first, last);
    sweep(first, last, bodies.dt);
    first = last;
  }
  for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
    give(bodies, contacts_[order_[static_cast<std::size_t>(k)]]);
  }
  carry_loads(bodies, false);
  open(bodies);
}

/// What was solved goes into the momenta: one impulse at one point, to both.
template <class SceneT>
void ContactGroups<SceneT>::give(BodiesT& bodies, const Contact& contact) {
  const std::size_t a = a_of(contact);
  const std::size_t b = b_of(contact);
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    const Vec3<Scalar> J = impulse_of(point);
    if (!bodies.is_led(a)) {
      auto& momentum = bodies.actor(a).body.momentum;
      momentum.linear_W += J;
      momentum.angular_W += point.arm_A_W.cross(J) + point.rolling_W;
    }
    if (!bodies.is_led(b)) {
      auto& momentum = bodies.actor(b).body.momentum;
      momentum.linear_W -= J;
      momentum.angular_W -= point.arm_B_W.cross(J) + point.rolling_W;
    }
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
      for (const std::size_t slot : {a_of(contact), b_of(contact)}) {  // Bound: 2
        if (dirty_only && !is_dirty_[slot]) continue;
        if (!bodies.is_led(slot) && held_[root_of(slot)]) bodies.states[slot].loaded = true;
      }
    }
  }
}

/// A velocity for one step that opens the gaps of contacts that press.
template <class SceneT>
void ContactGroups<SceneT>::open(BodiesT& bodies) {
  constexpr Scalar kNarrow = Scalar(0.4);  // of D
  bool is_needed = false;
  for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
    const Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    for (int i = 0; i < contact.count; ++i) {  // Bound: 2
      const auto& point = contact.points[static_cast<std::size_t>(i)];
      is_needed = is_needed || (point.normal > Scalar(0) && point.gap < kNarrow * contact.rest_gap);
    }
  }
  afloat_.fill(static_cast<Slot>(kSlots));
  if (!is_needed) return;
  unite(bodies, false);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!held_[root_of(slot)]) afloat_[slot] = static_cast<Slot>(root_of(slot));
  }
  for (int s = 0; s < kOpeningSweeps; ++s) {   // Bound: kOpeningSweeps
    for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
      Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
      std::array<SolvedBody<Scalar>, 2> sides;
      for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
        const std::size_t slot = i == 0 ? a_of(contact) : b_of(contact);
        sides[i] = solved_[slot];
        sides[i].v_W = bodies.states[slot].opening.v_W;
        sides[i].w_W = bodies.states[slot].opening.w_W;
      }
      relax_opening(contact, sides[0], sides[1], bodies.dt);
      bodies.states[a_of(contact)].opening = {sides[0].v_W, sides[0].w_W};
      bodies.states[b_of(contact)].opening = {sides[1].v_W, sides[1].w_W};
    }
  }
}

// --- passing on

/// An opening ends for a whole group that nothing holds: one that ended for some of it would move
/// the common centre.
template <class SceneT>
void ContactGroups<SceneT>::end_opening(BodiesT& bodies, std::size_t slot) {
  const auto end = [&bodies](std::size_t k) {
    auto& state = bodies.states[k];
    if (is_zero(state.opening.v_W) && is_zero(state.opening.w_W)) return;
    bodies.bring(k);
    state.opening = {};
    state.changed = bodies.is_changed = true;
  };
  end(slot);
  if (afloat_[slot] == kSlots) return;
  for (std::size_t k = 0; k < kSlots; ++k) {  // Bound: kMaxBodies
    if (afloat_[k] == afloat_[slot]) end(k);
  }
}

template <class SceneT>
void ContactGroups<SceneT>::mark(BodiesT& bodies, std::size_t slot) {
  if (is_dirty_[slot]) return;
  if (bodies.is_led(slot)) return load(bodies, slot);
  is_dirty_[slot] = true;
  dirty_.push(static_cast<Slot>(slot));
  bodies.bring(slot);
  bodies.states[slot].changed = bodies.is_changed = true;
  end_opening(bodies, slot);
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
  find_points(contact, A_W, B_W, closest_points(A_W.axis, B_W.axis), SceneT::kLineContact);
  prepare(contact, solved_[a], solved_[b], bodies.place_now(a), bodies.place_now(b), left);
  contact.is_solved = true;
}

/// Whether a contact is approached, or pulls, by more than matters in what is left of the step.
template <class SceneT>
bool ContactGroups<SceneT>::is_worth(const Contact& contact, Scalar least) const {
  bool is_worth = false;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar u =
        point.normal_W.dot(velocity_across(point, solved_[a_of(contact)], solved_[b_of(contact)])) +
        point.room;
    is_worth = is_worth || u < -least || (u > least && point.normal > Scalar(0));
  }
  return is_worth;
}

template <class SceneT>
void ContactGroups<SceneT>::relax_now(BodiesT& bodies, Contact& contact) {
  const std::size_t a = a_of(contact);
  const std::size_t b = b_of(contact);
  Contact before = contact;
  relax(contact, solved_[a], solved_[b]);
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& old = before.points[static_cast<std::size_t>(i)];
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    old.normal = point.normal - old.normal;
    old.along = point.along - old.along;
    old.across = point.across - old.across;
    old.rolling_W = point.rolling_W - old.rolling_W;
  }
  give(bodies, before);
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
  }
}

template <class SceneT>
void ContactGroups<SceneT>::wake(std::size_t slot) {
  int next = first_of_[slot];
  while (next != 0) {  // Bound: the contacts of a body
    Contact& contact = contacts_[next - 1];
    next = next_[static_cast<std::size_t>(next - 1)][a_of(contact) == slot ? 0 : 1];
    if (contact.is_solved) continue;
    scale_impulses(contact, Scalar(0));
    contact.since = -1;  // its points have to be found anew
    contact.is_solved = true;
  }
}

template <class SceneT>
template <class Begun>
void ContactGroups<SceneT>::tell_begun(const Begun& begun) {
  for (int k = 0; k < solved_count_; ++k) {  // Bound: kMaxContacts
    Contact& contact = contacts_[order_[static_cast<std::size_t>(k)]];
    if (contact.is_told || !is_loaded(contact)) continue;
    contact.is_told = true;
    const auto& point = contact.points[0];
    begun(contact.pair, batuta::Contact<Scalar>{point.point_W, point.normal_W, point.gap},
          point.normal);
  }
}

template <class SceneT>
void ContactGroups<SceneT>::end_step() {
  for (int i = 0; i < contacts_.size(); ++i) {  // Bound: kMaxContacts
    Contact& contact = contacts_[i];
    take_together(contact);
    contact.since = 0;
  }
}

/// What the next step starts from: who touches, where, and how hard they pressed.
template <class SceneT>
template <class Archive>
void ContactGroups<SceneT>::archive(Archive& ar, const BodiesT& bodies) {
  ar(contacts_);
  if (!ar.reading()) return;
  for (int i = contacts_.size() - 1; i >= 0; --i) {  // Bound: kMaxContacts
    const ProxyPair pair = contacts_[i].pair;
    const auto is_there = [&bodies](int proxy) {
      return bodies.actors.at_index(BodiesT::body_of(proxy)) != nullptr;
    };
    const bool good = pair.first < pair.second && pair.second < BodiesT::kProxies &&
                      contacts_[i].count <= 2 && is_there(pair.first) && is_there(pair.second);
    ar.require(good);
    if (!good) contacts_.remove_swapping(i);
  }
  link_all();
}

template <class SceneT>
template <class Blow>
void ContactGroups<SceneT>::pass_on(BodiesT& bodies, PairsT& pairs, ProxyPair pair,
                                    const Blow& blow) {
  constexpr Scalar kLeast = Scalar(1) / 8;  // of D, in what is left of the step
  constexpr Scalar kLeastOfStruck = Scalar(1) / 64;
  const Scalar left = bodies.dt - bodies.now;
  dirty_.clear();
  is_dirty_.fill(false);
  Contact* struck = add(bodies, pair, pairs.rest_gap(bodies, pair));
  if (struck == nullptr) {
    ++bodies.report.contacts_dropped;
    bodies.weld(BodiesT::body_of(pair.first), BodiesT::body_of(pair.second), bodies.dt);
    return;
  }
  refresh(bodies, *struck);
  relax_now(bodies, *struck);
  bool is_done = false;
  for (int s = 0; s < kEventSweeps && !is_done; ++s) {
    is_done = true;                            // Bound: kEventSweeps
    for (int d = 0; d < dirty_.size(); ++d) {  // Bound: kMaxBodies
      const std::size_t slot = dirty_[d];
      int next = first_of_[slot];
      while (next != 0) {  // Bound: the contacts of a body
        Contact& contact = contacts_[next - 1];
        next = next_[static_cast<std::size_t>(next - 1)][a_of(contact) == slot ? 0 : 1];
        if (!contact.is_solved || is_welded(bodies, contact)) continue;
        const Scalar share = &contact == struck ? kLeastOfStruck : kLeast;
        if (!is_worth(contact, share * contact.rest_gap / left)) continue;
        is_done = false;
        if (contact.since < bodies.now) refresh(bodies, contact);
        mark(bodies, a_of(contact));
        mark(bodies, b_of(contact));
        if (&contact != struck) pass_blow(bodies, contact, blow);
        relax_now(bodies, contact);
      }
    }
  }
  if constexpr (SceneT::kGravity) {
    for (const Slot slot : dirty_) bodies.states[slot].loaded = false;  // Bound: kMaxBodies
    carry_loads(bodies, true);
  }
}

}  // namespace batuta::detail
