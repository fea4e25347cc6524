// SPDX-License-Identifier: MIT
#pragma once
// Contacts that last, solved together, group by group, before anybody moves; and what a blow passes
// on through a group (src/world/world.md). One of the five that make a step (general_world.hpp);
// what it does with one contact: lasting_contact.hpp.

#include <algorithm>

#include "batuta/world/detail/lasting_contact.hpp"
#include "batuta/world/detail/pairs.hpp"

namespace batuta::detail {

/// A contact that was answered, and is not passed on yet.
template <class Scalar>
struct StruckPair {
  ProxyPair pair;
  batuta::Contact<Scalar> contact;
  Scalar contact_gap = 0;  ///< of its search, m
};

/// In the place of a collaborator that a scene does without.
template <int kNumber>
struct NoCollaborator {};

template <class SceneT>
class ContactGroups {
 public:
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  using PairsT = Pairs<SceneT>;
  using Slot = std::uint16_t;
  using Traits =
      ContactTraits<Scalar, SceneT::kFriction, SceneT::kRollingResistance, SceneT::kLineContact>;
  using Contact = LastingContact<Traits>;
  static constexpr int kNone = -1;

  /// Which pairs are near enough to last. Where there is no room for one, its bodies are welded.
  /// Bound: kMaxPairs.
  void find_near(BodiesT& bodies, PairsT& pairs);
  /// Solves what lasts, with the velocities of the step's end. Bound: kMaxSweeps sweeps.
  void solve(BodiesT& bodies);
  /// After blows of pairs: what lasts of them, and passes on. Marks who has changed.
  /// Bound: kEventSweeps sweeps.
  template <class Struck, class Blow>
  void pass_on(BodiesT& bodies, const Struck& struck, const Blow& blow);
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
  /// The largest D of a body's contacts, m; 0: it has none. Bound: its contacts.
  Scalar widest_rest_gap(std::size_t slot) const {
    Scalar widest = 0;
    for (int next = first_of_[slot]; next != 0;) {  // Bound: the contacts of a body
      const Contact& contact = contacts_[next - 1];
      widest = max_of(widest, contact.rest_gap);
      next = next_[static_cast<std::size_t>(next - 1)][a_of(contact) == slot ? 0 : 1];
    }
    return widest;
  }
  /// Whether contacts that were solved lead from the body to something that is led. Bound: its
  /// contacts.
  bool is_held_up(std::size_t slot) const {
    bool is_held = false;
    for (int next = first_of_[slot]; next != 0;) {  // Bound: the contacts of a body
      const Contact& contact = contacts_[next - 1];
      is_held = is_held || (contact.is_solved && contact.is_held);
      next = next_[static_cast<std::size_t>(next - 1)][a_of(contact) == slot ? 0 : 1];
    }
    return is_held;
  }
  /// Forgets the contacts of a body.
  void remove(std::size_t slot);
  void copy(const ContactGroups& saved) { *this = saved; }
  template <class Archive>
  void archive(Archive& ar, const BodiesT& bodies);

 private:
  static constexpr std::size_t kSlots = BodiesT::kSlots;
  static constexpr int kMaxSweeps = 60;
  static constexpr int kEventSweeps = 32;
  /// Added to what visits changed of a body where something else changed it, m/s.
  static constexpr Scalar kNoticed = 1;
  static constexpr int kOpeningSweeps = 8;

