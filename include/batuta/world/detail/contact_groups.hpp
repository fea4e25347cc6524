// SPDX-License-Identifier: MIT
#pragma once
// Contacts that last, solved together, group by group, before anybody moves; and what a blow passes
// on through a group (src/world/world.md). One of the five that make a step (general_world.hpp);
// where contacts are kept: contact_list.hpp; what is done with one of them: lasting_contact.hpp.

#include <algorithm>

#include "batuta/world/detail/body_changes.hpp"
#include "batuta/world/detail/body_groups.hpp"
#include "batuta/world/detail/contact_list.hpp"
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
  using Contact = LastingContactOf<SceneT>;
  using Slot = std::uint16_t;
  static constexpr int kNone = ContactList<SceneT>::kNone;

  /// Which pairs are near enough to last. Where there is no room for one, its bodies are welded.
  /// Bound: kMaxPairs.
  void find_near(BodiesT& bodies, PairsT& pairs);
  /// Solves what lasts, with the velocities of the step's end. Bound: kMaxSweeps sweeps.
  void solve(BodiesT& bodies);
  /// After blows of pairs: what lasts of them, and passes on. Marks who has changed. Calls
  /// passing.blow(pair) to strike a neighbour, and passing.wake(slot) before a sleeper takes
  /// anything. Bound: kEventSweeps sweeps.
  template <class Struck, class Passing>
  void pass_on(BodiesT& bodies, const Struck& struck, const Passing& passing);
  /// Contacts of a body that wakes within a step are solved from now on.
  void wake(std::size_t slot);
  /// Groups of bodies that press on each other, for group_of() and is_held().
  void group_all(const BodiesT& bodies) { join_all(bodies, *this, true); }
  /// The lowest body of the group. @pre group_all()
  std::size_t group_of(std::size_t slot) { return joined.root_of(slot); }
  /// Whether something that is led carries the group of which the body is the lowest.
  bool is_held(std::size_t lowest) const { return joined.is_held(lowest); }
  /// What was solved is what the next step starts from.
  void end_step();
  /// Calls begun(pair, contact, impulse) for each contact that presses for the first time.
  template <class Begun>
  void tell_begun(const BodiesT& bodies, const Begun& begun);
  /// Whether a pair's contact was solved in this step, and presses.
  bool presses(ProxyPair pair) const {
    const int i = contacts.find(pair);
    return i != kNone && contacts[i].is_solved && is_loaded(contacts[i]);
  }
  /// The touch of a pair has ended: where its contact presses again, that is a begin.
  void tell_again(ProxyPair pair) {
    const int i = contacts.find(pair);
    if (i != kNone) contacts[i].is_told = false;
  }
  /// Forgets the contacts of a body.
  void remove(std::size_t slot);
  void copy(const ContactGroups& saved) { *this = saved; }
  /// What the next step starts from: who touches, where, and how hard they pressed.
  template <class Archive>
  void archive(Archive& ar, const BodiesT& bodies) {
    contacts.archive(ar, bodies);
  }

  /// The contact of a pair that is near. @param D  of the pair, m  @returns null: there is no room
  Contact* add(const BodiesT& bodies, ProxyPair pair, Scalar D);
  /// What is solved of a body begins with how it moves.
  void load(const BodiesT& bodies, std::size_t slot);
  /// Something else than a visit has changed a body: what touches it is to be looked at.
  void look_again(std::size_t slot);
  /// A body was shifted within the step. Where that was far, its contacts have their points where
  /// it was.
  void note_shift(const Body<Scalar>& body, std::size_t slot, const Vec3<Scalar>& shift_W);
  /// A body is not what its contacts were prepared for: whoever visits one finds its points anew.
  void prepare_again(std::size_t slot);
  /// The k-th of the contacts that are solved.
  Contact& solved_at(int k) { return contacts[order[static_cast<std::size_t>(k)]]; }
  const Contact& solved_at(int k) const { return contacts[order[static_cast<std::size_t>(k)]]; }

  ContactList<SceneT> contacts;
  /// Of contacts that are solved, in the order in which they are visited.
  std::array<Slot, static_cast<std::size_t>(SceneT::kMaxContacts)> order{};
  Slot solved_count = 0;
  BodyGroups<SceneT> joined;
  BodyChanges<SceneT> changes;
  std::array<SolvedBody<Scalar>, BodiesT::kSlots> solved{};
  /// Length of the step for which what stands was boxed, s; 0: anew. The boxes have D in them.
  Scalar boxed_for = 0;
};

