// SPDX-License-Identifier: MIT
#pragma once
// Where a body goes for the rest of a step, once its controller has answered: the fall, what opens
// gaps, and what to do where nothing is known. Included by bodies.hpp.

#include "batuta/world/detail/bodies.hpp"

namespace batuta::detail {

/// Its planned motion goes until then.
/// @pre bodies.now < time, in the step, s
template <class SceneT>
inline void end_course([[maybe_unused]] Bodies<SceneT>& bodies, [[maybe_unused]] std::size_t slot,
                       [[maybe_unused]] Scalar_of<SceneT> time) {
  if constexpr (kBends<SceneT>) bodies.states[slot].plan_end = time;
}

/// Where a body's own point is now.
template <class SceneT>
inline Vec3<Scalar_of<SceneT>> place_now(const Bodies<SceneT>& bodies, std::size_t slot) {
  const auto& state = bodies.states[slot];
  if (state.start < bodies.now && state.group == Bodies<SceneT>::kAlone) {
    return state.plan.motion.X_WB.p_W + (bodies.now - state.start) * state.plan.motion.twist.v_W;
  }
  return position_of(bodies.actor(slot));
}

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
      Vec3<Scalar_of<SceneT>> v_W = Kinematics::momentum_velocity(body);
      if (!state.loaded) v_W -= (rest / 2) * bodies.settings.gravity_W;
      v_W += state.off_W / rest;
      Kinematics::set_velocity(state.plan.motion, v_W);
    }
  }
  if constexpr (kLasts<SceneT>) {
    if (!state.plan.by_momentum) return;
    state.plan.motion.twist.v_W += state.opening.v_W;
    state.plan.motion.twist.w_W += state.opening.w_W;
  }
}

/// By its momentum, without a turn. What cannot turn goes so anyway.
template <class SceneT>
[[gnu::cold]] void go_straight(Bodies<SceneT>& bodies, std::size_t slot,
                               Scalar_of<SceneT> duration) {
  if constexpr (SceneT::kRotation) {
    const auto& body = bodies.actor(slot).body;
    auto& motion = bodies.states[slot].plan.motion;
    motion = KinematicsOf<SceneT>::standing(body, duration);
    motion.twist.v_W = twist_of(body).v_W;
  }
}

/// The motion of a body that begins a step, before contacts that last are solved.
template <class SceneT>
void begin_motion(Bodies<SceneT>& bodies, std::size_t slot) {
  using Kinematics = KinematicsOf<SceneT>;
  [[maybe_unused]] auto& actor = bodies.actor(slot);
  [[maybe_unused]] const auto dt = bodies.dt;
  auto& state = bodies.states[slot];
  if (bodies.is_asleep(slot)) {
    state.plan.motion = Kinematics::standing(actor.body, dt);
    return;
  }
  if constexpr (Bodies<SceneT>::kIsFree && kLasts<SceneT>) {
    state.plan.by_momentum = true;
    state.plan.motion = Kinematics::free_motion(actor.body, dt);
  } else if constexpr (kLasts<SceneT> || SceneT::kGravity) {
    Kinematics::ask(actor, Scalar_of<SceneT>(0), dt, state.plan);
  }
  if constexpr (kLasts<SceneT>) {
    if (!is_valid(state.plan.motion)) go_straight(bodies, slot, dt);
  }
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

/// A body is shifted by what is no part of its momentum: its angular momentum about any point
/// changes by that of the shift, and it is remembered who is to give it back (moment_account.hpp).
template <class SceneT>
void note_shift(Bodies<SceneT>& bodies, std::size_t slot, const Vec3<Scalar_of<SceneT>>& shift_W) {
  bodies.states[slot].moment_W += shift_W.cross(bodies.actor(slot).body.momentum.linear_W);
  bodies.is_shifted = true;
}

/// Moves a body on its planned motion. An opening turns it as no momentum does: where that would
/// add energy, what turns it is less (what holds its group takes the rest); where it takes some,
/// the flight that it was on is over.
template <class SceneT>
void move_on(Bodies<SceneT>& bodies, std::size_t slot, Scalar_of<SceneT> elapsed) {
  using Kinematics = KinematicsOf<SceneT>;
  auto& body = bodies.actor(slot).body;
  const auto& state = bodies.states[slot];
  if constexpr (kLasts<SceneT>) {
    if (!state.is_held && !is_zero(state.opening.v_W)) {
      note_shift(bodies, slot, elapsed * state.opening.v_W);
    }
    if (!is_zero(state.opening.w_W)) {
      const auto energy = [&body] { return body.momentum.angular_W.dot(twist_of(body).w_W); };
      const auto before = energy();
      Kinematics::move(body, state.plan.motion, elapsed);
      const auto after = energy();
      using std::sqrt;
      if (after > before) body.momentum.angular_W *= sqrt(before / after);
      body.flight = {};
      return;
    }
  }
  Kinematics::move(body, state.plan.motion, elapsed);
  if constexpr (SceneT::kRotation && !Bodies<SceneT>::kIsFree) {
    if (!state.plan.by_momentum) body.flight = {};  // it was led, and flew nowhere
  }
}

/// Two bodies, which are where they are now, are off their parabolas by the same from now on: what
/// makes up for it does not bring them nearer to each other. Their common centre stays on its own.
template <class SceneT>
void share_off(Bodies<SceneT>& bodies, std::size_t a, std::size_t b) {
  if constexpr (SceneT::kGravity) {
    using Vector = Vec3<Scalar_of<SceneT>>;
    const auto of_a = bodies.actor(b).body.inverse_mass;  // a's share of both masses, and b's
    const auto of_b = bodies.actor(a).body.inverse_mass;
    Vector mean_W = Vector::Zero();
    if (!bodies.is_led(a) && !bodies.is_led(b) && of_a + of_b > 0) {
      mean_W = (of_a * bodies.states[a].off_W + of_b * bodies.states[b].off_W) / (of_a + of_b);
    }
    bodies.states[a].off_W = bodies.states[b].off_W = mean_W;
  }
}

/// What opens the gaps of a body ends now.
template <class SceneT>
void end_opening(Bodies<SceneT>& bodies, std::size_t slot) {
  auto& state = bodies.states[slot];
  if (is_zero(state.opening.v_W) && is_zero(state.opening.w_W)) return;
  bodies.advance_to_now(slot);
  state.opening = {};
  state.changed = bodies.is_changed = true;
}

/// Two are opened no more in this step: they go on together, or openings of others bring them back
/// again and again. So are all that nothing holds and that were opened with them: the common centre
/// of those would move. What something holds keeps its openings: without that a seventh more of the
/// steps of heaps of light and heavy bodies jam. @returns false: neither could be opened anyway
template <class SceneT>
bool end_openings(Bodies<SceneT>& bodies, std::size_t a, std::size_t b) {
  const bool was_opened = bodies.states[a].is_opened || bodies.states[b].is_opened;
  for (std::size_t slot = 0; slot < Bodies<SceneT>::kSlots; ++slot) {  // Bound: kMaxBodies
    const auto& state = bodies.states[slot];
    const bool goes_on = state.is_held && slot != a && slot != b;
    if (state.present && !goes_on) end_opening(bodies, slot);
  }
  for (const std::size_t slot : {a, b}) bodies.states[slot].is_opened = false;  // Bound: 2
  return was_opened;
}

}  // namespace batuta::detail
