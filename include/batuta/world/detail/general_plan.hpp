// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld, first part: who takes part in a step, where everybody goes, what volume that takes,
// and which pairs may meet and when. Included by general_world.hpp.

#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

template <class SceneT>
void GeneralWorld<SceneT>::begin_step(Scalar dt) {
  report_ = {};
  this->clear_events();
  this->clear_repeats();
  candidates_.clear();
  queries_.forget();
  now_ = 0;
  dt_ = dt;
  contacts_resolved_ = 0;
  if constexpr (SceneT::kResting != RestingContact::kNone) rest_speed_ = settings_.rest_speed;
  if constexpr (kSettles && SceneT::kGravity) {
    constexpr Scalar kSteps = 2;  // one to gain it, one to be stopped
    const Scalar g = settings_.gravity_W.norm();
    using std::sqrt;
    // Through 4 D: a rod that rocks falls through D at its middle and comes at its end with nearly
    // twice that speed; and by opening the gap to the margin a bounce gains up to m g D.
    const Scalar through_gap = sqrt(8 * g * settings_.separation);
    rest_speed_ = max_of(rest_speed_, max_of(kSteps * g * dt, through_gap));
  }
  for (std::size_t slot = 0; slot < kSlots; ++slot) begin_body(slot);  // Bound: kMaxBodies
  is_begin_ = is_changed_ = true;
}

template <class SceneT>
void GeneralWorld<SceneT>::begin_body(std::size_t slot) {
  BodyState& state = states_[slot];
  state.held_until = 0;
  state.falls = false;
  state.changed = is_present(slot);
  if (!state.changed && state.present) leave_out(slot);
  if constexpr (SceneT::kSleep) {
    if (state.changed && this->sleeps(slot) && is_disturbed(slot)) {
      this->start_over(slot, actor_at(slot).body.X_WB);
    }
  }
}

/// Whether somebody else has moved a sleeper, or given it a momentum.
template <class SceneT>
bool GeneralWorld<SceneT>::is_disturbed(std::size_t slot) const {
  const BodyOf<SceneT>& body = actor_at(slot).body;
  return !Kinematics::is_at_start(body, states_[slot].plan.motion) ||
         !is_zero(body.momentum.linear_W) || !is_zero(body.momentum.angular_W);
}

/// Plans, bounds and searches what has changed. A pair that finds no room holds its bodies, which
/// changes them in turn: each body at most once, because it is held for the rest of the step.
/// Bound: kMaxBodies + 1 passes.
template <class SceneT>
void GeneralWorld<SceneT>::refresh() {
  for (int pass = 0; is_changed_ && pass <= SceneT::kMaxBodies; ++pass) {  // Bound: kMaxBodies + 1
    const bool is_begin = is_begin_;
    is_begin_ = false;
    is_changed_ = false;
    drop_candidates();
    for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
      if (states_[slot].changed) plan(slot, is_begin);
    }
    sweep_.sort();
    if (is_begin) {
      collect_all();
    } else {
      collect_fresh();
    }
    for (BodyState& state : states_) state.fresh = false;  // Bound: kMaxBodies
  }
  search_candidates();
}

/// What was known of a body whose planned motion changes is no longer true.
template <class SceneT>
void GeneralWorld<SceneT>::drop_candidates() {
  const auto is_stale = [this](ProxyPair pair) {
    return states_[body_of(pair.first)].changed || states_[body_of(pair.second)].changed;
  };
  for (int i = candidates_.size() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    if (is_stale(candidates_[i].pair)) candidates_.remove_swapping(i);
  }
  if (is_stale(queries_.pair())) queries_.forget();
}

template <class SceneT>
void GeneralWorld<SceneT>::plan(std::size_t slot, bool is_begin) {
  BodyState& state = states_[slot];
  state.changed = false;
  const bool stayed =
      is_begin && state.stands && Kinematics::is_at_start(actor_at(slot).body, state.plan.motion);
  state.start = now_;
  if (!plan_motion(slot, is_begin)) return leave_out(slot);
  state.present = true;
  state.fresh = true;
  state.stands = is_begin && Kinematics::is_still(state.plan.motion);
  const bool idle = stayed && state.stands;
  if (idle && state.boxed && sweep_.is_idle(proxy_of(slot, 0))) return;
  put_boxes(slot, idle);
}