  static std::size_t a_of(const Contact& contact) { return BodiesT::body_of(contact.pair.first); }
  static std::size_t b_of(const Contact& contact) { return BodiesT::body_of(contact.pair.second); }
  /// A pair where it is.
  struct NearPair {
    ClosestPoints<Scalar> axes;
    Capsule<Scalar> A_W;
    Capsule<Scalar> B_W;
  };
  bool is_near(const BodiesT& bodies, PairsT& pairs, ProxyPair pair, Scalar D,
               NearPair& near) const;
  Contact* add(const BodiesT& bodies, ProxyPair pair, Scalar D);
  void drop_far(const BodiesT& bodies);
  void link_all();
  void link(int i);
  void load(const BodiesT& bodies, std::size_t slot);
  void choose(const BodiesT& bodies);
  bool may_last(const BodiesT& bodies, const Contact& contact) const;
  bool bounces(const BodiesT& bodies, const Contact& contact, Scalar rest) const;
  Scalar rest_speed(const BodiesT& bodies) const;
  void order(const BodiesT& bodies);
  std::size_t root_of(std::size_t slot);
  void unite(const BodiesT& bodies, bool loaded_only);
  void join(const BodiesT& bodies, const Contact& contact);
  void hold(const BodiesT& bodies, const Contact& contact);
  Scalar warm_up(const BodiesT& bodies, int first, int last);
  Scalar visit(Contact& contact, Scalar& energy, const Vec3<Scalar>& carried_W);
  Vec3<Scalar> carried_by(const BodiesT& bodies, const Contact& contact) const;
  template <class Change>
  void watch(Contact& contact, const Change& change);
  bool sweep_once(int first, int last, bool is_up, Scalar time, Scalar& energy);
  void go_on_ahead(int first, int last, Scalar& led, Scalar& energy);
  void sweep(int first, int last, Scalar time, Scalar energy);
  void give(BodiesT& bodies, const Contact& contact);
  void give_at(BodiesT& bodies, const Contact& contact, const ContactPoint<Traits>& point,
               const PointImpulse<Scalar>& given);
  void open(BodiesT& bodies);
  bool is_opening_needed() const;
  void find_held(const BodiesT& bodies);
  Scalar visit_opening(BodiesT& bodies, Contact& contact, Scalar share);
  Scalar share_to_open(const BodiesT& bodies, const Contact& contact) const;
  void carry_loads(BodiesT& bodies, bool dirty_only);
  void carry_load(BodiesT& bodies, std::size_t slot, bool dirty_only);
  Scalar may_close(const BodiesT& bodies, const Contact& contact, Scalar gap, Scalar share) const;
  bool is_settled(const BodiesT& bodies, const Contact& contact, Scalar changed,
                  Scalar share) const;
  bool is_worth(const BodiesT& bodies, const Contact& contact, Scalar share, bool is_struck) const;
  void refresh(BodiesT& bodies, Contact& contact);
  void relax_now(BodiesT& bodies, Contact& contact, Scalar& energy);
  template <class Blow>
  void pass_blow(BodiesT& bodies, Contact& contact, const Blow& blow);
  template <class Blow>
  void pass_around(BodiesT& bodies, int parts, Scalar energy, const Blow& blow);
  template <class Blow>
  void pass_at(BodiesT& bodies, int i, int parts, Scalar& energy, const Blow& blow);
  bool is_due(BodiesT& bodies, std::size_t i);
  void mark(BodiesT& bodies, std::size_t slot);
  bool is_welded(const BodiesT& bodies, const Contact& contact) const {
    return bodies.states[a_of(contact)].group != BodiesT::kAlone ||
           bodies.states[b_of(contact)].group != BodiesT::kAlone;
  }
  /// Its first point. @pre its points are those of where its bodies are
  Vec3<Scalar> point_W(const Contact& contact) const {
    return solved_[a_of(contact)].place_W + contact.points[0].arm_A_W;
  }
  static bool is_loaded(const Contact& contact) {
    return contact.points.front().normal > Scalar(0) ||
           (contact.count > 1 && contact.points.back().normal > Scalar(0));
  }

  FixedList<Contact, SceneT::kMaxContacts> contacts_;
  std::array<SolvedBody<Scalar>, kSlots> solved_{};
  std::array<Slot, kSlots> first_of_{};  ///< of a body's contacts, + 1; 0: none
  std::array<std::array<Slot, 2>, static_cast<std::size_t>(SceneT::kMaxContacts)> next_{};
  std::array<Slot, static_cast<std::size_t>(SceneT::kMaxContacts)> order_{};
  std::array<Slot, kSlots> root_{};
  std::array<bool, kSlots> held_{};       ///< of a root: something in its group is led
  std::array<Scalar, kSlots> changed_{};  ///< sum of what visits changed of a body, m/s
  /// Of both bodies of a contact together, when it was visited last.
  std::array<Scalar, static_cast<std::size_t>(SceneT::kMaxContacts)> seen_{};
  FixedList<Slot, SceneT::kMaxBodies> dirty_;
  std::array<bool, kSlots> is_dirty_{};
  std::array<bool, static_cast<std::size_t>(SceneT::kMaxContacts)> is_struck_{};
  int solved_count_ = 0;
};

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
                                    NearPair& near) const {
  constexpr Scalar kBeyondRounding = Scalar(1.01);
  Capsule<Scalar>& A_W = near.A_W;
  Capsule<Scalar>& B_W = near.B_W;
  A_W = bodies.shape_W(pair.first);
  B_W = bodies.shape_W(pair.second);
  const Vec3<Scalar> n = pairs.seed(pair);
  if (!is_zero(n)) {
    const Vec3<Scalar>& o = A_W.axis.a;
    const Scalar low = min_of(n.dot(B_W.axis.a - o), n.dot(B_W.axis.b - o));
    const Scalar high = max_of(Scalar(0), n.dot(A_W.axis.b - o));
    if (low - high - A_W.radius - B_W.radius > kBeyondRounding * D) return false;
  }
  near.axes = closest_points(A_W.axis, B_W.axis);
  pairs.keep_seed(pair, near.axes.normal_AB);
  return !(near.axes.distance - A_W.radius - B_W.radius > D);
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
    const Scalar D = rest_gap(bodies, pair);
    NearPair near;
    if (!is_near(bodies, pairs, pair, D, near)) continue;
    const Scalar gap = near.axes.distance - near.A_W.radius - near.B_W.radius;
    if (gap < Scalar(0) && gap < -margin_at_start(bodies, pair)) {
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
    find_points(*contact, near.A_W, near.B_W, near.axes, position_of(bodies.actor(a)));
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
    const Contact& contact = contacts_[i];
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
    begun(contact.pair, batuta::Contact<Scalar>{point_W(contact), point.normal_W, point.gap},
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
                      contacts_[i].count <= Contact::kPoints && is_there(pair.first) &&
                      is_there(pair.second);
    ar.require(good);
    if (!good) contacts_.remove_swapping(i);
  }
  link_all();
}

}  // namespace batuta::detail

#include "batuta/world/detail/contact_opening.hpp"
#include "batuta/world/detail/contact_passing.hpp"
#include "batuta/world/detail/contact_solution.hpp"
