// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld: blows, and what they see of two bodies. Included by general_contact.hpp.

#include "batuta/geometry/direction.hpp"
#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

/// What counts as rest: where bodies settle, also what gravity makes in a step.
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::rest_speed() const {
  if constexpr (SceneT::kResting == RestingContact::kNone) {
    return std::numeric_limits<Scalar>::min();  // all that approaches collides
  } else {
    Scalar speed = bodies_.settings.rest_speed;
    if constexpr (kSolves && SceneT::kGravity) {
      speed = max_of(speed, bodies_.dt * length(bodies_.settings.gravity_W));
    }
    return speed;
  }
}

template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::restitution_of(ProxyPair pair) const {
  if constexpr (SceneT::kRestitution) {
    return pair_restitution(bodies_.actor(BodiesT::body_of(pair.first)).restitution,
                            bodies_.actor(BodiesT::body_of(pair.second)).restitution);
  } else {
    return Scalar(0);
  }
}

/// Two bodies as a blow sees them: where they are, and how their matter moves now.
template <class SceneT>
typename GeneralWorld<SceneT>::Sides GeneralWorld<SceneT>::sides_of(ProxyPair pair) const {
  const auto side = [this](int proxy) {
    const std::size_t slot = BodiesT::body_of(proxy);
    const auto& body = bodies_.actor(slot).body;
    return Collider<Scalar>{body.X_WB, bodies_.twist_now(slot), body.inverse_mass,
                            body.inverse_moments};
  };
  return {side(pair.first), side(pair.second)};
}

/// Adds an impulse. One that its controller moves first gets the momentum that goes with that, so
/// that the impulse is added to what the body really has.
template <class SceneT>
void GeneralWorld<SceneT>::push(int proxy, const Collider<Scalar>& side,
                                const Momentum<Scalar>& change) {
  const std::size_t slot = BodiesT::body_of(proxy);
  auto& body = bodies_.actor(slot).body;
  if constexpr (!BodiesT::kIsFree) {
    const auto& plan = bodies_.states[slot].plan;
    if (!plan.by_momentum) body.momentum = momentum_of(body, plan.motion.twist);
  }
  for (int i = 0; i < 3; ++i) {  // Bound: 3; by component: expressions double the code
    if (side.inverse_mass > Scalar(0)) body.momentum.linear_W[i] += change.linear_W[i];
    if (!is_zero(side.inverse_moments)) body.momentum.angular_W[i] += change.angular_W[i];
  }
}

/// The impulse of a blow, given to both momenta.
template <class SceneT>
Result<Impulse<typename GeneralWorld<SceneT>::Scalar>> GeneralWorld<SceneT>::strike(
    ProxyPair pair, const Sides& sides, const Contact<Scalar>& contact, Scalar restitution) {
  Result<Impulse<Scalar>> hit;
  if constexpr (SceneT::kFriction) {
    FrictionLaw<Scalar> law;
    law.restitution = restitution;
    law.friction = pair_friction(bodies_.actor(BodiesT::body_of(pair.first)).friction,
                                 bodies_.actor(BodiesT::body_of(pair.second)).friction);
    hit = friction_impulse(sides.A, sides.B, contact, law);
  } else {
    hit = collision_impulse(sides.A, sides.B, contact, restitution);
  }
  if (!hit.ok()) return hit;
  push(pair.first, sides.A, hit.value.on_A);
  push(pair.second, sides.B, hit.value.on_B);
  return hit;
}

/// v_rel of a pair at its contact, m/s.
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::velocity_between(
    ProxyPair pair, const Contact<Scalar>& contact) const {
  if constexpr (SceneT::kRotation) {
    return velocity_between(sides_of(pair), contact);
  } else {
    const std::size_t a = BodiesT::body_of(pair.first);
    const std::size_t b = BodiesT::body_of(pair.second);
    return contact.normal_BA_W.dot(bodies_.twist_now(a) - bodies_.twist_now(b));
  }
}

/// A blow of two bodies that do not turn, with their velocities of now.
template <class SceneT>
StraightHit<typename GeneralWorld<SceneT>::Scalar> GeneralWorld<SceneT>::strike_straight(
    std::size_t a, std::size_t b, const Vec3<Scalar>& normal_BA_W, Scalar restitution) {
  const auto fall_by = [this](std::size_t slot, Scalar time) {
    if constexpr (SceneT::kGravity) {
      if (!bodies_.falls(slot)) return;
      auto& body = bodies_.actor(slot).body;
      body.momentum_W += (time / body.inverse_mass) * bodies_.settings.gravity_W;
    }
  };
  fall_by(a, bodies_.now - bodies_.dt);
  fall_by(b, bodies_.now - bodies_.dt);
  const auto hit =
      straight_impulse(bodies_.actor(a).body, bodies_.actor(b).body, normal_BA_W, restitution);
  fall_by(a, bodies_.dt - bodies_.now);
  fall_by(b, bodies_.dt - bodies_.now);
  return hit;
}

/// A blow that is passed on: where the two are now.
template <class SceneT>
void GeneralWorld<SceneT>::strike_neighbour(ProxyPair pair) {
  const CapsuleGap<Scalar> gap =
      capsule_gap(bodies_.shape_W(pair.first), bodies_.shape_W(pair.second));
  const Nearest<Scalar> at = {contact_from(gap, zero<Scalar>()), gap.axes.s, gap.axes.u};
  const auto hit = strike(pair, sides_of(pair), at.contact, restitution_of(pair));
  if (!hit.ok()) {
    ++bodies_.report.resolutions_invalid;
    return;
  }
  Answer<Scalar> result;
  result.kind = ContactKind::kColliding;
  result.v_rel = hit.value.v_rel;
  result.impulse = hit.value.magnitude;
  result.impulse_A_W = hit.value.on_A.linear_W;
  touches_.record(bodies_, pair, at, result);
  tell_controllers(pair, at.contact, result, {});
}

template <class SceneT>
void GeneralWorld<SceneT>::tell_controllers(ProxyPair pair, const Contact<Scalar>& contact,
                                            const Answer<Scalar>& result,
                                            const Separation<Scalar>& made) {
  if constexpr (!BodiesT::kIsFree) {
    for (int i = 0; i < 2; ++i) {  // Bound: 2
      const bool is_A = i == 0;
      ActorType& actor = bodies_.actor(BodiesT::body_of(is_A ? pair.first : pair.second));
      Feedback<Scalar> feedback{bodies_.now, result.impulse, is_A ? made.shift_A_W : made.shift_B_W,
                                result.impulse_A_W, contact.point_W};
      if (!is_A) feedback.impulse_W = -feedback.impulse_W;
      actor.controller.on_contact(actor.body, feedback);
    }
  }
}

}  // namespace batuta::detail
