// SPDX-License-Identifier: MIT
#pragma once
// Bodies that go on together, as one rigid body with their summed momenta (src/world/world.md,
// "Together"). Included by bodies.hpp.

#include "batuta/geometry/direction.hpp"
#include "batuta/world/detail/bodies.hpp"
#include "batuta/world/detail/group_motion.hpp"

namespace batuta::detail {

/// Sums over the bodies of a group.
template <class Scalar>
struct GroupSums {
  Scalar mass = 0;
  Vec3<Scalar> momentum_W = Vec3<Scalar>::Zero();  ///< of the step's end where they fall
  Vec3<Scalar> moment_W = Vec3<Scalar>::Zero();    ///< mass times place from the first one
  Vec3<Scalar> off_W = Vec3<Scalar>::Zero();       ///< mass times FallState::off_W
  Vec3<Scalar> spin_W = Vec3<Scalar>::Zero();      ///< angular momentum about the centre
  Mat3<Scalar> inertia_W = Mat3<Scalar>::Zero();   ///< about the centre
  int led = 0;                                     ///< bodies that a controller moves
  std::size_t leader = 0;                          ///< one of these
  bool stands = false;                             ///< something in it cannot be moved
  bool falls = true;                               ///< nothing in it is carried
};

/// A wall is no member: what else comes to it is not to stop there. Who was a member stays one:
/// where its group stood, it looks like a wall once that has parted.
template <class SceneT>
void Bodies<SceneT>::weld(std::size_t a, std::size_t b, Scalar until) {
  if constexpr (kLasts<SceneT>) end_openings();
  GroupSums<Scalar> sums;
  sums.stands = stands_together(a) || stands_together(b);
  const auto is_lone_wall = [this](std::size_t slot) {
    return states[slot].group == kAlone && !states[slot].changed && is_wall(slot);
  };
  const bool is_wall_a = is_lone_wall(a);
  const bool is_wall_b = is_lone_wall(b);
  join(a);
  join(b);
  std::size_t first = kSlots;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    states[slot].joins = states[slot].comes;
    states[slot].comes = false;
    if (!states[slot].joins) continue;
    if ((slot == a && is_wall_a) || (slot == b && is_wall_b)) {
      sums.stands = true;
      states[slot].joins = false;
      continue;
    }
    if (first == kSlots) first = slot;
    bring(slot);
    add_to(sums, slot, place_of(first));
  }
  if (first == kSlots) return;
  sums.stands = sums.stands || sums.led > 1;
  start_group(sums, first, until);
  report.time_held = max_of(report.time_held, until - now);
}

/// Bodies that go on together are opened no more, so all that were opened with them are not: the
/// common centre of those would move.
template <class SceneT>
void Bodies<SceneT>::end_openings() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    State& state = states[slot];
    if (!state.present || (is_zero(state.opening.v_W) && is_zero(state.opening.w_W))) continue;
    bring(slot);
    state.opening = {};
    state.changed = is_changed = true;
  }
}

/// A group that a wall is part of.
template <class SceneT>
bool Bodies<SceneT>::stands_together(std::size_t slot) const {
  const State& state = states[slot];
  return state.group != kAlone && state.is_led_group && Kinematics::is_still(state.plan.motion);
}

/// The group of a body parts; those that were in it are named after the body instead.
template <class SceneT>
void Bodies<SceneT>::join(std::size_t slot) {
  const Slot group = states[slot].group;
  for (State& state : states) {  // Bound: kMaxBodies
    state.comes = state.comes || (group != kAlone && state.group == group);
  }
  states[slot].comes = true;
  if (group != kAlone) part_group(slot);
}

template <class SceneT>
void Bodies<SceneT>::add_to(GroupSums<Scalar>& sums, std::size_t slot, const Vec3<Scalar>& from_W) {
  const State& state = states[slot];
  auto& body = actor(slot).body;
  if (is_led(slot)) {
    ++sums.led;
    sums.leader = slot;
  }
  if (!(body.inverse_mass > Scalar(0))) return;
  const Scalar mass = 1 / body.inverse_mass;
  sums.mass += mass;
  sums.momentum_W += Kinematics::linear_momentum(body);
  sums.moment_W += mass * (place_of(slot) - from_W);
  if constexpr (SceneT::kGravity) {
    sums.off_W += mass * state.off_W;
    sums.falls = sums.falls && falls(slot);
  }
}

