// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld, third part: what happens at a contact. Included by general_world.hpp.

#include "batuta/geometry/direction.hpp"
#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

/// A pair as it is now, without a search: for a contact whose search was not kept.
template <class SceneT>
void GeneralWorld<SceneT>::look(ProxyPair pair, PairQuery& query) {
  const auto moving_pair = make_moving_pair(mover(pair.first, dt_), mover(pair.second, dt_));
  query = {};
  if (!moving_pair.ok()) return;
  query.origin_W = moving_pair.value.origin_W;
  query.scale = moving_pair.value.scale;
  query.contact_gap = Search::contact_gap(moving_pair.value, settings_.search);
  query.search.outcome = Outcome::kContact;
  query.search.witness = gap_at(moving_pair.value, Scalar(0));
  query.search.gap_rate = gap_rate_at(moving_pair.value, query.search.witness, Scalar(0));
  queries_.forget();
}

template <class SceneT>
void GeneralWorld<SceneT>::resolve_turning(const CandidateType& candidate, const PairQuery& query) {
  const std::size_t a = body_of(candidate.pair.first);
  const std::size_t b = body_of(candidate.pair.second);
  const CapsuleGap<Scalar>& witness = query.search.witness;
  Nearest<Scalar> nearest = {contact_from(witness, query.origin_W), witness.axes.s, witness.axes.u};
  if constexpr (kLeads) {
    if (is_immovable(candidate.pair)) return block(candidate, query, nearest);
  }
  const Scalar margin = margin_of(query, candidate.pair);
  const std::array<Momentum<Scalar>, 2> before = {actor_at(a).body.momentum,
                                                  actor_at(b).body.momentum};
  std::array<ContactSide<Scalar>, 2> sides = {side(a), side(b)};
  if constexpr (SceneT::kLineContact) {
    nearest.contact = pressed(candidate.pair, sides, nearest.contact, margin);
  }
  const auto options = options_for(margin);
  if constexpr (SceneT::kMaxBodies > 2) {
    make_room(candidate.pair, nearest.contact, options, sides);
  }
  const bool is_last = uses_up_resolutions(candidate.pair);
  const auto impulse = impulse_for(candidate.pair, sides, nearest.contact, is_last);
  const auto resolution = resolve_contact(sides[0], sides[1], nearest.contact, impulse, options);
  if (!resolution.ok()) {
    actor_at(a).body.momentum = before[0];
    actor_at(b).body.momentum = before[1];
    ++report_.resolutions_invalid;
    hold_pair(candidate.pair, dt_);
    return;
  }
  const bool is_tight =
      resolution.value.separated && nearest.contact.gap + opened(resolution.value) < margin;
  apply_separation_time(candidate.pair, resolution.value, is_last || is_tight);
  if constexpr (kSettles) {
    if (is_tight) stop_pair(candidate.pair);
  }
  notify_controller(a, resolution.value, resolution.value.separation.shift_A_W);
  notify_controller(b, resolution.value, resolution.value.separation.shift_B_W);
  record(candidate, nearest, resolution.value);
}

/// The impulse that the pair's laws give; without restitution where the scene's bodies settle.
template <class SceneT>
Result<Impulse<Scalar_of<SceneT>>> GeneralWorld<SceneT>::impulse_for(
    ProxyPair pair, const std::array<ContactSide<Scalar>, 2>& sides, const Contact<Scalar>& contact,
    bool is_last) const {
  const ActorType& P = actor_at(body_of(pair.first));
  const ActorType& Q = actor_at(body_of(pair.second));
  const Collider<Scalar> A = collider_of(sides[0]);
  const Collider<Scalar> B = collider_of(sides[1]);
  Scalar restitution = 0;
  if constexpr (SceneT::kRestitution) {
    restitution = pair_restitution(P.restitution, Q.restitution);
    if constexpr (kSettles) {
      const Scalar v_rel = relative_velocity(contact, A.X_WB, A.twist, B.X_WB, B.twist);
      const bool bounces = classify(v_rel, rest_speed_) == ContactKind::kColliding;
      if (is_last || !bounces) restitution = 0;
    }
  }
  if constexpr (SceneT::kFriction) {
    FrictionLaw<Scalar> law;
    law.restitution = restitution;
    law.friction = pair_friction(P.friction, Q.friction);
    return friction_impulse(A, B, contact, law);
  } else {
    return collision_impulse(A, B, contact, restitution);
  }
}

/// Counts the contacts of a pair, whatever their kind: else, where bodies settle, a few pairs
/// between others would take all contacts of a step. @returns whether this is the pair's last
template <class SceneT>
bool GeneralWorld<SceneT>::uses_up_resolutions(ProxyPair pair) {
  bool is_last = false;
  if constexpr (kCountsRepeats<SceneT>) {
    const int resolutions = this->repeat(pair);
    is_last = kSettles && resolutions >= SceneT::kMaxSeparations;
  }
  return is_last;
}

