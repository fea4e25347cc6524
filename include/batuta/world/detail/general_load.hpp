// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld: who carries what falls, where contacts do not last (src/world/world.md, "The
// fall"). Included by general_contact.hpp.

#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

/// Adds to a body's momentum. An axle takes what does not turn it. @param times  s
template <class SceneT, class BodyT>
void add_support(BodyT& body, const Momentum<Scalar_of<SceneT>>& support, Scalar_of<SceneT> times) {
  using Scalar = Scalar_of<SceneT>;
  const Scalar moves = body.inverse_mass > Scalar(0) ? times : Scalar(0);
  if constexpr (SceneT::kRotation) {
    body.momentum.linear_W += moves * support.linear_W;
    body.momentum.angular_W += times * support.angular_W;
  } else {
    body.momentum_W += moves * support.linear_W;
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
    note_reaction(slot, BodiesT::body_of(carried_by.second), on_carrier, rest);
  }
}

/// Who turns about an axle, or is carried itself, gives way to what it carries, and gets that back
/// where the other is struck off it. Other carriers do not.
/// @param rest  s, in which it has that
template <class SceneT>
void GeneralWorld<SceneT>::note_reaction([[maybe_unused]] std::size_t slot,
                                         [[maybe_unused]] std::size_t carrier,
                                         [[maybe_unused]] const Momentum<Scalar>& on_carrier,
                                         [[maybe_unused]] Scalar rest) {
  if constexpr (kCarries<SceneT>) {
    if (bodies_.is_led(carrier)) return;
    auto& reactions = bodies_.states[slot].reactions;
    const bool is_first =
        reactions[0].carrier == carrier || reactions[0].carrier == Reaction<Scalar>::kNobody;
    auto& reaction = reactions[is_first ? 0 : 1];
    if (reaction.carrier != carrier) reaction = {};
    reaction.carrier = static_cast<std::uint16_t>(carrier);
    for (int i = 0; i < 3; ++i) {  // Bound: 3; by component: expressions double the code
      reaction.load.linear_W[i] += on_carrier.linear_W[i] / rest;
      reaction.load.angular_W[i] += on_carrier.angular_W[i] / rest;
    }
  }
}

/// @param times  s: < 0: what the rest of the step would have taken comes back
template <class SceneT>
void GeneralWorld<SceneT>::give_reactions([[maybe_unused]] std::size_t slot,
                                          [[maybe_unused]] Scalar times) {
  if constexpr (kCarries<SceneT>) {
    for (const auto& reaction : bodies_.states[slot].reactions) {  // Bound: 2
      if (reaction.carrier == Reaction<Scalar>::kNobody) continue;
      add_support<SceneT>(bodies_.actor(reaction.carrier).body, reaction.load, times);
    }
  }
}

/// Who has been struck off what carried it: that is planned anew. In a group, it stands.
template <class SceneT>
void GeneralWorld<SceneT>::drop_reactions([[maybe_unused]] std::size_t slot) {
  if constexpr (kCarries<SceneT>) {
    for (auto& reaction : bodies_.states[slot].reactions) {  // Bound: 2
      if (reaction.carrier == Reaction<Scalar>::kNobody) continue;
      auto& carrier = bodies_.states[reaction.carrier];
      if (carrier.group == BodiesT::kAlone) {
        bodies_.advance_to_now(reaction.carrier);
        carrier.changed = bodies_.is_changed = true;
      }
      reaction = {};
    }
  }
}

/// Whether a load presses on somebody whose own carrier gives way to him: what goes on to that one
/// along the support is given to nobody (world.md, "The fall").
template <class SceneT>
bool GeneralWorld<SceneT>::is_lost_below([[maybe_unused]] std::size_t carrier,
                                         [[maybe_unused]] const Vec3<Scalar>& load_W) const {
  bool is_lost = false;
  if constexpr (kCarries<SceneT> && SceneT::kMaxBodies > 3) {  // three, and what is below them
    const auto& state = bodies_.states[carrier];
    // Of a group that is carried nobody knows by whom.
    is_lost = is_zero(state.support.linear_W) && !bodies_.is_led(carrier);
    const Scalar share = along_support(load_W, state.support.linear_W);
    for (const auto& reaction : state.reactions) {  // Bound: 2
      if (reaction.carrier == Reaction<Scalar>::kNobody || bodies_.holds(reaction.carrier))
        continue;
      is_lost = is_lost || share * length(reaction.load.linear_W) >
                               kLoadRoundings * kRoundOff<Scalar> * length(load_W);
    }
  }
  return is_lost;
}

