// SPDX-License-Identifier: MIT
#pragma once
// Where a body goes for the rest of a step, once its controller has answered: the fall, what opens
// gaps, and what to do where nothing is known. Included by bodies.hpp.

#include "batuta/world/detail/bodies.hpp"

namespace batuta::detail {

/// The chord of the parabola, and what the last one lacked (world.md, "The fall").
template <class SceneT>
void set_course(Bodies<SceneT>& bodies, std::size_t slot) {
  using Kinematics = KinematicsOf<SceneT>;
  auto& state = bodies.states[slot];
  if constexpr (SceneT::kGravity) {
    const Scalar_of<SceneT> rest = bodies.dt - bodies.now;
    const auto& body = bodies.actor(slot).body;
    const bool moves = state.plan.by_momentum && body.inverse_mass > 0;
    if (moves && rest > 0) {
      auto& v_W = Kinematics::velocity(state.plan.motion);
      v_W = Kinematics::momentum_velocity(body);
      if (!state.loaded) v_W -= (rest / 2) * bodies.settings.gravity_W;
      v_W += state.off_W / rest;
    }
  }
  if constexpr (kLasts<SceneT>) {
    if (!state.plan.by_momentum) return;
    state.plan.motion.twist.v_W += state.opening.v_W;
    state.plan.motion.twist.w_W += state.opening.w_W;
  }
}

/// By its momentum, without a turn.
template <class SceneT>
[[gnu::cold]] void go_straight(Bodies<SceneT>& bodies, std::size_t slot,
                               Scalar_of<SceneT> duration) {
  using Kinematics = KinematicsOf<SceneT>;
  const auto& body = bodies.actor(slot).body;
  auto& motion = bodies.states[slot].plan.motion;
  motion = Kinematics::standing(body, duration);
  Kinematics::velocity(motion) = Kinematics::momentum_velocity(body);
}

/// Where it turns is not known: it goes on without a turn; where not even that is known, it stands.
template <class SceneT>
[[gnu::cold]] void tell_unknown(Bodies<SceneT>& bodies, std::size_t slot) {
  auto& motion = bodies.states[slot].plan.motion;
  const auto rest = bodies.dt - bodies.now;
  ++bodies.report.plans_invalid;
  if (is_valid(motion)) return;
  motion = KinematicsOf<SceneT>::standing(bodies.actor(slot).body, rest);
  bodies.report.time_held = max_of(bodies.report.time_held, rest);
}

}  // namespace batuta::detail
