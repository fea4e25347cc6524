// SPDX-License-Identifier: MIT
#pragma once
// The events of a step, and the pairs that are between their begin and their end. Empty where
// SceneOptions::max_events is 0.

#include "batuta/core/fixed_list.hpp"
#include "batuta/world/detail/candidate_pair.hpp"
#include "batuta/world/detail/proxy_pair.hpp"
#include "batuta/world/event.hpp"

namespace batuta::detail {

template <class Scalar, int kMaxEvents, int kMaxPairs>
class EventBook {
 public:
  using EventList = FixedList<ContactEvent<Scalar>, kMaxEvents>;

 protected:
  void clear_events() { events_.clear(); }
  const EventList& list() const { return events_; }
  /// False: no room.
  bool push(const ContactEvent<Scalar>& event) { return events_.push(event); }
  /// The contact of the same two capsules that was told in this step, or null. Bound: kMaxEvents.
  ContactEvent<Scalar>* find_told(const ContactEvent<Scalar>& event) {
    for (int i = 0; i < events_.size(); ++i) {  // Bound: kMaxEvents
      ContactEvent<Scalar>& reported = events_[i];
      if (reported.body_A == event.body_A && reported.body_B == event.body_B &&
          reported.part_A == event.part_A && reported.part_B == event.part_B) {
        return &reported;
      }
    }
    return nullptr;
  }

  /// Pairs of proxies in contact.
  int touches() const { return touching_.size(); }
  ProxyPair touch(int i) const { return touching_[i]; }
  bool is_touching(ProxyPair pair) const {
    for (const ProxyPair known : touching_) {  // Bound: kMaxPairs
      if (is_same(known, pair)) return true;
    }
    return false;
  }
  /// False: no room.
  bool begin_touch(ProxyPair pair) { return touching_.push(pair); }
  void end_touch(int i) { touching_.remove_swapping(i); }
  void copy_events(const EventBook& other) { *this = other; }

  template <class Archive>
  void archive_events(Archive& ar) {
    ar(events_, touching_);
  }

 private:
  EventList events_;
  FixedList<ProxyPair, kMaxPairs> touching_;  ///< in the order in which they began to touch
};

struct NoEvents {
  using EventList = void*;
  void clear_events() {}
  void copy_events(const NoEvents& /*other*/) {}
  template <class Archive>
  void archive_events(Archive& /*ar*/) {}
};

template <class SceneT>
using EventsOf = std::conditional_t<
    (SceneT::kMaxEvents > 0),
    EventBook<typename SceneT::Scalar, max_of(SceneT::kMaxEvents, 1), SceneT::kMaxPairs>, NoEvents>;

}  // namespace batuta::detail