/// Whether one of a contact's bodies goes with a group.
template <class SceneT>
bool is_welded(const Bodies<SceneT>& bodies, const LastingContactOf<SceneT>& contact) {
  return bodies.states[a_of<SceneT>(contact)].group != Bodies<SceneT>::kAlone ||
         bodies.states[b_of<SceneT>(contact)].group != Bodies<SceneT>::kAlone;
}

/// The first point of a contact. @pre its points are those of where its bodies are
template <class SceneT>
Vec3<Scalar_of<SceneT>> point_W(const ContactGroups<SceneT>& groups,
                                const LastingContactOf<SceneT>& contact) {
  return groups.solved[a_of<SceneT>(contact)].place_W + contact.points[0].arm_A_W;
}

/// A pair where it is.
template <class Scalar>
struct NearPair {
  ClosestPoints<Scalar> axes;
  Capsule<Scalar> A_W;
  Capsule<Scalar> B_W;
};

/// Whether a pair is within D. The normal that was known may tell already that it is not.
template <class SceneT>
bool is_near(const Bodies<SceneT>& bodies, Pairs<SceneT>& pairs, ProxyPair pair,
             Scalar_of<SceneT> D, NearPair<Scalar_of<SceneT>>& near) {
  using Scalar = Scalar_of<SceneT>;
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

/// What the two resist with. Where that has become less the impulses along it are cut as much: a
/// contact whose own limit is smaller than what it begins with would keep that.
template <class SceneT>
void set_friction([[maybe_unused]] LastingContactOf<SceneT>& contact,
                  [[maybe_unused]] const Actor<SceneT>& P,
                  [[maybe_unused]] const Actor<SceneT>& Q) {
  using Scalar = Scalar_of<SceneT>;
  if constexpr (SceneT::kFriction) {
    const Scalar friction = pair_friction(P.friction, Q.friction);
    if (friction < contact.friction) {
      for (auto& point : contact.points) {  // Bound: 2
        point.along *= friction / contact.friction;
        point.across *= friction / contact.friction;
      }
    }
    contact.friction = friction;
  }
  if constexpr (SceneT::kRollingResistance) {
    const Scalar rolling = pair_rolling(P.rolling_resistance, Q.rolling_resistance);
    if (rolling < contact.rolling) {
      // Bound: 2
      for (auto& point : contact.points) point.rolling_W *= rolling / contact.rolling;
    }
    contact.rolling = rolling;
  }
}

template <class SceneT>
typename ContactGroups<SceneT>::Contact* ContactGroups<SceneT>::add(const BodiesT& bodies,
                                                                    ProxyPair pair, Scalar D) {
  const int i = contacts.find_or_add(pair);
  if (i == kNone) return nullptr;
  Contact& contact = contacts[i];
  set_friction<SceneT>(contact, bodies.actor(a_of<SceneT>(contact)),
                       bodies.actor(b_of<SceneT>(contact)));
  contact.rest_gap = D;
  contact.is_kept = true;
  return &contact;
}

/// Pairs of which neither moves were not looked at, and stay as they are; but for those of which
/// neither can be moved: no pair will ever ask for them.
template <class SceneT>
void drop_far(const Bodies<SceneT>& bodies, ContactList<SceneT>& contacts) {
  using Kinematics = typename Bodies<SceneT>::Kinematics;
  const auto rests = [&bodies](std::size_t slot) {
    return bodies.states[slot].asleep || bodies.is_wall(slot);
  };
  const auto yields = [&bodies](std::size_t slot) {
    return !Kinematics::is_immovable(bodies.actor(slot).body);
  };
  contacts.remove_if([&](const LastingContactOf<SceneT>& contact) {
    const std::size_t a = a_of<SceneT>(contact);
    const std::size_t b = b_of<SceneT>(contact);
    return !contact.is_kept && !(rests(a) && rests(b) && (yields(a) || yields(b)));
  });
}

/// The list is full, maybe of contacts that are no more: forgets those of pairs that are not near,
/// among them those that have not been looked at yet. Bound: kMaxPairs.
template <class SceneT>
void make_room(const Bodies<SceneT>& bodies, Pairs<SceneT>& pairs, ContactList<SceneT>& contacts) {
  for (int i = 0; i < pairs.candidates.size(); ++i) {  // Bound: kMaxPairs
    const ProxyPair pair = pairs.candidates[i].pair;
    const int k = contacts.find(pair);
    if (k == ContactList<SceneT>::kNone || contacts[k].is_kept) continue;
    NearPair<Scalar_of<SceneT>> near;
    contacts[k].is_kept = is_near(bodies, pairs, pair, rest_gap(bodies, pair), near);
  }
  drop_far(bodies, contacts);
}

template <class SceneT>
void ContactGroups<SceneT>::find_near(BodiesT& bodies, PairsT& pairs) {
  bool is_room_made = false;
  for (int i = 0; i < contacts.size(); ++i) contacts[i].is_kept = false;  // Bound: kMaxContacts
  for (int i = 0; i < pairs.candidates.size(); ++i) {                     // Bound: kMaxPairs
    const ProxyPair pair = pairs.candidates[i].pair;
    const std::size_t a = BodiesT::body_of(pair.first);
    const std::size_t b = BodiesT::body_of(pair.second);
    const Scalar D = rest_gap(bodies, pair);
    NearPair<Scalar> near;
    if (!is_near(bodies, pairs, pair, D, near)) continue;
    const Scalar gap = near.axes.distance - near.A_W.radius - near.B_W.radius;
    if (gap < Scalar(0) && gap < -margin_at_start(bodies, pair)) {
      ++bodies.report.overlaps_at_start;
      bodies.report.deepest_overlap = max_of(bodies.report.deepest_overlap, -gap);
    }
    Contact* contact = add(bodies, pair, D);
    if (contact == nullptr && !is_room_made) {
      make_room(bodies, pairs, contacts);
      is_room_made = true;
      contact = add(bodies, pair, D);
    }
    if (contact == nullptr) {
      ++bodies.report.contacts_dropped;
      bodies.weld(a, b, bodies.dt);
      continue;
    }
    contact->is_new = !contact->is_solved;
    find_points(*contact, near.A_W, near.B_W, near.axes, position_of(bodies.actor(a)),
                off_middle(bodies, a, b));
  }
  drop_far(bodies, contacts);
}

template <class SceneT>
void ContactGroups<SceneT>::remove(std::size_t slot) {
  contacts.remove_if([&](const Contact& contact) {
    return a_of<SceneT>(contact) == slot || b_of<SceneT>(contact) == slot;
  });
}

template <class SceneT>
void ContactGroups<SceneT>::look_again(std::size_t slot) {
  // Bound: the contacts of a body.
  for (int i = contacts.first_of(slot); i != kNone; i = contacts.next_of(i, slot)) {
    changes.seen[static_cast<std::size_t>(i)] = BodyChanges<SceneT>::kNever;
  }
}

/// A shift by more than an eighth of the body's least radius of gyration, sqrt(I / m).
template <class Scalar>
bool changes_arms(const Body<Scalar>& body, const Vec3<Scalar>& shift_W) {
  constexpr Scalar kShares = 8;
  const Scalar shares = kShares * length(shift_W);
  return shares * shares * body.inverse_moments.maxCoeff() > body.inverse_mass;
}

template <class SceneT>
void ContactGroups<SceneT>::note_shift(const Body<Scalar>& body, std::size_t slot,
                                       const Vec3<Scalar>& shift_W) {
  if (changes_arms(body, shift_W)) prepare_again(slot);
}

template <class SceneT>
void ContactGroups<SceneT>::prepare_again(std::size_t slot) {
  // Bound: the contacts of a body.
  for (int i = contacts.first_of(slot); i != kNone; i = contacts.next_of(i, slot)) {
    contacts[i].is_moved = true;
  }
}

template <class SceneT>
void ContactGroups<SceneT>::wake(std::size_t slot) {
  // Bound: the contacts of a body.
  for (int i = contacts.first_of(slot); i != kNone; i = contacts.next_of(i, slot)) {
    Contact& contact = contacts[i];
    if (contact.is_solved) continue;
    scale_impulses(contact, Scalar(0));
    contact.since = -1;  // its points have to be found anew
    contact.is_solved = true;
  }
}

template <class SceneT>
template <class Begun>
void ContactGroups<SceneT>::tell_begun(const BodiesT& bodies, const Begun& begun) {
  for (int k = 0; k < solved_count; ++k) {  // Bound: kMaxContacts
    Contact& contact = solved_at(k);
    if (contact.is_told || !is_loaded(contact)) continue;
    contact.is_told = true;
    const auto& point = contact.points[0];
    const Scalar aside =
        off_middle(bodies, a_of<SceneT>(contact), b_of<SceneT>(contact)) * point.gap;
    const Vec3<Scalar> middle_W = point_W(*this, contact) - aside * point.normal_W;
    begun(contact.pair, batuta::Contact<Scalar>{middle_W, point.normal_W, point.gap}, point.normal);
  }
}

template <class SceneT>
void ContactGroups<SceneT>::end_step() {
  for (int i = 0; i < contacts.size(); ++i) {  // Bound: kMaxContacts
    Contact& contact = contacts[i];
    take_together(contact);
    contact.since = 0;
    contact.is_moved = false;
  }
}

/// Each contact that is solved: use(its bodies). @param loaded_only  those that press
template <class SceneT, class Use>
void for_each_solved(const ContactGroups<SceneT>& groups, bool loaded_only, const Use& use) {
  for (int i = 0; i < groups.contacts.size(); ++i) {  // Bound: kMaxContacts
    const auto& contact = groups.contacts[i];
    const bool is_one = contact.is_solved && (!loaded_only || is_loaded(contact));
    if (is_one) use(a_of<SceneT>(contact), b_of<SceneT>(contact));
  }
}

/// Groups of bodies that contacts join. What is led belongs to none: it holds those that it
/// touches, as does who turns about an axle. @param loaded_only  contacts that press
template <class SceneT>
void join_all(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups, bool loaded_only) {
  groups.joined.clear();
  for_each_solved(groups, loaded_only, [&](std::size_t a, std::size_t b) {
    if (!bodies.is_led(a) && !bodies.is_led(b)) groups.joined.join(a, b);
  });
  for_each_solved(groups, loaded_only, [&](std::size_t a, std::size_t b) {
    if (bodies.holds(a) || bodies.holds(b)) groups.joined.hold(bodies.is_led(a) ? b : a);
  });
}

}  // namespace batuta::detail

#include "batuta/world/detail/contact_choice.hpp"
#include "batuta/world/detail/contact_opening.hpp"
#include "batuta/world/detail/contact_passing.hpp"
#include "batuta/world/detail/contact_solution.hpp"
#include "batuta/world/detail/moment_account.hpp"
