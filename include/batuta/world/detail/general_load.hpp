// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld: who carries what falls, where contacts do not last (src/world/world.md, "The
// fall"). Included by general_contact.hpp.

#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

/// Adds to a body's momentum. @param times  s
template <class SceneT, class BodyT>
void add_support(BodyT& body, const Momentum<Scalar_of<SceneT>>& support, Scalar_of<SceneT> times) {
  if constexpr (SceneT::kRotation) {
    body.momentum.linear_W += times * support.linear_W;
    body.momentum.angular_W += times * support.angular_W;
  } else {
    body.momentum_W += times * support.linear_W;
  }
}

/// Whether one of the two falls and the other does not, so that gravity would close the contact
/// within the step: then what falls is carried for the rest of it. @returns its proxy, or kNobody
template <class SceneT>
int GeneralWorld<SceneT>::takes_load(ProxyPair pair, const Contact<Scalar>& contact) {
  if constexpr (kCarries<SceneT>) {
    const std::size_t a = BodiesT::body_of(pair.first);
    const std::size_t b = BodiesT::body_of(pair.second);
    const bool falls_a = bodies_.falls(a);
    if (falls_a == bodies_.falls(b)) return kNobody;
    const Scalar fall =
        (bodies_.dt - bodies_.now) * contact.normal_BA_W.dot(bodies_.settings.gravity_W);
    const Scalar at_end = velocity_between(pair, contact) + (falls_a ? fall : -fall);
    if (!(at_end < Scalar(0))) return kNobody;
    bodies_.states[falls_a ? a : b].loaded = true;
    return falls_a ? pair.first : pair.second;
  } else {
    return kNobody;
  }
}

/// What carries a body has given it an impulse for the rest of the step.
/// @param carried_by  who is carried, and by whom
template <class SceneT>
void GeneralWorld<SceneT>::note_support(ProxyPair carried_by, const Momentum<Scalar>& impulse,
                                        [[maybe_unused]] const Momentum<Scalar>& on_carrier) {
  if constexpr (kCarries<SceneT>) {
    const std::size_t slot = BodiesT::body_of(carried_by.first);
    auto& state = bodies_.states[slot];
    const Scalar rest = bodies_.dt - bodies_.now;
    if (!state.loaded || !(rest > Scalar(0))) return;
    for (int i = 0; i < 3; ++i) {  // Bound: 3; by component: expressions double the code
      state.support.linear_W[i] += impulse.linear_W[i] / rest;
      state.support.angular_W[i] += impulse.angular_W[i] / rest;
    }
    note_reaction(slot, BodiesT::body_of(carried_by.second), on_carrier.angular_W / rest);
  }
}

/// Who turns about an axle gives way to what it carries, and gets that back where the other is
/// struck off it. Other carriers do not: they are fixed, led or carried themselves.
template <class SceneT>
void GeneralWorld<SceneT>::note_reaction([[maybe_unused]] std::size_t slot,
                                         [[maybe_unused]] std::size_t carrier,
                                         [[maybe_unused]] const Vec3<Scalar>& torque_W) {
  if constexpr (kCarries<SceneT> && SceneT::kRotation) {
    if (bodies_.is_led(carrier) || bodies_.actor(carrier).body.inverse_mass > Scalar(0)) return;
    auto& reactions = bodies_.states[slot].reactions;
    const bool is_first =
        reactions[0].carrier == carrier || reactions[0].carrier == Reaction<Scalar>::kNobody;
    auto& reaction = reactions[is_first ? 0 : 1];
    if (reaction.carrier != carrier) reaction = {};
    reaction.carrier = static_cast<std::uint16_t>(carrier);
    reaction.torque_W += torque_W;
  }
}

/// @param times  s: < 0: what the rest of the step would have taken comes back
template <class SceneT>
void GeneralWorld<SceneT>::give_reactions([[maybe_unused]] std::size_t slot,
                                          [[maybe_unused]] Scalar times) {
  if constexpr (kCarries<SceneT> && SceneT::kRotation) {
    for (const auto& reaction : bodies_.states[slot].reactions) {  // Bound: 2
      if (reaction.carrier == Reaction<Scalar>::kNobody) continue;
      bodies_.actor(reaction.carrier).body.momentum.angular_W += times * reaction.torque_W;
    }
  }
}

/// Who has been struck off what carried it: that is planned anew.
template <class SceneT>
void GeneralWorld<SceneT>::drop_reactions([[maybe_unused]] std::size_t slot) {
  if constexpr (kCarries<SceneT> && SceneT::kRotation) {
    for (auto& reaction : bodies_.states[slot].reactions) {  // Bound: 2
      if (reaction.carrier == Reaction<Scalar>::kNobody) continue;
      bodies_.advance_to_now(reaction.carrier);
      bodies_.states[reaction.carrier].changed = bodies_.is_changed = true;
      reaction = {};
    }
  }
}

/// The impulse of a load that is taken. @param carried  proxy of who is carried
template <class SceneT>
void GeneralWorld<SceneT>::note_load(ProxyPair pair, int carried, const Momentum<Scalar>& on_A,
                                     const Momentum<Scalar>& on_B) {
  if (carried == pair.first) return note_support(pair, on_A, on_B);
  note_support({pair.second, pair.first}, on_B, on_A);
}

