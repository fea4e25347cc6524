// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld: what a contact is answered with. Included by general_world.hpp.

#include "batuta/world/detail/general_blow.hpp"
#include "batuta/world/detail/general_load.hpp"
#include "batuta/world/detail/general_separation.hpp"
#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

/// @param time  not later than the candidate's own: another one that ties with it may be earlier
template <class SceneT>
void GeneralWorld<SceneT>::resolve(const CandidateType& candidate, Scalar time) {
  const bool is_own_time = time == candidate.free_until();
  const std::size_t a = BodiesT::body_of(candidate.pair.first);
  const std::size_t b = BodiesT::body_of(candidate.pair.second);
  const bool wins = candidate.is_contact() && wins_by_chord(bodies_, a, b, time);
  if (!wins) bodies_.now = time;  // else together from now, where it may still be on its flight
  if constexpr (!SceneT::kResponse) return report_only(candidate);
  if constexpr (SceneT::kSleep) {
    for (const std::size_t slot : {a, b}) wake_with_all(slot);  // Bound: 2
  }
  const bool has_room = contacts_answered_ < SceneT::kMaxContacts;
  if (!candidate.is_contact() || !has_room || wins) return cut(candidate);
  ++contacts_answered_;
  resolve_contact(candidate, is_own_time);
}

/// Within a step, what slept is at rest, and carried for the rest of it.
template <class SceneT>
void GeneralWorld<SceneT>::wake_now(std::size_t slot) {
  groups_.wake(slot);
  auto& state = bodies_.states[slot];
  state.plan.motion = Kinematics::standing(bodies_.actor(slot).body, bodies_.dt - bodies_.now);
  state.start = bodies_.now;
  if constexpr (SceneT::kGravity) state.loaded = true;
  state.changed = bodies_.is_changed = true;
}

/// And all that sleep against it.
template <class SceneT>
void GeneralWorld<SceneT>::wake_with_all(std::size_t slot) {
  sleep_.wake(bodies_, groups_, slot, [this](std::size_t woken) { wake_now(woken); });
}

/// What cannot be answered in this step: the two go on together.
template <class SceneT>
[[gnu::cold]] void GeneralWorld<SceneT>::cut(const CandidateType& candidate) {
  if (candidate.is_contact()) {
    ++bodies_.report.contacts_dropped;
  } else if (candidate.outcome == Outcome::kBudget) {
    ++bodies_.report.searches_cut;
  } else {
    ++bodies_.report.searches_invalid;
  }
  if constexpr (SceneT::kResponse) stop_both(candidate.pair);
}

/// A body of a candidate, to now: by the time that its search found where that is the same, to the
/// last bit. A wall stays what it is.
template <class SceneT>
void GeneralWorld<SceneT>::advance_to_now(const CandidateType& candidate, std::size_t slot,
                                          bool is_own_time) {
  if (bodies_.is_wall(slot)) return;
  const Scalar start = bodies_.states[slot].start;
  const bool is_of_search = is_own_time && start == candidate.since;
  bodies_.advance(slot, is_of_search ? candidate.free_for : bodies_.now - start);
}

template <class SceneT>
void GeneralWorld<SceneT>::resolve_contact(const CandidateType& candidate, bool is_own_time) {
  const std::size_t a = BodiesT::body_of(candidate.pair.first);
  const std::size_t b = BodiesT::body_of(candidate.pair.second);
  bool is_welded = false;
  for (const std::size_t slot : {a, b}) {  // Bound: 2
    if (bodies_.states[slot].group == BodiesT::kAlone) continue;
    if constexpr (kSeparates) {  // what strikes a pair that is being separated ends that
      bodies_.part_group(slot);
    } else {
      is_welded = true;
    }
  }
  if (is_welded || uses_up_answers(candidate.pair)) {
    if (!is_welded) ++bodies_.report.frozen;
    bodies_.weld(a, b, bodies_.dt);
    return;
  }
  advance_to_now(candidate, a, is_own_time);
  advance_to_now(candidate, b, is_own_time);
  if constexpr (SceneT::kRotation) {
    answer_turning(candidate, pairs_.seen(bodies_, candidate.pair, is_own_time));
  } else {
    answer_straight(candidate);
  }
}