/// False: the body cannot take part.
template <class SceneT>
bool GeneralWorld<SceneT>::plan_motion(std::size_t slot, bool is_begin) {
  ActorType& actor = actor_at(slot);
  BodyState& state = states_[slot];
  const Scalar duration = end_of(slot) - now_;
  if (!is_usable(actor)) {
    ++report_.plans_invalid;
    return false;
  }
  if (!is_held(slot) && !this->sleeps(slot)) {
    state.plan = Kinematics::ask(actor, now_, duration);
    if (is_begin) fall(slot, dt_);
    if (is_valid(state.plan.motion)) return true;
    ++report_.plans_invalid;
    fall(slot, now_ - dt_);  // as in hold(): what stands still does not fall
    state.held_until = dt_;
    report_.time_held = max_of(report_.time_held, dt_ - now_);
  }
  state.plan.motion = Kinematics::standing(actor.body, duration);
  return true;
}

/// What a body gains by falling for `time`; below zero, what is taken back of its fall of this
/// step.
template <class SceneT>
void GeneralWorld<SceneT>::fall(std::size_t slot, Scalar time) {
  if constexpr (SceneT::kGravity) {
    BodyState& state = states_[slot];
    state.falls = state.falls || time > Scalar(0);
    if (!state.falls) return;
    Kinematics::fall(actor_at(slot).body, state.plan, settings_.gravity_W, time);
  }
}

template <class SceneT>
void GeneralWorld<SceneT>::leave_out(std::size_t slot) {
  states_[slot].present = false;
  states_[slot].stands = false;
  for (int part = 0; part < kParts; ++part) {  // Bound: kCapsulesPerBody
    sweep_.remove(proxy_of(slot, part));
  }
}

template <class SceneT>
void GeneralWorld<SceneT>::put_boxes(std::size_t slot, bool idle) {
  const ActorType& actor = actor_at(slot);
  states_[slot].boxed = true;
  for (int part = 0; part < kParts; ++part) {  // Bound: kCapsulesPerBody
    const Slot proxy = proxy_of(slot, part);
    if (part < parts_of(actor)) {
      sweep_.set(proxy,
                 Kinematics::bound(Kinematics::mover(actor, part, states_[slot].plan.motion)),
                 idle);
    } else {
      sweep_.remove(proxy);
    }
  }
}

template <class SceneT>
void GeneralWorld<SceneT>::collect_all() {
  sweep_.for_each_pair([this](ProxyPair pair) { collect(pair); });
}

template <class SceneT>
void GeneralWorld<SceneT>::collect_fresh() {
  for (int i = 0; i < kProxies; ++i) {  // Bound: all capsules
    const auto proxy = static_cast<Slot>(i);
    if (!states_[body_of(i)].fresh || !sweep_.contains(proxy)) continue;
    sweep_.for_each_partner(proxy, [this, proxy](Slot other) {
      if (other < proxy && states_[body_of(other)].fresh) return;  // found from there already
      collect({min_of(proxy, other), max_of(proxy, other)});
    });
  }
}

/// Between two held bodies nothing changes before one of them is released: such a pair waits.
template <class SceneT>
void GeneralWorld<SceneT>::collect(ProxyPair pair) {
  const std::size_t a = body_of(pair.first);
  const std::size_t b = body_of(pair.second);
  if ((is_held(a) && is_held(b)) || !may_pair(a, b)) return;
  CandidateType candidate;
  candidate.pair = pair;
  const bool has_room = candidates_.push(candidate);
  if constexpr (kCanOverflow) {
    if (has_room) return;
    ++report_.pairs_dropped;
    hold_pair(pair, dt_);
  }
}

/// What is still and cannot be pushed may stand in other such bodies.
template <class SceneT>
bool GeneralWorld<SceneT>::may_pair(std::size_t a, std::size_t b) const {
  const bool walls = Kinematics::is_still(states_[a].plan.motion) &&
                     Kinematics::is_still(states_[b].plan.motion) &&
                     Kinematics::is_immovable(actor_at(a).body) &&
                     Kinematics::is_immovable(actor_at(b).body);
  return a != b && !walls && may_meet(actor_at(a), actor_at(b));
}

template <class SceneT>
void GeneralWorld<SceneT>::search_candidates() {
  for (int i = 0; i < candidates_.size(); ++i) {  // Bound: kMaxPairs
    if (!candidates_[i].asked) search(candidates_[i]);
  }
  for (int i = candidates_.size() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    if (candidates_[i].outcome == Outcome::kFree) candidates_.remove_swapping(i);
  }
}