template <class SceneT>
void GeneralWorld<SceneT>::note_supports(ProxyPair pair, const Momentum<Scalar>& on_A,
                                         const Momentum<Scalar>& on_B) {
  note_support(pair, on_A, on_B);
  note_support({pair.second, pair.first}, on_B, on_A);
}

/// The two as the load of one presses on the other: what is carried itself passes it on to what it
/// lies on, and gives way no further than that.
template <class SceneT>
typename GeneralWorld<SceneT>::Sides GeneralWorld<SceneT>::sides_of_load(ProxyPair pair,
                                                                         int carried) const {
  Sides sides = sides_of(pair);
  if constexpr (kCarries<SceneT>) {
    const bool is_A = carried == pair.first;
    if (bodies_.states[BodiesT::body_of(is_A ? pair.second : pair.first)].loaded) {
      auto& carrier = is_A ? sides.B : sides.A;
      carrier.inverse_mass = 0;
      carrier.inverse_moments.setZero();
    }
  }
  return sides;
}

/// The same of bodies that do not turn, whose carrier is fixed, or carried. @param pressed  impulse
/// of loads alone, N s. @returns the impulse of the load that is taken
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::load_straight(
    ProxyPair pair, const Contact<Scalar>& contact, Scalar pressed) {
  const Vec3<Scalar>& normal_BA_W = contact.normal_BA_W;
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  const Vec3<Scalar> pressed_A_W = pressed * normal_BA_W;
  note_supports(pair, {pressed_A_W, zero<Scalar>()}, {-pressed_A_W, zero<Scalar>()});
  const int carried = takes_load(pair, contact);
  if (carried == kNobody) return Scalar(0);
  const bool is_A = carried == pair.first;
  auto& body = bodies_.actor(is_A ? a : b).body;
  const Scalar v_rel =
      normal_BA_W.dot(velocity_of(bodies_.actor(a).body) - velocity_of(bodies_.actor(b).body));
  const Scalar impulse = -v_rel / body.inverse_mass;
  const Vec3<Scalar> impulse_W = (is_A ? impulse : -impulse) * normal_BA_W;
  body.momentum_W += impulse_W;
  const Momentum<Scalar> push = {impulse_W, zero<Scalar>()};  // of who is carried alone
  note_load(pair, carried, push, push);
  return impulse;
}

/// What the velocity of a body's point is summed of, m/s.
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::speeds_at(
    std::size_t slot, [[maybe_unused]] const Vec3<Scalar>& point_W) const {
  if constexpr (SceneT::kRotation) {
    const Twist<Scalar> twist = bodies_.twist_now(slot);
    const Vec3<Scalar> arm_W = point_W - bodies_.actor(slot).body.X_WB.p_W;
    return length(twist.v_W) + length(twist.w_W) * length(arm_W);
  } else {
    return length(bodies_.twist_now(slot));
  }
}

/// What is carried falls, and its support gives no more. @returns what that gave
template <class SceneT>
Momentum<typename GeneralWorld<SceneT>::Scalar> GeneralWorld<SceneT>::release(std::size_t slot) {
  auto& state = bodies_.states[slot];
  const Momentum<Scalar> support = state.support;
  if (is_zero(support.linear_W)) return support;
  add_support<SceneT>(bodies_.actor(slot).body, support, bodies_.now - bodies_.dt);
  give_reactions(slot, bodies_.now - bodies_.dt);
  state.loaded = false;
  state.support = {};
  return support;
}

/// Before a contact is answered: whether it is a blow. Then who is carried falls from now on, or
/// what is struck upwards would rise for the rest of the step as if it weighed nothing; where it
/// still lies on something, that takes the load anew. If not, loads alone press: nothing bounces.
template <class SceneT>
bool GeneralWorld<SceneT>::is_blow([[maybe_unused]] ProxyPair pair,
                                   [[maybe_unused]] const Contact<Scalar>& contact) {
  if constexpr (kCarries<SceneT>) {
    const std::size_t a = BodiesT::body_of(pair.first);
    const std::size_t b = BodiesT::body_of(pair.second);
    if (is_zero(bodies_.states[a].support.linear_W) &&
        is_zero(bodies_.states[b].support.linear_W)) {
      return true;
    }
    const auto body_A = bodies_.actor(a).body;
    const auto body_B = bodies_.actor(b).body;
    const Momentum<Scalar> of_A = release(a);
    const Momentum<Scalar> of_B = release(b);
    const Scalar scale = speeds_at(a, contact.point_W) + speeds_at(b, contact.point_W) +
                         (bodies_.dt - bodies_.now) * length(bodies_.settings.gravity_W);
    const Scalar rounding = kLoadRoundings * kRoundOff<Scalar> * scale;
    if (velocity_between(pair, contact) < -rounding) {
      drop_reactions(a);
      drop_reactions(b);
      return true;
    }
    restore(a, body_A, of_A);
    restore(b, body_B, of_B);
    return false;
  } else {
    return true;
  }
}

template <class SceneT>
void GeneralWorld<SceneT>::restore(std::size_t slot, const BodyType& body,
                                   const Momentum<Scalar>& support) {
  if (is_zero(support.linear_W)) return;
  bodies_.actor(slot).body = body;
  give_reactions(slot, bodies_.dt - bodies_.now);
  bodies_.states[slot].support = support;
  bodies_.states[slot].loaded = true;
}

}  // namespace batuta::detail