/// Counts the answers of a pair that come in quick succession. @returns whether it has had all that
/// one step has for it
template <class SceneT>
bool GeneralWorld<SceneT>::uses_up_answers(ProxyPair pair) {
  if constexpr (kSolves) {
    constexpr Scalar kSoon = Scalar(1) / 128;  // of the step
    constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
    const int count = this->repeat(pair, bodies_.now, kSoon * bodies_.dt);
    answers_of_pair_ = static_cast<std::uint16_t>(min_of(count, kMost));
    return count > SceneT::kMaxSeparations;
  } else {
    return false;
  }
}

template <class SceneT>
void GeneralWorld<SceneT>::answer_turning(const CandidateType& candidate, const PairQuery& query) {
  const ProxyPair pair = candidate.pair;
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  const CapsuleGap<Scalar>& witness = query.search.witness;
  Nearest<Scalar> at = {contact_from(witness, query.origin_W), witness.axes.s, witness.axes.u};
  if constexpr (!BodiesT::kIsFree) {
    if (is_fixed(bodies_.actor(a).body) && is_fixed(bodies_.actor(b).body)) {
      return block(candidate, query, at);
    }
  }
  const bool is_loads = !is_blow(pair, at.contact);
  const Sides sides = sides_of(pair);
  if constexpr (SceneT::kLineContact) {
    at.contact = pressure_contact(sides.A, sides.B, bodies_.shape_W(pair.first),
                                  bodies_.shape_W(pair.second), at.contact,
                                  search_margin(bodies_, query, pair));
  }
  Answer<Scalar> result;
  result.v_rel = velocity_between(sides, at.contact);
  result.kind = classify(result.v_rel, rest_speed());
  const bool touches = candidate.outcome == Outcome::kTouching && !(at.contact.gap > Scalar(0));
  result.is_overlap = kSolves ? at.contact.gap < -search_margin(bodies_, query, pair)
                              : touches || at.contact.gap < -query.contact_gap;
  if (!strike_turning(pair, sides, at.contact, is_loads, result)) {
    ++bodies_.report.resolutions_invalid;
    bodies_.weld(a, b, bodies_.dt);
    return;
  }
  touches_.record(bodies_, pair, at, result);
  finish_turning(pair, query, at.contact, result);
}

/// The impulses of a contact. @returns false: one overflows, and nothing was given
template <class SceneT>
bool GeneralWorld<SceneT>::strike_turning(ProxyPair pair, const Sides& sides,
                                          const Contact<Scalar>& contact, bool is_loads,
                                          Answer<Scalar>& result) {
  const bool collides = result.kind == ContactKind::kColliding;
  // Who rests on what does not give way comes no nearer to it (general_separation.hpp).
  const bool is_stopped = result.kind == ContactKind::kResting && holds_one(pair);
  if (collides || kSolves || is_stopped) {
    // A pair that comes again and again in a step is between others, and settles.
    const bool bounces =
        collides && !is_loads && answers_of_pair_ <= max_of(SceneT::kMaxSeparations / 2, 1);
    const auto hit = strike(pair, sides, contact, bounces ? restitution_of(pair) : Scalar(0));
    if (!hit.ok()) return false;
    if (!is_stopped) {
      result.impulse = hit.value.magnitude;
      result.impulse_A_W = hit.value.on_A.linear_W;
    }
    if (is_loads) note_supports(pair, hit.value.on_A, hit.value.on_B);
  }
  const int carried = takes_load(pair, contact);
  if (carried != kNobody) press(pair, contact, carried, result);
  return true;
}

/// What becomes of a contact after its impulse.
template <class SceneT>
void GeneralWorld<SceneT>::finish_turning(ProxyPair pair, const PairQuery& query,
                                          const Contact<Scalar>& contact,
                                          const Answer<Scalar>& result) {
  if constexpr (kSolves) {
    finish_lasting(pair, query, contact, result);
  } else {
    const bool is_resting = kSeparates && result.kind == ContactKind::kResting;
    if (is_resting || contact.gap < -query.contact_gap) {
      separate_pair(pair, query, contact, result, is_resting);
    } else {
      tell_controllers(pair, contact, result, {});
    }
    if constexpr (kBends<SceneT>) shorten_courses(bodies_, pair, contact, query.contact_gap);
  }
}