/// By how much a separation has opened the gap, m.
template <class SceneT>
Scalar_of<SceneT> GeneralWorld<SceneT>::opened(const Resolution<Scalar>& resolution) {
  return length(resolution.separation.shift_A_W) + length(resolution.separation.shift_B_W);
}

/// Time for a separation: the paper's f(D), for which both are held. Where bodies settle, a pair
/// is frozen by its last contact of a step, or by one that its neighbours left no room for: it
/// would be found touching again at once.
template <class SceneT>
void GeneralWorld<SceneT>::apply_separation_time(ProxyPair pair,
                                                 const Resolution<Scalar>& resolution,
                                                 bool freezes) {
  if constexpr (kReleases) {
    if (resolution.separated) hold_pair(pair, now_ + resolution.separation.duration);
  }
  if constexpr (kSettles) {
    if (!freezes) return;
    ++report_.frozen;
    hold_pair(pair, dt_);
  }
}

/// What has no room to move has stopped: of its momentum remains the share of the step in which it
/// did move. Kept, it would come out again as soon as there is room.
template <class SceneT>
void GeneralWorld<SceneT>::stop_pair(ProxyPair pair) {
  const Scalar share = now_ / dt_;
  for (const Slot proxy : {pair.first, pair.second}) {  // Bound: 2
    Body<Scalar>& body = actor_at(body_of(proxy)).body;
    if (!states_[body_of(proxy)].plan.by_momentum) continue;
    body.momentum.linear_W *= share;
    body.momentum.angular_W *= share;
  }
}

/// Neither body can be pushed: where one is moved into the other, both stop.
template <class SceneT>
bool GeneralWorld<SceneT>::is_immovable(ProxyPair pair) const {
  return is_fixed(actor_at(body_of(pair.first)).body) &&
         is_fixed(actor_at(body_of(pair.second)).body);
}

template <class SceneT>
void GeneralWorld<SceneT>::block(const CandidateType& candidate, const PairQuery& query,
                                 const Nearest<Scalar>& nearest) {
  Resolution<Scalar> resolution;
  resolution.v_rel = query.search.gap_rate;
  resolution.kind = classify(resolution.v_rel, rest_speed_);
  ++report_.blocked;
  hold_pair(candidate.pair, dt_);
  record(candidate, nearest, resolution);
}

template <class SceneT>
ResolutionOptions<Scalar_of<SceneT>> GeneralWorld<SceneT>::options_for(Scalar margin) const {
  ResolutionOptions<Scalar> options;
  options.margin = margin;
  options.settles = kSettles;
  if constexpr (SceneT::kResting != RestingContact::kNone) {
    options.rest_speed = rest_speed_;
    options.separation = settings_.separation;
    options.min_separation_time = settings_.min_separation_time;
  } else {  // all that approaches collides
    options.rest_speed = std::numeric_limits<Scalar>::min();
    options.separation = options.min_separation_time = options.rest_speed;
  }
  return options;
}

/// The gap from which the next search lets parting bodies go (src/world/detail/resolution.md).
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::margin_of(const PairQuery& query,
                                                                      ProxyPair pair) const {
  constexpr Scalar kContactGaps = 2;
  constexpr Scalar kUlps = 64;
  const Scalar size = length(actor_at(body_of(pair.first)).body.X_WB.p_W) +
                      length(actor_at(body_of(pair.second)).body.X_WB.p_W) + query.scale;
  return kContactGaps * query.contact_gap + kUlps * kRoundOff<Scalar> * size;
}

/// A body at a contact. One that its controller moves gets the momentum that goes with the
/// controller's twist, so that the impulse is added to what the body really has.
template <class SceneT>
ContactSide<Scalar_of<SceneT>> GeneralWorld<SceneT>::side(std::size_t slot) {
  Body<Scalar>& body = actor_at(slot).body;
  const PlannedMotion<Scalar>& plan = states_[slot].plan;
  if (!plan.by_momentum) body.momentum = momentum_of(body, plan.motion.twist);
  return {&body, plan.by_momentum ? twist_of(body) : plan.motion.twist,
          std::numeric_limits<Scalar>::max()};
}

/// Near-parallel capsules press along a line: the contact at its centre of pressure.
template <class SceneT>
Contact<Scalar_of<SceneT>> GeneralWorld<SceneT>::pressed(
    ProxyPair pair, const std::array<ContactSide<Scalar>, 2>& sides, const Contact<Scalar>& contact,
    Scalar slack) const {
  return pressure_contact(collider_of(sides[0]), collider_of(sides[1]), shape_W(pair.first),
                          shape_W(pair.second), contact, slack);
}

/// How far each of the two may be shifted.
template <class SceneT>
void GeneralWorld<SceneT>::make_room(ProxyPair pair, const Contact<Scalar>& contact,
                                     const ResolutionOptions<Scalar>& options,
                                     std::array<ContactSide<Scalar>, 2>& sides) const {
  const std::size_t a = body_of(pair.first);
  const std::size_t b = body_of(pair.second);
  const Scalar shift = max_of(options.separation, options.margin) - min_of(contact.gap, Scalar(0));
  sides[0].room = room_of(a, b, contact.normal_BA_W, shift);
  sides[1].room = room_of(b, a, -contact.normal_BA_W, shift);
}

