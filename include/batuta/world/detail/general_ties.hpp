// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld: contacts that are near when the first of a round happens, where contacts last: all
// of them are answered before anybody is planned anew (src/world/world.md, "Order"). Included by
// general_world.hpp.

#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

/// Whether a pair that comes to contact in the step ties: it is near already, and has something to
/// answer, because it approaches by the momenta as they are. What does not stays a candidate, or is
/// collected anew where one of its bodies has changed.
template <class SceneT>
bool GeneralWorld<SceneT>::is_due(ProxyPair pair) {
  constexpr Scalar kNear = Scalar(1) / 2;  // of D: where contacts last, they are as near
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  const bool is_alone =
      bodies_.states[a].group == BodiesT::kAlone && bodies_.states[b].group == BodiesT::kAlone;
  const bool has_room = contacts_answered_ < SceneT::kMaxContacts;
  if (!is_alone || !has_room || this->answers_of(pair) >= SceneT::kMaxSeparations) return false;
  if (wins_by_chord(bodies_, a, b, bodies_.now)) return false;
  const PairQuery& query = pairs_.seen(bodies_, pair, false);
  const auto& witness = query.search.witness;
  if (witness.gap > kNear * rest_gap(bodies_, pair)) return false;
  const auto velocity = [&](std::size_t slot, const Vec3<Scalar>& surface_P) {
    const Twist<Scalar> twist = bodies_.twist_now(slot);
    const Vec3<Scalar> arm_W = surface_P + query.origin_W - place_now(bodies_, slot);
    return Vec3<Scalar>(twist.v_W + twist.w_W.cross(arm_W));
  };
  const Scalar rate =
      witness.axes.normal_AB.dot(velocity(b, witness.surface_B) - velocity(a, witness.surface_A));
  return rate < slowest_closing(bodies_, query, !is_zero(parts_along(pair)));
}

/// In the order of their pairs, from the one that was answered on. Bound: kTies.
template <class SceneT>
void GeneralWorld<SceneT>::answer_ties(ProxyPair last) {
  const auto has_had = [this](ProxyPair pair) { return this->was_answered(pair, bodies_.now); };
  while (!struck_.empty() && struck_.size() < kTies && !is_moved_) {  // Bound: kMaxPairs
    const int i = CandidateOrder::next_contact(pairs_.candidates, last, has_had);
    if (i == CandidateOrder::kNone) return;
    const CandidateType candidate = pairs_.candidates[i];
    last = candidate.pair;
    if (!is_due(last)) continue;
    pairs_.candidates.remove_swapping(i);
    resolve(candidate, bodies_.now);
  }
}

/// What all blows of the round pass on.
template <class SceneT>
void GeneralWorld<SceneT>::pass_on() {
  if (struck_.empty()) return;
  groups_.pass_on(bodies_, struck_, Passing{*this});
  for (const auto& struck : struck_) {  // Bound: kTies
    shorten_courses(bodies_, struck.pair, struck.contact, struck.contact_gap);
  }
}

}  // namespace batuta::detail
