// SPDX-License-Identifier: MIT
#pragma once
// World, first half: the rounds of a step, in the order in which they happen. Included by
// world.hpp.

#include "batuta/world/world.hpp"

namespace batuta {

template <class SceneT>
bool World<SceneT>::is_usable(const ActorType& actor) {
  return is_valid(actor.capsule_B) && is_finite(actor.body.X_WB.p_W) &&
         is_finite(actor.body.X_WB.q_WB) && is_finite(actor.body.momentum.p_W) &&
         is_finite(actor.body.momentum.b_W) && is_finite(actor.body.inverse_mass) &&
         actor.body.inverse_mass >= Scalar(0) && is_finite(actor.body.inverse_moments) &&
         actor.body.inverse_moments.minCoeff() >= Scalar(0) && actor.restitution >= Scalar(0) &&
         actor.restitution <= Scalar(1);
}

/// What a step sets up for itself is not part of what is saved.
template <class SceneT>
void World<SceneT>::restore(const World& saved) {
  static_cast<SeedsOf<SceneT>&>(*this) = saved;
  settings_ = saved.settings_;
  actors_.restore(saved.actors_);
  touching_ = saved.touching_;
  events_ = saved.events_;
  report_ = saved.report_;
}

template <class SceneT>
Status World<SceneT>::step(Scalar dt) {
  if (!is_finite(dt) || !(dt > Scalar(0))) return Status::kInvalidArgument;
  begin_step(dt);
  for (int round = 0; round < kMaxRounds && now_ < dt_; ++round) run_round();  // Bound: kMaxRounds
  BATUTA_INVARIANT(!(now_ < dt_));
  end_step();
  return Status::kOk;
}

template <class SceneT>
void World<SceneT>::begin_step(Scalar dt) {
  report_ = {};
  events_.clear();
  now_ = 0;
  dt_ = dt;
  contacts_answered_ = 0;
  for (Track& track : tracks_) track.held_until = 0;  // Bound: kMaxBodies
}

template <class SceneT>
void World<SceneT>::run_round() {
  const Scalar until = end_of_round();
  plan(until);
  find_pairs();
  const Hit hit = first_hit();
  if (!hit.any) {
    advance(until - now_);
    now_ = until;
    return;
  }
  advance(hit.search.t_free);
  now_ = min_of(now_ + hit.search.t_free, until);
  answer(hit);
}

/// The end of the step, or the first time at which a held body is released.
template <class SceneT>
typename World<SceneT>::Scalar World<SceneT>::end_of_round() const {
  Scalar until = dt_;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (is_present(slot) && is_held(slot)) until = min_of(until, tracks_[slot].held_until);
  }
  return until;
}

template <class SceneT>
void World<SceneT>::plan(Scalar until) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    Proxy<Scalar>& proxy = proxies_[slot];
    proxy.present = is_present(slot) && is_usable(actor_at(slot));
    if (!proxy.present) {
      if (is_present(slot)) ++report_.courses_invalid;
      continue;
    }
    plan_course(slot, until - now_);
    const Twist<Scalar>& twist = tracks_[slot].course.motion.twist;
    const bool still = twist.v_W == Vec3<Scalar>::Zero() && twist.w_W == Vec3<Scalar>::Zero();
    proxy.swept_W = swept_aabb(moving(slot));
    proxy.owner = actor_at(slot).owner;
    proxy.is_wall = still && is_fixed(actor_at(slot).body);
  }
}

template <class SceneT>
void World<SceneT>::plan_course(std::size_t slot, Scalar duration) {
  const ActorType& actor = actor_at(slot);
  Track& track = tracks_[slot];
  if (!is_held(slot)) {
    track.course = actor.driver.course(actor.body, now_, duration);
    if (is_valid(track.course.motion)) return;
    ++report_.courses_invalid;
    hold(slot, dt_);
  }
  track.course.motion = still(actor.body.X_WB, duration);
}