/// Angular momentum and inertia about a centre of all that are marked, from the poses stored.
template <class SceneT>
void Bodies<SceneT>::add_turning(GroupSums<Scalar>& sums, const Vec3<Scalar>& center_W,
                                 const Vec3<Scalar>& v_W) const {
  sums.spin_W.setZero();
  sums.inertia_W.setZero();
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!states[slot].joins || !(actor(slot).body.inverse_mass > Scalar(0))) continue;
    const Body<Scalar>& body = actor(slot).body;
    const Vec3<Scalar> r_W = body.X_WB.p_W - center_W;
    const Vec3<Scalar> own_W = body.momentum.linear_W - v_W / body.inverse_mass;
    sums.spin_W += body.momentum.angular_W + r_W.cross(own_W);
    add_inertia(sums.inertia_W, body, r_W);
  }
}

/// Gives all that join one motion. @param first  the lowest of them
template <class SceneT>
void Bodies<SceneT>::start_group(GroupSums<Scalar>& sums, std::size_t first, Scalar until) {
  const Scalar rest = until - now;
  const Vec3<Scalar> from_W = place_of(first);
  typename Kinematics::MotionType motion;
  const bool is_led = sums.stands || sums.led > 0;
  if (sums.stands) {
    motion = Kinematics::standing_at(from_W, rest);
  } else if (is_led) {
    motion = Kinematics::turned_about(states[sums.leader].plan.motion, rest);
  } else {
    Vec3<Scalar> v_W = sums.momentum_W / sums.mass;
    const Vec3<Scalar> center_W = from_W + sums.moment_W / sums.mass;
    if constexpr (SceneT::kRotation) add_turning(sums, center_W, v_W);
    if constexpr (SceneT::kGravity) {
      const Scalar left = dt - now;
      if (sums.falls) v_W -= (left / 2) * settings.gravity_W;
      if (left > Scalar(0)) v_W += sums.off_W / (sums.mass * left);
    }
    motion = Kinematics::group_motion(center_W, sums, v_W, rest);
  }
  for (std::size_t slot = first; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    State& state = states[slot];
    if (!state.joins) continue;
    state.joins = false;
    state.group = static_cast<Slot>(first);
    state.is_led_group = is_led;
    state.held_until = until;
    end_course(slot, dt);
    state.start = now;
    state.plan.motion = Kinematics::seat(motion, actor(slot).body);
    if constexpr (SceneT::kGravity) {
      state.off_W = sums.mass > Scalar(0) && !is_led ? Vec3<Scalar>(sums.off_W / sums.mass)
                                                     : Vec3<Scalar>(Vec3<Scalar>::Zero());
      state.loaded = !sums.falls || is_led;
    }
    state.changed = true;
  }
  is_changed = true;
}

template <class SceneT>
void Bodies<SceneT>::part_group(std::size_t slot) {
  const Slot group = states[slot].group;
  const State whole = states[slot];
  const Scalar elapsed = now - whole.start;
  GroupSums<Scalar> sums;
  std::size_t heaviest = slot;
  for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: kMaxBodies
    states[i].joins = states[i].group == group;
    if (!states[i].joins) continue;
    add_to(sums, i, place_of(slot));
    if (actor(i).body.inverse_mass > Scalar(0) &&
        (!(actor(heaviest).body.inverse_mass > Scalar(0)) ||
         actor(i).body.inverse_mass < actor(heaviest).body.inverse_mass)) {
      heaviest = i;
    }
  }
  if constexpr (SceneT::kRotation) {
    part_turning(sums, whole, elapsed, heaviest);
  } else {
    part_straight(sums, whole, elapsed, heaviest);
  }
  for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: kMaxBodies
    State& state = states[i];
    if (!state.joins) continue;
    state.joins = false;
    state.group = kAlone;
    state.held_until = 0;
    state.start = now;
    state.changed = true;
    state.plan.motion = Kinematics::from_here(actor(i).body, state.plan.motion, dt - now);
    if constexpr (SceneT::kGravity) {
      const Scalar span = dt - whole.start;
      const Scalar left = span > Scalar(0) ? 1 - elapsed / span : Scalar(0);
      state.off_W *= left;
      if (!whole.loaded) state.off_W -= (elapsed * (span - elapsed) / 2) * settings.gravity_W;
      state.loaded = whole.loaded && !whole.is_led_group;
    }
  }
  is_changed = true;
}

