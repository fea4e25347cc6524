// SPDX-License-Identifier: MIT
#pragma once
// Touches and events: which pairs are between their begin and their end, and what is told of them.
// One of the five that make a step (general_world.hpp). Empty where SceneOptions::max_events is 0.

#include "batuta/world/detail/event_book.hpp"
#include "batuta/world/detail/pairs.hpp"

namespace batuta::detail {

/// What a contact came to, for its event.
template <class Scalar>
struct Answer {
  ContactKind kind = ContactKind::kResting;
  Scalar v_rel = 0;                           ///< before, m/s
  Scalar impulse = 0;                         ///< j, N s
  Vec3<Scalar> impulse_A_W = zero<Scalar>();  ///< J on A; B was given the opposite
  bool is_overlap = false;                    ///< the pair was found in each other
};

template <class SceneT>
class Touches : private EventsOf<SceneT> {
 public:
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  using EventList = typename EventsOf<SceneT>::EventList;

  void begin_step() { this->clear_events(); }
  const EventList& events() const { return this->list(); }
  /// A contact that was answered: begins, or goes on.
  void record(BodiesT& bodies, ProxyPair pair, const Nearest<Scalar>& nearest,
              const Answer<Scalar>& result);
  /// A contact that lasts: told when it begins.
  void record_lasting(BodiesT& bodies, ProxyPair pair, const Contact<Scalar>& contact,
                      Scalar impulse);
  /// Ends the touches of pairs that have opened beyond twice D. Bound: kMaxPairs.
  /// @param stays  whether a pair is known not to have opened  @param ended  is told each that ends
  template <class GapOf, class Stays, class Ended>
  void end_step(BodiesT& bodies, const GapOf& rest_gap, const Stays& stays, const Ended& ended);
  /// Ends those of a body without an event. Bound: kMaxPairs.
  void remove(std::size_t slot);
  void copy(const Touches& saved) { this->copy_events(saved); }
  template <class Archive>
  void archive(Archive& ar, const BodiesT& bodies);

