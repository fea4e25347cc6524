// SPDX-License-Identifier: MIT
#pragma once
// Bodies that go on together: who is in a group, and when it parts (src/world/world.md,
// "Together"). Included by bodies.hpp. Rare, so compiled for size.

#include "batuta/world/detail/bodies.hpp"

namespace batuta::detail {

/// Of a group of which somebody falls.
template <class Scalar>
struct FallSums {
  Vec3<Scalar> off_W = Vec3<Scalar>::Zero();  ///< mass times FallState::off_W
  bool falls = true;                          ///< nothing in it is carried
};
/// Sums over the bodies of a group.
template <class SceneT>
struct GroupSums : FeatureIf<SceneT::kGravity, FallSums<Scalar_of<SceneT>>, 4> {
  typename KinematicsOf<SceneT>::GroupType group;
  std::size_t heaviest = 0;
  Scalar_of<SceneT> least = std::numeric_limits<Scalar_of<SceneT>>::max();  ///< inverse mass, 1/kg
  int led = 0;             ///< bodies that a controller moves
  std::size_t leader = 0;  ///< one of these
  bool stands = false;     ///< something in it cannot be moved
};

/// A wall is no member: what else comes to it is not to stop there. Who was a member stays one:
/// where its group stood, it looks like a wall once that has parted.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::weld(std::size_t a, std::size_t b, Scalar until) {
  if constexpr (kLasts<SceneT>) end_openings();
  const Slot name = min_of(name_of(a), name_of(b));
  const bool stands_a = take_in(a, name);
  const bool stands_b = take_in(b, name);
  GroupSums<SceneT> sums = sums_of(name);
  sums.stands = sums.stands || stands_a || stands_b || sums.led > 1;
  start_group(sums, name, until);
  report.time_held = max_of(report.time_held, until - now);
}

/// Bodies that go on together are opened no more, so all that were opened with them are not: the
/// common centre of those would move.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::end_openings() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    State& state = states[slot];
    if (!state.present || (is_zero(state.opening.v_W) && is_zero(state.opening.w_W))) continue;
    bring(slot);
    state.opening = {};
    state.changed = is_changed = true;
  }
}

/// A body, and who goes with it already, go by another name. @returns whether something in it
/// cannot be moved
template <class SceneT>
[[gnu::cold]] bool Bodies<SceneT>::take_in(std::size_t slot, Slot name) {
  const State& state = states[slot];
  const Slot group = state.group;
  if (group == kAlone) {
    if (is_wall(slot)) return true;
    bring(slot);
    states[slot].group = name;
    return false;
  }
  const bool stands = state.is_led_group && Kinematics::is_still(state.plan.motion);
  if constexpr (SceneT::kMaxBodies > 2) {
    settle(group);
    for (State& other : states) {  // Bound: kMaxBodies
      if (other.group == group) other.group = name;
    }
  }
  return stands;
}

template <class SceneT>
[[gnu::cold]] GroupSums<SceneT> Bodies<SceneT>::sums_of(Slot name) const {
  GroupSums<SceneT> sums;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (states[slot].group != name) continue;
    const auto& body = actor(slot).body;
    const bool is_led = !kIsFree && this->is_led(slot);
    if (is_led) {
      ++sums.led;
      sums.leader = slot;
    }
    if (!(body.inverse_mass > Scalar(0))) {
      sums.stands = sums.stands || !is_led;
      continue;
    }
    if constexpr (SceneT::kGravity) {
      sums.off_W += states[slot].off_W / body.inverse_mass;
      sums.falls = sums.falls && falls(slot);
    }
    add_to_group(sums.group, body);
    if (body.inverse_mass < sums.least) {
      sums.least = body.inverse_mass;
      sums.heaviest = slot;
    }
  }
  return sums;
}

/// Where a group goes that nothing stops.
template <class SceneT>
[[gnu::cold]] typename KinematicsOf<SceneT>::MotionType Bodies<SceneT>::course_of(
    const GroupSums<SceneT>& sums, Scalar duration) const {
  if constexpr (!kIsFree) {
    if (sums.led > 0) {
      return Kinematics::turned_about(actor(sums.leader).body, states[sums.leader].plan.motion,
                                      duration);
    }
  }
  auto motion = group_motion(sums.group, duration);
  if constexpr (SceneT::kGravity) {
    Vec3<Scalar>& v_W = Kinematics::velocity(motion);
    const Scalar left = dt - now;
    if (sums.falls) v_W -= (left / 2) * settings.gravity_W;
    if (left > Scalar(0)) v_W += sums.off_W / (sums.group.mass * left);
  }
  if constexpr (kLasts<SceneT>) {  // or the common centre of these and of who makes room for them
                                   // moves
    Kinematics::velocity(motion) += sums.opening_W / sums.group.mass;
  }
  return motion;
}

