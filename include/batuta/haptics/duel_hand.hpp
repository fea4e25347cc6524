// SPDX-License-Identifier: MIT
#pragma once
// What a duel's last step was to one of its hands, for HandForce. Apart from
// haptics/hand_force.hpp, which knows the hand and no duel. Frame W; SI units.

#include "batuta/fencing/duel.hpp"
#include "batuta/haptics/hand_force.hpp"

namespace batuta::haptics {

/// The impulse that `side`'s blade took in a step, and its moment about the point `p_W`: the sum
/// over the contact events. The normal of a contact points out of body B (the right blade) towards
/// body A (the left one). Of friction, which events do not tell, nothing. Bound: the events.
template <class Scalar, class Events>
Momentum<Scalar> blow_about(const Vec3<Scalar>& p_W, fencing::Side side, const Events& events) {
  Momentum<Scalar> blow;
  const Scalar sign = side == fencing::Side::kLeft ? Scalar(1) : Scalar(-1);
  for (const auto& event : events) {  // Bound: the capacity of the list
    const Vec3<Scalar> impulse_W = (sign * event.impulse) * event.contact.normal_BA_W;
    blow.linear_W += impulse_W;
    blow.angular_W += (event.contact.point_W - p_W).cross(impulse_W);
  }
  return blow;
}

/// What a duel's last step was to one of the hands. @pre configured; the scene keeps events
template <class DuelT>
auto hand_state(const DuelT& duel, fencing::Side side) {
  using Scalar = typename DuelT::WorldType::Scalar;
  HandState<Scalar> state;
  state.commanded = duel.hand(side);
  state.held_W = duel.held_hand_W(side);
  if constexpr (DuelT::SceneType::kGrip) state.hold = duel.grip(side).control();
  state.blow = blow_about(state.commanded.X_WH.p_W, side, duel.world().events());
  return state;
}

}  // namespace batuta::haptics
