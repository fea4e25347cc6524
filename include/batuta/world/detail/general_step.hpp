// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld, second part: the rounds of a step, in the order in which they happen. Included by
// general_world.hpp.

#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

template <class SceneT>
Result<typename GeneralWorld<SceneT>::BodyId> GeneralWorld<SceneT>::add(const ActorType& actor) {
  if (!is_usable(actor)) return failure<BodyId>(Status::kInvalidArgument);
  ActorType added = actor;
  Kinematics::prepare(added);
  const auto id = actors_.make(added);
  if (id.ok()) begin_life(static_cast<std::size_t>(actors_.index_of(id.value)));
  return id;
}

/// Nothing is left of who was in the slot before.
template <class SceneT>
void GeneralWorld<SceneT>::begin_life(std::size_t slot) {
  states_[slot].stands = false;
  states_[slot].boxed = false;
  if constexpr (SceneT::kSleep) this->start_over(slot, actor_at(slot).body.X_WB);
}

template <class SceneT>
void GeneralWorld<SceneT>::restore(const GeneralWorld& saved) {
  if (&saved == this) return;
  this->copy_seeds(saved);
  this->copy_events(saved);
  this->copy_sleep(saved);
  settings_ = saved.settings_;
  actors_.restore(saved.actors_);
  report_ = saved.report_;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    BodyState& state = states_[slot];
    state.plan = saved.states_[slot].plan;
    state.stands = saved.states_[slot].stands;
    state.boxed = false;
  }
}

template <class SceneT>
Status GeneralWorld<SceneT>::step(Scalar dt) {
  if (!is_positive(dt)) return Status::kInvalidArgument;
  begin_step(dt);
  for (int round = 0; round < kMaxRounds && now_ < dt_; ++round) run_round();  // Bound: kMaxRounds
  BATUTA_INVARIANT(!(now_ < dt_));
  end_step();
  return Status::kOk;
}

/// To the next thing that happens: a contact, a search that ended without an answer, the end of a
/// hold, or the end of the step.
template <class SceneT>
void GeneralWorld<SceneT>::run_round() {
  refresh();
  const Scalar released = next_release();
  const int earliest = CandidateOrder::earliest(candidates_);
  if (earliest == CandidateOrder::kNone || released < candidates_[earliest].free_until()) {
    return release(released);
  }
  const Scalar time = min_of(candidates_[earliest].free_until(), dt_);
  const int chosen =
      SceneT::kMaxPairs > 1 ? CandidateOrder::among_ties(candidates_, earliest) : earliest;
  const CandidateType candidate = candidates_[chosen];
  candidates_.remove_swapping(chosen);
  resolve(candidate, time);
}

/// The first time at which a held body is released, or the end of the step.
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::next_release() const {
  Scalar time = dt_;
  if constexpr (kReleases) {
    for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
      if (is_present(slot) && is_held(slot)) time = min_of(time, states_[slot].held_until);
    }
  }
  return time;
}

template <class SceneT>
void GeneralWorld<SceneT>::release(Scalar time) {
  now_ = time;
  if constexpr (kReleases) {
    if (!(now_ < dt_)) return;
    for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
      const BodyState& state = states_[slot];
      if (state.present && state.held_until == now_) advance(slot, now_ - state.start);
    }
  }
}

/// @param time  not later than the candidate's own: another one that ties with it may be earlier
template <class SceneT>
void GeneralWorld<SceneT>::resolve(const CandidateType& candidate, Scalar time) {
  const bool is_own_time = time == candidate.free_until();
  const bool is_known = is_own_time && is_same(candidate.pair, queries_.pair());
  now_ = time;
  if constexpr (!SceneT::kResponse) return report_only(candidate);
  advance_to_contact(candidate, body_of(candidate.pair.first), is_own_time);
  advance_to_contact(candidate, body_of(candidate.pair.second), is_own_time);
  if (candidate.is_contact() && contacts_resolved_ < SceneT::kMaxContacts) {
    ++contacts_resolved_;
    if constexpr (SceneT::kRotation) {
      return resolve_turning(candidate, seen(candidate.pair, is_known));
    } else {
      return resolve_straight(candidate);
    }
  }
  count_cut(candidate);
  hold_pair(candidate.pair, dt_);
}

/// What is to be known of a contact; of a scene's only pair it is always known.
template <class SceneT>
typename GeneralWorld<SceneT>::PairQuery& GeneralWorld<SceneT>::seen(ProxyPair pair,
                                                                     bool is_known) {
  if constexpr (SceneT::kMaxPairs > 1) {
    if (!is_known) look(pair, queries_.earliest());
  }
  return queries_.earliest();
}

/// A body of a candidate, to now: by the time that its search found where that is the same, to the
/// last bit.
template <class SceneT>
void GeneralWorld<SceneT>::advance_to_contact(const CandidateType& candidate, std::size_t slot,
                                              bool is_own_time) {
  const bool is_of_search = is_own_time && states_[slot].start == candidate.since;
  advance(slot, is_of_search ? candidate.free_for : now_ - states_[slot].start);
}

/// A candidate that ends without an answer.
template <class SceneT>
void GeneralWorld<SceneT>::count_cut(const CandidateType& candidate) {
  if (candidate.is_contact()) {
    ++report_.contacts_dropped;
  } else if (candidate.outcome == Outcome::kBudget) {
    ++report_.searches_cut;
  } else {
    ++report_.searches_invalid;
  }
}

/// Moves a body on its planned motion, up to now; from there it has to be planned anew.
template <class SceneT>
void GeneralWorld<SceneT>::advance(std::size_t slot, Scalar elapsed) {
  BodyState& state = states_[slot];
  Kinematics::move(actor_at(slot).body, state.plan.motion, elapsed);
  if constexpr (SceneT::kRotation && SceneT::kMaxPairs > 1) {  // look() asks where it is
    state.plan.motion.X_WB = actor_at(slot).body.X_WB;
  }
  state.start = now_;
  state.changed = true;
  is_changed_ = true;
}

/// The body stays where it is now. What is held for longer already stays held. Its weight is
/// carried for so long: else it would gain the speed of a fall by standing still.
template <class SceneT>
void GeneralWorld<SceneT>::hold(std::size_t slot, Scalar until) {
  BodyState& state = states_[slot];
  if (state.start < now_) advance(slot, now_ - state.start);
  const Scalar held_before = max_of(state.held_until, now_);
  state.held_until = max_of(state.held_until, min_of(until, dt_));
  fall(slot, held_before - state.held_until);
  state.plan.motion = Kinematics::standing(actor_at(slot).body, state.plan.motion.duration);
  state.changed = true;
  is_changed_ = true;
  report_.time_held = max_of(report_.time_held, state.held_until - now_);
}

template <class SceneT>
void GeneralWorld<SceneT>::hold_pair(ProxyPair pair, Scalar until) {
  if constexpr (!SceneT::kResponse) return;
  hold(body_of(pair.first), until);
  hold(body_of(pair.second), until);
}

template <class SceneT>
void GeneralWorld<SceneT>::end_step() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!states_[slot].present) continue;
    ActorType& actor = actor_at(slot);
    const BodyState& state = states_[slot];
    if (!state.stands) Kinematics::move(actor.body, state.plan.motion, dt_ - state.start);
    if constexpr (SceneT::kRotation) actor.controller.on_step_end(actor.body, dt_);
  }
  if constexpr (SceneT::kMaxEvents > 0) end_touches();
  if constexpr (SceneT::kSleep) put_to_sleep();
}

}  // namespace batuta::detail