/// What was seen of the earliest candidate is kept: its contact then needs no other evaluation.
template <class SceneT>
void GeneralWorld<SceneT>::search(CandidateType& candidate) {
  ++report_.pairs;
  const Scalar until =
      min_of(end_of(body_of(candidate.pair.first)), end_of(body_of(candidate.pair.second)));
  PairQuery& query = queries_.spare();
  search_pair(candidate.pair, until, query);
  report_.evaluations += query.evaluations();
  candidate.asked = true;
  candidate.outcome = query.outcome();
  candidate.since = now_;
  candidate.free_for = query.t_free();
  candidate.near_after = query.near_after();
  if (candidate.outcome != Outcome::kFree) queries_.offer(candidate.pair, candidate.free_until());
}

template <class SceneT>
typename KinematicsOf<SceneT>::Mover GeneralWorld<SceneT>::mover(int proxy, Scalar until) const {
  const BodyState& state = states_[body_of(proxy)];
  return Kinematics::mover(
      actor_at(body_of(proxy)), part_at(proxy),
      Kinematics::rest_of(state.plan.motion, now_ - state.start, until - now_));
}

template <class SceneT>
void GeneralWorld<SceneT>::search_pair(ProxyPair pair, Scalar until, PairQuery& query) {
  if constexpr (!SceneT::kRotation) {
    query =
        Kinematics::search(mover(pair.first, until), mover(pair.second, until), settings_.search);
  } else {
    const auto moving_pair = make_moving_pair(mover(pair.first, until), mover(pair.second, until));
    query.search.outcome = Outcome::kInvalid;
    query.search.t_free = query.search.t_hit = 0;
    query.search.evaluations = 0;
    if (!moving_pair.ok()) return;
    query.origin_W = moving_pair.value.origin_W;
    query.scale = moving_pair.value.scale;
    query.contact_gap = Search::contact_gap(moving_pair.value, settings_.search);
    query.search = search_with_seed(pair, moving_pair.value);
    if (query.outcome() == Outcome::kTouching && may_part(pair, query)) {
      query.search = search_thinner(moving_pair.value, query, pair);
    }
  }
}

/// A pair that touches and parts, but cannot be opened to the margin: because neither can be
/// pushed, or because their neighbours left no room when their contact was resolved
/// (src/world/world.md, "No room").
template <class SceneT>
bool GeneralWorld<SceneT>::may_part(ProxyPair pair, const PairQuery& query) const {
  if (!(query.search.gap_rate > rest_speed_)) return false;
  bool may = false;
  if constexpr (kLeads) may = is_immovable(pair);
  if constexpr (kCountsRepeats<SceneT>) may = may || this->was_resolved(pair);
  return may;
}

/// The seed is a direction in W, and as good a guess in the next round or step.
template <class SceneT>
SearchResult<typename GeneralWorld<SceneT>::Scalar> GeneralWorld<SceneT>::search_with_seed(
    ProxyPair pair, const MovingPair<Scalar>& moving_pair) {
  if constexpr (Search::kUsesSeed) {
    auto result = Search::search(moving_pair, settings_.search, this->recall(pair));
    if (result.outcome != Outcome::kInvalid) this->remember(pair, result.witness.axes.normal_AB);
    return result;
  } else {
    return Search::search(moving_pair, settings_.search, Vec3<Scalar>::Zero());
  }
}

/// What cannot be opened to the margin is searched as if it were thinner by what is missing to what
/// the search calls contact (src/world/detail/resolution.md).
template <class SceneT>
SearchResult<typename GeneralWorld<SceneT>::Scalar> GeneralWorld<SceneT>::search_thinner(
    const MovingPair<Scalar>& moving_pair, const PairQuery& query, ProxyPair pair) const {
  Scalar missing = margin_of(query, pair) - query.search.witness.gap;
  if (!(kLeads && is_immovable(pair))) missing -= query.contact_gap;
  const Scalar radii = moving_pair.A.radius + moving_pair.B.radius;
  if (!(missing < radii)) return query.search;
  MovingPair<Scalar> thinner = moving_pair;
  thinner.A.radius *= Scalar(1) - missing / radii;
  thinner.B.radius *= Scalar(1) - missing / radii;
  SearchResult<Scalar> result =
      Search::search(thinner, settings_.search, query.search.witness.axes.normal_AB);
  result.evaluations += query.search.evaluations;
  return result;
}

}  // namespace batuta::detail