/// Each has the velocity of its place; what rounding leaves of the sums goes to the heaviest.
template <class SceneT>
void Bodies<SceneT>::part_turning(GroupSums<Scalar>& sums, const State& whole, Scalar elapsed,
                                  std::size_t heaviest) {
  const Vec3<Scalar> center_W = whole.plan.motion.X_WB.p_W;
  const Pose<Scalar> X_WG = pose_at(whole.plan.motion, elapsed);
  const bool is_led = whole.is_led_group;
  Twist<Scalar> twist = whole.plan.motion.twist;
  if (!is_led) twist.v_W = sums.momentum_W / sums.mass;
  add_turning(sums, center_W, twist.v_W);
  Momentum<Scalar> left = {sums.momentum_W, sums.spin_W};
  for (std::size_t i = 0; elapsed > Scalar(0) && i < kSlots; ++i) {  // Bound: kMaxBodies
    if (!states[i].joins) continue;
    Pose<Scalar>& X_WB = actor(i).body.X_WB;
    X_WB.p_W = X_WG.p_W + X_WG.q_WB * (X_WB.p_W - center_W).eval();
    X_WB.q_WB = renewed<Scalar>(X_WG.q_WB * X_WB.q_WB);
  }
  if (!is_led) {
    add_turning(sums, X_WG.p_W, twist.v_W);
    twist.w_W = spin_for(sums.inertia_W, left.angular_W);
  }
  for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: kMaxBodies
    if (states[i].joins && !(is_led && !states[i].plan.by_momentum)) {
      give_place(i, X_WG.p_W, twist, left);
    }
  }
  if (is_led || !(sums.mass > Scalar(0))) return;
  actor(heaviest).body.momentum.linear_W += left.linear_W;
  actor(heaviest).body.momentum.angular_W += left.angular_W;
}

/// The momenta of a body that turns with others about a centre, taken from what is left of theirs.
template <class SceneT>
void Bodies<SceneT>::give_place(std::size_t slot, const Vec3<Scalar>& center_W,
                                const Twist<Scalar>& twist, Momentum<Scalar>& left) {
  auto& body = actor(slot).body;
  if (!(body.inverse_mass > Scalar(0))) return;
  const Vec3<Scalar> r_W = body.X_WB.p_W - center_W;
  const Vec3<Scalar> turning_W = twist.w_W.cross(r_W);
  body.momentum = momentum_of(body, Twist<Scalar>{twist.v_W + turning_W, twist.w_W});
  left.linear_W -= body.momentum.linear_W;
  left.angular_W -= body.momentum.angular_W + r_W.cross(turning_W) / body.inverse_mass;
  if constexpr (SceneT::kGravity) {
    if (states[slot].is_led_group) {
      body.momentum.linear_W += ((dt - now) / body.inverse_mass) * settings.gravity_W;
    }
  }
}

template <class SceneT>
void Bodies<SceneT>::part_straight(GroupSums<Scalar>& sums, const State& whole, Scalar elapsed,
                                   std::size_t heaviest) {
  const bool is_led = whole.is_led_group;
  const Vec3<Scalar> v_W =
      is_led ? Vec3<Scalar>(Vec3<Scalar>::Zero()) : Vec3<Scalar>(sums.momentum_W / sums.mass);
  Vec3<Scalar> left_W = sums.momentum_W;
  for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: kMaxBodies
    if (!states[i].joins) continue;
    auto& body = actor(i).body;
    Kinematics::move(body, states[i].plan.motion, elapsed);
    if (!(body.inverse_mass > Scalar(0))) continue;
    body.momentum_W = v_W / body.inverse_mass;
    left_W -= body.momentum_W;
    if constexpr (SceneT::kGravity) {
      if (is_led) body.momentum_W += ((dt - now) / body.inverse_mass) * settings.gravity_W;
    }
  }
  if (!is_led && sums.mass > Scalar(0)) actor(heaviest).body.momentum_W += left_W;
}

}  // namespace batuta::detail