/// Between two held bodies nothing changes before one of them is released: such a pair waits.
template <class SceneT>
void World<SceneT>::find_pairs() {
  pairs_.clear();
  for_each_pair(proxies_, [this](BodyPair pair) {
    const bool both_held = is_held(pair.first) && is_held(pair.second);
    if (both_held || pairs_.push(pair)) return;
    ++report_.pairs_dropped;
    hold_pair(pair, dt_);
  });
}

/// The pair that is proven free for the shortest time; the first in order where several are.
template <class SceneT>
typename World<SceneT>::Hit World<SceneT>::first_hit() {
  Hit first;
  for (const BodyPair pair : pairs_) {  // Bound: kMaxPairs
    const Hit hit = search(pair);
    if (hit.any && (!first.any || hit.search.t_free < first.search.t_free)) first = hit;
  }
  return first;
}

template <class SceneT>
typename World<SceneT>::Hit World<SceneT>::search(BodyPair pair) {
  Hit hit;
  hit.pair = pair;
  ++report_.pairs;
  const auto moving_pair = make_moving_pair(moving(pair.first), moving(pair.second));
  if (moving_pair.ok()) {
    hit.origin_W = moving_pair.value.origin_W;
    hit.scale = moving_pair.value.scale;
    hit.contact_gap = Search::contact_gap(moving_pair.value, settings_.search);
    hit.search = search_with_seed(pair, moving_pair.value);
    if (hit.search.outcome == Outcome::kTouching && is_immovable(pair) &&
        hit.search.gap_rate > settings_.rest_speed) {
      hit.search = let_go(moving_pair.value, hit);
    }
    report_.evaluations += hit.search.evaluations;
  }
  hit.any = hit.search.outcome != Outcome::kFree;
  return hit;
}

/// The seed is a direction in W, and as good a guess in the next round or step.
template <class SceneT>
SearchResult<typename World<SceneT>::Scalar> World<SceneT>::search_with_seed(
    BodyPair pair, const MovingPair<Scalar>& moving_pair) {
  if constexpr (Search::kUsesSeed) {
    auto result = Search::search(moving_pair, settings_.search, this->recall(pair));
    if (result.outcome != Outcome::kInvalid) this->remember(pair, result.witness.axes.normal_AB);
    return result;
  } else {
    return Search::search(moving_pair, settings_.search, Vec3<Scalar>::Zero());
  }
}

/// What cannot be pushed cannot be opened to the margin either; where such a pair touches and
/// parts, it is searched as if it were thinner by what is missing (src/world/encounter.md).
template <class SceneT>
SearchResult<typename World<SceneT>::Scalar> World<SceneT>::let_go(
    const MovingPair<Scalar>& moving_pair, const Hit& hit) const {
  const Scalar missing = margin_of(hit) - hit.search.witness.gap;
  const Scalar radii = moving_pair.A.radius + moving_pair.B.radius;
  if (!(missing < radii)) return hit.search;
  MovingPair<Scalar> thinner = moving_pair;
  thinner.A.radius *= Scalar(1) - missing / radii;
  thinner.B.radius *= Scalar(1) - missing / radii;
  SearchResult<Scalar> result =
      Search::search(thinner, settings_.search, hit.search.witness.axes.normal_AB);
  result.evaluations += hit.search.evaluations;
  return result;
}

template <class SceneT>
void World<SceneT>::advance(Scalar duration) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (takes_part(slot)) actor_at(slot).body.X_WB = pose_at(tracks_[slot].course.motion, duration);
  }
}

template <class SceneT>
void World<SceneT>::hold(std::size_t slot, Scalar until) {
  Track& track = tracks_[slot];
  track.held_until = max_of(track.held_until, min_of(until, dt_));
  track.course.motion = still(actor_at(slot).body.X_WB, track.course.motion.duration);
  report_.time_held = max_of(report_.time_held, track.held_until - now_);
}

template <class SceneT>
void World<SceneT>::hold_pair(BodyPair pair, Scalar until) {
  hold(pair.first, until);
  hold(pair.second, until);
}

template <class SceneT>
void World<SceneT>::end_step() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (is_present(slot)) actor_at(slot).driver.on_step_end(actor_at(slot).body, dt_);
  }
  end_touches();
}

}  // namespace batuta