/// Gives all of a group one motion.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::start_group(const GroupSums<SceneT>& sums, Slot name,
                                               Scalar until) {
  const Scalar rest = until - now;
  auto motion = Kinematics::standing_at(place_of(name), rest);
  bool stands = sums.stands;
  if (!stands) {
    const auto course = course_of(sums, rest);
    stands = !is_valid(course);
    if (!stands) motion = course;
  }
  const bool is_led = stands || sums.led > 0;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    State& state = states[slot];
    if (state.group != name) continue;
    state.is_led_group = is_led;
    state.held_until = until;
    end_course(slot, dt);
    state.start = now;
    state.plan.motion = Kinematics::seat(motion, actor(slot).body);
    if constexpr (SceneT::kGravity) {
      state.off_W.setZero();
      if (!is_led) state.off_W = sums.off_W / sums.group.mass;
      state.loaded = !sums.falls || is_led;
    }
    state.changed = true;
  }
  is_changed = true;
}

template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::part_group(std::size_t slot) {
  const Slot group = states[slot].group;
  settle(group);
  for (State& state : states) {  // Bound: kMaxBodies
    if (state.group == group) state.group = kAlone;
  }
}

/// All of a group are where it has come to, each with the velocity of its place.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::settle(Slot group) {
  std::size_t first = 0;
  while (states[first].group != group) ++first;  // Bound: kMaxBodies: who asks is in it
  const State& whole = states[first];
  if constexpr (SceneT::kRotation) {
    settle_turning(whole);
  } else {
    settle_straight(whole);
  }
  for (std::size_t slot = first; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    State& state = states[slot];
    if (state.group != group) continue;
    if constexpr (SceneT::kGravity) end_fall(slot);
    state.held_until = 0;
    state.start = now;
    state.changed = true;
    Kinematics::restart(state.plan.motion, actor(slot).body, dt - now);
  }
  is_changed = true;
}

/// What rounding leaves of the sums goes to the heaviest.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::settle_turning(const State& whole) {
  const GroupSums<SceneT> sums = sums_of(whole.group);
  const Pose<Scalar> X_WG = pose_at(whole.plan.motion, now - whole.start);
  Momentum<Scalar> left = sums.group.momentum;
  Twist<Scalar> twist = whole.plan.motion.twist;
  const bool moves = whole.start < now && !Kinematics::is_still(whole.plan.motion);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!moves || states[slot].group != whole.group) continue;
    take_along(actor(slot).body, whole.plan.motion.X_WB.p_W, X_WG);
  }
  if (!whole.is_led_group) twist = group_twist(sums_of(whole.group).group, left.angular_W);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (is_pushed_in(whole.group, slot)) give_momentum(actor(slot).body, X_WG.p_W, twist, left);
  }
  if (whole.is_led_group) return;
  Momentum<Scalar>& heaviest = actor(sums.heaviest).body.momentum;
  heaviest.linear_W += left.linear_W;
  if (sums.group.turns) heaviest.angular_W += left.angular_W;
}

template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::settle_straight(const State& whole) {
  const GroupSums<SceneT> sums = sums_of(whole.group);
  Vec3<Scalar> left_W = sums.group.momentum_W;
  Vec3<Scalar> v_W = whole.plan.motion.v_W;
  if (!whole.is_led_group) v_W = left_W / sums.group.mass;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (states[slot].group != whole.group) continue;
    auto& body = actor(slot).body;
    Kinematics::move(body, states[slot].plan.motion, now - whole.start);
    if (!is_pushed_in(whole.group, slot)) continue;
    body.momentum_W = v_W / body.inverse_mass;
    left_W -= body.momentum_W;
  }
  if (!whole.is_led_group) actor(sums.heaviest).body.momentum_W += left_W;
}

/// Whether a body is of a group, and its momentum is the group's.
template <class SceneT>
bool Bodies<SceneT>::is_pushed_in(Slot group, std::size_t slot) const {
  const State& state = states[slot];
  if (state.group != group || !(actor(slot).body.inverse_mass > Scalar(0))) return false;
  return kIsFree || !state.is_led_group || state.plan.by_momentum;
}

/// Of a body whose group is at its end: how far it is off its parabola; and what a group that was
/// led carried begins to fall.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::end_fall(std::size_t slot) {
  State& state = states[slot];
  auto& body = actor(slot).body;
  const Scalar span = dt - state.start;
  const Scalar elapsed = now - state.start;
  const Scalar left = span > Scalar(0) ? 1 - elapsed / span : Scalar(0);
  state.off_W *= left;
  if (!state.loaded) state.off_W -= (elapsed * (span - elapsed) / 2) * settings.gravity_W;
  if (state.is_led_group && is_pushed_in(state.group, slot)) {
    Kinematics::linear_momentum(body) += ((dt - now) / body.inverse_mass) * settings.gravity_W;
  }
  state.loaded = state.loaded && !state.is_led_group;
}

}  // namespace batuta::detail
