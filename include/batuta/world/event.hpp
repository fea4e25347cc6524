// SPDX-License-Identifier: MIT
#pragma once
// What a step tells: contact events that begin, persist and end, and a report in which everything
// is counted that did not fit. A user who reads only the report still learns that something was
// left out.

#include "batuta/response/contact.hpp"

namespace batuta {

/// Where in the life of a contact an event stands.
enum class EventKind : std::uint8_t {
  kBegin,    ///< the pair was not in contact before
  kPersist,  ///< the pair was in contact already, and met again
  kEnd,      ///< the gap of a pair in contact has opened beyond twice D
};

/// One contact of two bodies. A and B are slots in the world's pool: World::id_at() names the body.
/// Where contacts last (RestingContact::kSettling), one event tells all that two capsules did in a
/// step: where and when they approached fastest, and the sum of their impulses.
template <class Scalar>
struct ContactEvent {
  EventKind kind = EventKind::kBegin;  ///< begins, persists or ends
  /// How the bodies moved along the normal before it
  ContactKind contact_kind = ContactKind::kResting;
  std::uint16_t body_A = 0;  ///< slot of A
  std::uint16_t body_B = 0;  ///< body_A < body_B
  std::uint8_t part_A = 0;   ///< which capsule of the body; 0 where it has but one
  std::uint8_t part_B = 0;   ///< the same of B
  Scalar time = 0;           ///< in the step, s
  Contact<Scalar> contact;   ///< point, normal (out of B, towards A), gap
  Scalar v_rel = 0;          ///< before, m/s; negative: approaching
  Scalar impulse = 0;        ///< j, N s; 0 for resting contact
  Scalar place_A = 0;  ///< on A's axis: 0 at axis.a ... 1 at axis.b (on a blade: guard ... tip)
  Scalar place_B = 0;  ///< on B's axis
};

/// What a step did. Every count that should be zero in a healthy scene says so.
template <class Scalar>
struct StepReport {
  std::uint32_t evaluations = 0;  ///< distance evaluations of all searches
  std::uint32_t pairs = 0;        ///< pairs searched, summed over the rounds of the step
  std::uint32_t collisions = 0;   ///< colliding contacts, which got an impulse
  std::uint32_t separations = 0;  ///< resting and overlapping contacts, which were separated
  /// Contacts of two bodies that nothing can push: both stand for the rest of the step
  std::uint32_t blocked = 0;
  /// Pairs that overlapped when a search began: by rounding; because the caller put them there, or
  /// moved what cannot be pushed (src/world/detail/margin.md); and with Stepping also by a
  /// touch shallower than epsilon / 2 that it passed over (src/detection/stepping.md). The other
  /// searches pass over none.
  std::uint32_t overlaps_at_start = 0;
  Scalar deepest_overlap = 0;  ///< of these, m
  /// Bodies for which is_asleep() is true after the step; what configure(), remove() or restore()
  /// change of that is counted at the end of the next one.
  std::uint32_t asleep = 0;
  /// Pairs that went on together for the rest of the step because further answers would not have
  /// parted them: they used up SceneOptions::max_separations (kSettling), or were deeper in each
  /// other than the margin of the search even after their shift, for nobody made room. The first
  /// answer at the start of a step does not count: the caller may have put them there
  /// (src/world/world.md, "Touching and parting").
  std::uint32_t frozen = 0;
  // What did not fit; the bodies concerned went on together from where they were proven free. All
  // zero in a healthy scene.
  std::uint32_t pairs_dropped = 0;     ///< beyond SceneOptions::max_pairs
  std::uint32_t contacts_dropped = 0;  ///< beyond SceneOptions::max_contacts
  std::uint32_t searches_cut = 0;      ///< the search ran out of its budget
  std::uint32_t searches_invalid = 0;  ///< the search could not be asked (see Outcome::kInvalid)
  /// The contact could not be resolved: its numbers overflow; or a load presses on a chain of
  /// bodies that give way, where contacts do not last (src/world/world.md, "The fall")
  std::uint32_t resolutions_invalid = 0;
  /// A body or its controller's plan was not finite, turned too far (it went on without a turn), or
  /// is so far from the origin
  /// that numbers there are further apart than it is large
  std::uint32_t plans_invalid = 0;
  std::uint32_t events_dropped = 0;  ///< beyond SceneOptions::max_events: not told, but resolved
  /// Beyond the pairs that can be followed: no persist and end events
  std::uint32_t contacts_untracked = 0;
  Scalar time_held = 0;  ///< longest time for which a body went on together with others, s

  /// Whether nothing was left out: all counts of what did not fit are zero, and every body made its
  /// motion but for the law of a contact.
  bool complete() const {
    return frozen == 0 && pairs_dropped == 0 && contacts_dropped == 0 && searches_cut == 0 &&
           searches_invalid == 0 && resolutions_invalid == 0 && plans_invalid == 0 &&
           events_dropped == 0 && contacts_untracked == 0;
  }
};

}  // namespace batuta
