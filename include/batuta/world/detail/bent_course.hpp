// SPDX-License-Identifier: MIT
#pragma once
// Before and after a contact: how long the chord of a bent turn may stand for it
// (src/world/world.md, "Bent turns"). Frame W, SI units.

#include "batuta/geometry/direction.hpp"
#include "batuta/response/impulse.hpp"
#include "batuta/world/detail/bodies.hpp"

namespace batuta::detail {

/// Of a body after a contact: its twist now, with the turn of the chord over `duration`.
template <class SceneT>
Twist<Scalar_of<SceneT>> chord_after(const Bodies<SceneT>& bodies, std::size_t slot,
                                     Scalar_of<SceneT> duration) {
  Twist<Scalar_of<SceneT>> twist = bodies.twist_now(slot);
  if (bodies.is_led(slot)) return twist;
  typename Bodies<SceneT>::Kinematics::PlanType plan;
  Bodies<SceneT>::Kinematics::ask(bodies.actor(slot), bodies.now, duration, plan);
  if (plan.by_momentum && is_valid(plan.motion)) twist.w_W = plan.motion.twist.w_W;
  return twist;
}

/// Where two part by their momenta, and approach along the chords of their turns by more than
/// `least` in the rest of the step, the chords are cut short: to the half, the quarter and so on,
/// until they part, or come no nearer than that. Bound: kHalvings.
template <class SceneT>
void shorten_courses(Bodies<SceneT>& bodies, ProxyPair pair,
                     const Contact<Scalar_of<SceneT>>& contact, Scalar_of<SceneT> least) {
  using Scalar = Scalar_of<SceneT>;
  constexpr int kHalvings = 12;
  const std::size_t a = Bodies<SceneT>::body_of(pair.first);
  const std::size_t b = Bodies<SceneT>::body_of(pair.second);
  if (!flies_bent(bodies.actor(a).body) && !flies_bent(bodies.actor(b).body)) return;
  const auto apart = [&](Scalar duration) {
    return relative_velocity(contact, bodies.actor(a).body.X_WB, chord_after(bodies, a, duration),
                             bodies.actor(b).body.X_WB, chord_after(bodies, b, duration));
  };
  const bool alone = bodies.states[a].group == Bodies<SceneT>::kAlone &&
                     bodies.states[b].group == Bodies<SceneT>::kAlone;
  const Scalar rest = bodies.dt - bodies.now;
  Scalar share = 1;
  for (int k = 0; k < kHalvings && alone; ++k) {  // Bound: kHalvings
    if (!(apart(share * rest) * (share * rest) < -least)) break;
    share /= 2;
  }
  const Scalar end = bodies.now + share * rest;
  if (!(share < Scalar(1)) || !(bodies.now < end)) return;
  for (const std::size_t slot : {a, b}) {  // Bound: 2
    if (!bodies.is_led(slot)) end_course(bodies, slot, end);
  }
}

/// By how much the energy of a body's turn is off that of its flight where it would be met at a
/// time of the step; of the latter. 0 where its momentum does not turn it alone.
template <class SceneT>
[[gnu::noinline]] Scalar_of<SceneT> alone_off_flight(const Bodies<SceneT>& bodies, std::size_t slot,
                                                     Scalar_of<SceneT> time) {
  using Scalar = Scalar_of<SceneT>;
  const auto& state = bodies.states[slot];
  if (bodies.is_led(slot)) return Scalar(0);
  if constexpr (kLasts<SceneT>) {
    if (!is_zero(state.opening.w_W)) return Scalar(0);
  }
  if (!(state.start < time)) return Scalar(0);
  return off_flight_energy(bodies.actor(slot).body, state.plan.motion, time - state.start);
}

/// The same, or of the group that parts where it is met.
template <class SceneT>
Scalar_of<SceneT> off_flight(Bodies<SceneT>& bodies, std::size_t slot, Scalar_of<SceneT> time) {
  if (bodies.states[slot].group == Bodies<SceneT>::kAlone) {
    if constexpr (kBends<SceneT>) return alone_off_flight(bodies, slot, time);
  } else {
    if constexpr (kPartsGroups<SceneT>) return bodies.group_off_flight(slot, time);
  }
  return 0;
}

/// Whether one of two bodies would be met where its energy is more than that of its flight: it
/// would keep that by a blow (src/world/world.md, "Bent turns").
template <class SceneT>
bool wins_by_chord([[maybe_unused]] Bodies<SceneT>& bodies, [[maybe_unused]] std::size_t a,
                   [[maybe_unused]] std::size_t b, [[maybe_unused]] Scalar_of<SceneT> time) {
  using Scalar = Scalar_of<SceneT>;
  if constexpr (kCuts<SceneT>) {
    return off_flight(bodies, a, time) > kOffFlight<Scalar> ||
           off_flight(bodies, b, time) > kOffFlight<Scalar>;
  }
  return false;
}

}  // namespace batuta::detail