/// Who is carried himself gives way across his support, so that the load is less: with a of the
/// impulse J n across the support, softness w and the speed v that J stops, J is reduced to
/// v / (v + w (a . n)) of it. Corrects both impulses; that on who is carried was given already.
/// @param towards_W  the contact's normal, towards who is carried
template <class SceneT>
void GeneralWorld<SceneT>::give_way(std::size_t carried, std::size_t carrier,
                                    const Vec3<Scalar>& towards_W, Scalar speed,
                                    Momentum<Scalar>& on_carried, Momentum<Scalar>& on_carrier) {
  if constexpr (kCarries<SceneT>) {
    auto& body = bodies_.actor(carrier).body;
    if (!bodies_.states[carrier].loaded || !(body.inverse_mass > Scalar(0))) return;
    if (is_lost_below(carrier, on_carried.linear_W)) ++bodies_.report.resolutions_invalid;
    const Vec3<Scalar> across_W =
        across_support(on_carried.linear_W, bodies_.states[carrier].support.linear_W);
    const Scalar gives = body.inverse_mass * across_W.dot(towards_W);
    on_carrier = {};
    if (!(speed > Scalar(0)) || !(gives > Scalar(0))) return;
    const Scalar kept = speed / (speed + gives);
    add_support<SceneT>(bodies_.actor(carried).body, on_carried, kept - 1);
    on_carried.linear_W *= kept;
    on_carried.angular_W *= kept;
    on_carrier.linear_W = -kept * across_W;
    add_support<SceneT>(body, on_carrier, Scalar(1));
  }
}

/// What falls is carried from now on. @param carried  its proxy
template <class SceneT>
void GeneralWorld<SceneT>::press(ProxyPair pair, const Contact<Scalar>& contact, int carried,
                                 Answer<Scalar>& result) {
  const auto hit = strike(pair, sides_of_load(pair, carried), contact, Scalar(0));
  if (!hit.ok()) ++bodies_.report.resolutions_invalid;
  const Impulse<Scalar>& press = hit.value;  // nothing where it is not valid
  const bool is_A = carried == pair.first;
  Momentum<Scalar> on_carried = is_A ? press.on_A : press.on_B;
  Momentum<Scalar> on_carrier = is_A ? press.on_B : press.on_A;
  const ProxyPair by = is_A ? pair : ProxyPair{pair.second, pair.first};
  const Vec3<Scalar> towards_W = is_A ? contact.normal_BA_W : Vec3<Scalar>(-contact.normal_BA_W);
  give_way(BodiesT::body_of(by.first), BodiesT::body_of(by.second), towards_W, -press.v_rel,
           on_carried, on_carrier);
  result.impulse += std::abs(on_carried.linear_W.dot(towards_W));
  result.impulse_A_W += is_A ? on_carried.linear_W : Vec3<Scalar>(-on_carried.linear_W);
  note_support(by, on_carried, on_carrier);
}

/// Where loads alone press. What two free bodies give each other stays theirs: were it given back,
/// it would be by one of them.
template <class SceneT>
void GeneralWorld<SceneT>::note_supports(ProxyPair pair, const Momentum<Scalar>& on_A,
                                         const Momentum<Scalar>& on_B) {
  const ProxyPair other = {pair.second, pair.first};
  if (bodies_.holds(BodiesT::body_of(pair.second))) note_support(pair, on_A, on_B);
  if (bodies_.holds(BodiesT::body_of(pair.first))) note_support(other, on_B, on_A);
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
  const Vec3<Scalar> towards_W = is_A ? normal_BA_W : Vec3<Scalar>(-normal_BA_W);
  Momentum<Scalar> on_carried = {(-v_rel / body.inverse_mass) * towards_W, zero<Scalar>()};
  Momentum<Scalar> on_carrier;
  body.momentum_W += on_carried.linear_W;
  give_way(is_A ? a : b, is_A ? b : a, towards_W, -v_rel, on_carried, on_carrier);
  note_support(is_A ? pair : ProxyPair{pair.second, pair.first}, on_carried, on_carrier);
  return on_carried.linear_W.dot(towards_W);
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
    // First what each gave the other: each is then put back as it was.
    if (!is_zero(of_A.linear_W)) give_reactions(a, bodies_.dt - bodies_.now);
    if (!is_zero(of_B.linear_W)) give_reactions(b, bodies_.dt - bodies_.now);
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
  bodies_.states[slot].support = support;
  bodies_.states[slot].loaded = true;
}

}  // namespace batuta::detail