 private:
  ContactEvent<Scalar> event_of(ProxyPair pair, const Nearest<Scalar>& nearest) const;
  void tell(BodiesT& bodies, ContactEvent<Scalar>& event, ProxyPair pair);
  bool end_if_open(BodiesT& bodies, int i, Scalar rest_gap);
  static bool is_there(const BodiesT& bodies, ProxyPair pair);
  static bool has_part(const BodiesT& bodies, int proxy) {
    const std::size_t slot = BodiesT::body_of(proxy);
    return bodies.actors.at_index(slot) != nullptr &&
           BodiesT::part_at(proxy) < parts_of(bodies.actor(slot));
  }
  static Nearest<Scalar> nearest(const BodiesT& bodies, ProxyPair pair) {
    return BodiesT::Kinematics::nearest(
        bodies.actor(BodiesT::body_of(pair.first)), BodiesT::part_at(pair.first),
        bodies.actor(BodiesT::body_of(pair.second)), BodiesT::part_at(pair.second));
  }
};

template <class SceneT>
ContactEvent<Scalar_of<SceneT>> Touches<SceneT>::event_of(ProxyPair pair,
                                                          const Nearest<Scalar>& nearest) const {
  ContactEvent<Scalar> event;
  event.body_A = static_cast<std::uint16_t>(BodiesT::body_of(pair.first));
  event.body_B = static_cast<std::uint16_t>(BodiesT::body_of(pair.second));
  event.part_A = static_cast<std::uint8_t>(BodiesT::part_at(pair.first));
  event.part_B = static_cast<std::uint8_t>(BodiesT::part_at(pair.second));
  event.contact = nearest.contact;
  event.place_A = nearest.place_A;
  event.place_B = nearest.place_B;
  return event;
}

/// Where contacts last, one event tells all that a pair did in the step: its fastest approach, and
/// the sum of the impulses.
template <class SceneT>
void Touches<SceneT>::tell(BodiesT& bodies, ContactEvent<Scalar>& event, ProxyPair pair) {
  event.kind = EventKind::kPersist;
  if (!this->is_touching(pair)) {
    event.kind = EventKind::kBegin;
    if (!this->begin_touch(pair)) ++bodies.report.contacts_untracked;
  } else if (kLasts<SceneT>) {
    if (ContactEvent<Scalar>* reported = this->find_told(event)) {
      event.kind = reported->kind;
      event.impulse += reported->impulse;
      if (event.v_rel < reported->v_rel) *reported = event;
      reported->impulse = event.impulse;
      return;
    }
  }
  if (!this->push(event)) ++bodies.report.events_dropped;
}

template <class SceneT>
void Touches<SceneT>::record(BodiesT& bodies, ProxyPair pair, const Nearest<Scalar>& nearest,
                             const Answer<Scalar>& result) {
  if (result.impulse > Scalar(0)) ++bodies.report.collisions;
  if (result.is_overlap) {
    ++bodies.report.overlaps_at_start;
    bodies.report.deepest_overlap = max_of(bodies.report.deepest_overlap, -nearest.contact.gap);
  }
  if constexpr (SceneT::kMaxEvents > 0) {
    ContactEvent<Scalar> event = event_of(pair, nearest);
    event.contact_kind = result.kind;
    event.time = bodies.now;
    event.v_rel = result.v_rel;
    event.impulse = result.impulse;
    tell(bodies, event, pair);
  }
}

template <class SceneT>
void Touches<SceneT>::record_lasting(BodiesT& bodies, ProxyPair pair,
                                     const Contact<Scalar>& contact, Scalar impulse) {
  if constexpr (SceneT::kMaxEvents > 0) {
    if (this->is_touching(pair)) return;
    Nearest<Scalar> at = nearest(bodies, pair);
    at.contact = contact;
    ContactEvent<Scalar> event = event_of(pair, at);
    event.time = bodies.now;
    event.impulse = impulse;
    tell(bodies, event, pair);
  }
}

/// Whether both parts of a touch are there still: the caller may have taken one off.
template <class SceneT>
bool Touches<SceneT>::is_there([[maybe_unused]] const BodiesT& bodies,
                               [[maybe_unused]] ProxyPair pair) {
  if constexpr (BodiesT::kParts > 1) {
    return has_part(bodies, pair.first) && has_part(bodies, pair.second);
  } else {
    return true;
  }
}

/// The end of a touch, if it has opened far enough. @returns whether it has
template <class SceneT>
bool Touches<SceneT>::end_if_open(BodiesT& bodies, int i, Scalar rest_gap) {
  const ProxyPair pair = this->touch(i);
  const Nearest<Scalar> now = nearest(bodies, pair);
  if (!(now.contact.gap > Scalar(2) * rest_gap)) return false;
  ContactEvent<Scalar> event = event_of(pair, now);
  event.kind = EventKind::kEnd;
  event.contact_kind = ContactKind::kReceding;
  event.time = bodies.dt;
  if (!this->push(event)) ++bodies.report.events_dropped;
  this->end_touch(i);
  return true;
}

/// Also those that began in the step.
template <class SceneT>
template <class GapOf, class Stays, class Ended>
void Touches<SceneT>::end_step(BodiesT& bodies, const GapOf& rest_gap, const Stays& stays,
                               const Ended& ended) {
  if constexpr (SceneT::kMaxEvents > 0) {
    for (int i = this->touches() - 1; i >= 0; --i) {  // Bound: kMaxPairs
      const ProxyPair pair = this->touch(i);
      if (!is_there(bodies, pair)) {
        this->end_touch(i);
      } else if (!stays(pair) && end_if_open(bodies, i, rest_gap(pair))) {
        ended(pair);
      }
    }
  }
}

template <class SceneT>
void Touches<SceneT>::remove(std::size_t slot) {
  if constexpr (SceneT::kMaxEvents > 0) {
    for (int i = this->touches() - 1; i >= 0; --i) {  // Bound: kMaxPairs
      const ProxyPair pair = this->touch(i);
      if (BodiesT::body_of(pair.first) == slot || BodiesT::body_of(pair.second) == slot) {
        this->end_touch(i);
      }
    }
  }
}

/// What was read may name bodies that are not there.
template <class SceneT>
template <class Archive>
void Touches<SceneT>::archive(Archive& ar, const BodiesT& bodies) {
  this->archive_events(ar);
  if constexpr (SceneT::kMaxEvents > 0) {
    if (!ar.reading()) return;
    for (int i = this->touches() - 1; i >= 0; --i) {  // Bound: kMaxPairs
      const bool good = bodies.has_bodies(this->touch(i));
      ar.require(good);
      if (!good) this->end_touch(i);
    }
  }
}

}  // namespace batuta::detail
