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

/// Twice the energy of a body's turn where its planned motion has it after t, J.
template <class Scalar>
Scalar turning_on(const Body<Scalar>& body, const Motion<Scalar>& motion, Scalar t) {
  Body<Scalar> there = body;
  there.X_WB = pose_at(motion, t);
  return body.momentum.angular_W.dot(twist_of(there).w_W);
}

/// Whether a body that is on a course since now would be met, at a time of the step, where the
/// energy of its turn is not that of the course's end, which is its flight's
/// (src/mechanics/motion.md, "The energy on the chord").
template <class SceneT>
[[gnu::noinline]] bool is_off_flight(const Bodies<SceneT>& bodies, std::size_t slot,
                                     Scalar_of<SceneT> time) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kOfEnergy = Scalar(1) / 1024;
  constexpr Scalar kLeastTurn = Scalar(1) / 256;  // rad: who turns less is not looked at
  const auto& state = bodies.states[slot];
  // Who came to now on the chord would be off its flight where the new course began.
  const bool is_on_course = bodies.now <= state.start && state.group == Bodies<SceneT>::kAlone;
  if (!is_on_course || bodies.is_led(slot)) return false;
  if constexpr (kLasts<SceneT>) {
    if (!is_zero(state.opening.w_W)) return false;
  }
  const auto& motion = state.plan.motion;
  if (!(motion.duration * length(motion.twist.w_W) > kLeastTurn)) return false;
  const auto& body = bodies.actor(slot).body;
  const Scalar whole = turning_on(body, motion, motion.duration);
  return std::abs(turning_on(body, motion, time - state.start) - whole) > kOfEnergy * whole;
}

}  // namespace batuta::detail