/// Half the way to the nearest neighbour: both may be pushed towards each other in the same round.
/// A neighbour that the shift does not lead towards stays as far away as it is: the plane between
/// the two goes on separating them.
/// @param away_W  direction of the shift
/// @param shift   the longest that may be asked for, m; what is further away is no neighbour
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::room_of(std::size_t slot,
                                                                    std::size_t other,
                                                                    const Vec3<Scalar>& away_W,
                                                                    Scalar shift) const {
  Scalar room = std::numeric_limits<Scalar>::max();
  for (int part = 0; part < parts_of(actor_at(slot)); ++part) {  // Bound: kCapsulesPerBody
    const Capsule<Scalar> shape = shape_W(proxy_of(slot, part));
    const Aabb<Scalar> near = kdop_of<Scalar, 6>(shape, shape, 2 * shift);
    for (int k = 0; k < kProxies; ++k) {  // Bound: all capsules
      const std::size_t neighbour = body_of(k);
      const bool is_third = neighbour != slot && neighbour != other;
      if (!is_third || !sweep_.contains(static_cast<Slot>(k)) ||
          !overlaps<Scalar, 6>(near, sweep_.box(static_cast<Slot>(k))) ||
          !may_meet(actor_at(slot), actor_at(neighbour))) {
        continue;
      }
      const CapsuleGap<Scalar> gap = capsule_gap(shape, shape_W(k));
      const bool leads_away = gap.gap > Scalar(0) && !(gap.axes.normal_AB.dot(away_W) > Scalar(0));
      if (!leads_away) room = min_of(room, gap.gap / Scalar(2));
    }
  }
  return max_of(room, Scalar(0));
}

/// A capsule where it is now.
template <class SceneT>
Capsule<Scalar_of<SceneT>> GeneralWorld<SceneT>::shape_W(int proxy) const {
  const ActorType& actor = actor_at(body_of(proxy));
  const BodyState& state = states_[body_of(proxy)];
  const bool is_here = !(state.start < now_);
  const Pose<Scalar> X_WB =
      is_here ? actor.body.X_WB : pose_at(state.plan.motion, now_ - state.start);
  return to_world(X_WB, part_of(actor, part_at(proxy)));
}

template <class SceneT>
void GeneralWorld<SceneT>::notify_controller(std::size_t slot, const Resolution<Scalar>& resolution,
                                             const Vec3<Scalar>& shift_W) {
  ActorType& actor = actor_at(slot);
  if constexpr (SceneT::kSleep) {
    // A blow has to show first; what only lies on a sleeper lets it sleep on.
    const bool is_blow = resolution.kind == ContactKind::kColliding && this->sleeps(slot);
    if (is_blow) this->rouse(slot);
    this->wake(slot);
  }
  actor.controller.on_contact(actor.body, Feedback<Scalar>{now_, resolution.impulse, shift_W});
}

/// Bodies that do not turn: an impulse, after which they part, and what parts is free for good.
template <class SceneT>
void GeneralWorld<SceneT>::resolve_straight(const CandidateType& candidate) {
  ActorType& A = actor_at(body_of(candidate.pair.first));
  ActorType& B = actor_at(body_of(candidate.pair.second));
  Scalar restitution = 0;
  if constexpr (SceneT::kRestitution) {
    restitution = pair_restitution(A.restitution, B.restitution);
  }
  const Nearest<Scalar> at = nearest(candidate.pair);
  const auto hit = straight_impulse(A.body, B.body, at.contact.normal_BA_W, restitution);
  Resolution<Scalar> resolution;
  resolution.kind = ContactKind::kColliding;
  resolution.v_rel = hit.v_rel;
  resolution.impulse = hit.impulse;
  record(candidate, at, resolution);
}

/// Without response: the contact is told once, and everybody moves on.
template <class SceneT>
void GeneralWorld<SceneT>::report_only(const CandidateType& candidate) {
  if (!candidate.is_contact() || contacts_resolved_ == SceneT::kMaxContacts)
    return count_cut(candidate);
  ++contacts_resolved_;
  if constexpr (SceneT::kRotation) {
    PairQuery& query = queries_.earliest();
    if constexpr (SceneT::kMaxPairs > 1) look(candidate.pair, query);  // the only pair's is known
    Resolution<Scalar> resolution;
    resolution.v_rel = query.search.gap_rate;
    resolution.kind = classify(resolution.v_rel, settings_.rest_speed);
    const CapsuleGap<Scalar>& witness = query.search.witness;
    record(candidate, {contact_from(witness, query.origin_W), witness.axes.s, witness.axes.u},
           resolution);
  } else {
    record(candidate, nearest(candidate.pair), {});
  }
}

}  // namespace batuta::detail