/// The same where contacts last: it is passed on at the end of the round.
template <class SceneT>
void GeneralWorld<SceneT>::finish_lasting(ProxyPair pair, const PairQuery& query,
                                          const Contact<Scalar>& contact,
                                          const Answer<Scalar>& result) {
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  tell_controllers(pair, contact, result, {});
  const bool again = answers_of_pair_ > 1 || !(result.impulse > Scalar(0));
  if (again) share_off(bodies_, a, b);
  if (answers_of_pair_ >= SceneT::kMaxSeparations) end_openings(bodies_, a, b);
  is_moved_ = contact.gap < -query.contact_gap;
  if (is_moved_) separate_pair(pair, query, contact, result, false);
  if (bodies_.states[a].group != BodiesT::kAlone) return;  // it was welded: nothing passes it on
  struck_.push({pair, contact, query.contact_gap});
}

/// Neither body can be pushed: where one is moved into the other, both stop.
template <class SceneT>
[[gnu::cold]] void GeneralWorld<SceneT>::block(const CandidateType& candidate,
                                               const PairQuery& query,
                                               const Nearest<Scalar>& nearest) {
  Answer<Scalar> result;
  result.v_rel = query.search.gap_rate;
  result.kind = classify(result.v_rel, rest_speed());
  result.is_overlap = candidate.outcome == Outcome::kTouching && !(nearest.contact.gap > Scalar(0));
  ++bodies_.report.blocked;
  touches_.record(bodies_, candidate.pair, nearest, result);
  bodies_.weld(BodiesT::body_of(candidate.pair.first), BodiesT::body_of(candidate.pair.second),
               bodies_.dt);
}

/// Bodies that do not turn: an impulse, after which they part, and what parts is free for good. If
/// they are in each other, the search that lets them part tells it.
template <class SceneT>
void GeneralWorld<SceneT>::answer_straight(const CandidateType& candidate) {
  const ProxyPair pair = candidate.pair;
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  const Nearest<Scalar> at =
      BodiesT::Kinematics::nearest(bodies_.actor(a), BodiesT::part_at(pair.first), bodies_.actor(b),
                                   BodiesT::part_at(pair.second));
  const Vec3<Scalar>& normal_W = at.contact.normal_BA_W;
  const bool is_loads = !is_blow(pair, at.contact);
  auto hit = strike_straight(a, b, normal_W, is_loads ? Scalar(0) : restitution_of(pair));
  if constexpr (kCarries<SceneT>) {
    hit.impulse += load_straight(pair, at.contact, is_loads ? hit.impulse : Scalar(0));
  }
  Answer<Scalar> result;
  result.kind = ContactKind::kColliding;
  result.v_rel = hit.v_rel;
  result.impulse = hit.impulse;
  touches_.record(bodies_, pair, at, result);
}

/// Without response: the contact is told once, and everybody moves on.
template <class SceneT>
void GeneralWorld<SceneT>::report_only(const CandidateType& candidate) {
  if (!candidate.is_contact() || contacts_answered_ == SceneT::kMaxContacts) return cut(candidate);
  ++contacts_answered_;
  Answer<Scalar> result;
  if constexpr (SceneT::kRotation) {
    const PairQuery& query = pairs_.seen(bodies_, candidate.pair, false);
    const CapsuleGap<Scalar>& witness = query.search.witness;
    result.v_rel = query.search.gap_rate;
    result.kind = classify(result.v_rel, bodies_.settings.rest_speed);
    result.is_overlap = candidate.outcome == Outcome::kTouching && !(witness.gap > Scalar(0));
    touches_.record(bodies_, candidate.pair,
                    {contact_from(witness, query.origin_W), witness.axes.s, witness.axes.u},
                    result);
  } else {
    const Nearest<Scalar> at =
        BodiesT::Kinematics::nearest(bodies_.actor(BodiesT::body_of(candidate.pair.first)),
                                     BodiesT::part_at(candidate.pair.first),
                                     bodies_.actor(BodiesT::body_of(candidate.pair.second)),
                                     BodiesT::part_at(candidate.pair.second));
    touches_.record(bodies_, candidate.pair, at, result);
  }
}

}  // namespace batuta::detail
