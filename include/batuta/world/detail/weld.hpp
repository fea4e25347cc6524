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

/// Makes groups of the bodies of a step, and ends them.
template <class SceneT>
class Welds {
 public:
  using BodiesT = Bodies<SceneT>;
  using Scalar = Scalar_of<SceneT>;
  using Group = typename BodiesT::Group;

  explicit Welds(BodiesT& bodies) : bodies_(bodies) {}
  /// Bodies::weld().
  void weld(std::size_t a, std::size_t b, Scalar until);
  /// Bodies::hold().
  void hold(std::size_t a, std::size_t b, Scalar until);
  /// Bodies::part_group().
  void part_group(std::size_t slot);
  /// Bodies::shorten_group().
  void shorten(std::size_t slot, Scalar until);
  /// Bodies::group_off_flight().
  Scalar off_flight(std::size_t slot, Scalar time) const;

 private:
  using Kinematics = KinematicsOf<SceneT>;
  using BodyState = typename BodiesT::BodyState;

  Group name_of(std::size_t slot) const {
    const Group group = bodies_.states[slot].group;
    return group == BodiesT::kAlone ? static_cast<Group>(slot) : group;
  }
  /// A wall that is alone.
  bool is_no_member(std::size_t slot) const {
    return bodies_.states[slot].group == BodiesT::kAlone && bodies_.is_wall(slot);
  }
  bool stop(std::size_t slot);
  void take_in(std::size_t slot, Group name);
  GroupSums<SceneT> sums_of(Group name) const;
  typename Kinematics::MotionType plan_of(const GroupSums<SceneT>& sums, Scalar duration) const;
  void start_group(const GroupSums<SceneT>& sums, Group name, Scalar until);
  void settle(Group group);
  void settle_turning(const BodyState& whole);
  void go_along(const BodyState& whole, const Pose<Scalar>& X_WG);
  void settle_straight(const BodyState& whole);
  static void start_fall(BodyState& state, const GroupSums<SceneT>& sums, bool is_led);
  bool is_moved_in(Group group, std::size_t slot) const;
  bool is_pushed_in(Group group, std::size_t slot) const;
  void end_fall(std::size_t slot);
  void fall_by(std::size_t slot, Scalar time);
  void note_held(Scalar time) { bodies_.report.time_held = max_of(bodies_.report.time_held, time); }

  BodiesT& bodies_;
};

template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::weld(std::size_t a, std::size_t b, Scalar until) {
  Welds<SceneT>(*this).weld(a, b, until);
}

template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::hold(std::size_t a, std::size_t b, Scalar until) {
  Welds<SceneT>(*this).hold(a, b, until);
}

template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::part_group(std::size_t slot) {
  Welds<SceneT>(*this).part_group(slot);
}

template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::shorten_group(std::size_t slot, Scalar until) {
  Welds<SceneT>(*this).shorten(slot, until);
}

template <class SceneT>
[[gnu::cold]] Scalar_of<SceneT> Bodies<SceneT>::group_off_flight(std::size_t slot, Scalar time) {
  return Welds<SceneT>(*this).off_flight(slot, time);
}

/// A wall is no member, nor gives a name: what else comes to it is not to stop there.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::weld(std::size_t a, std::size_t b, Scalar until) {
  if (name_of(a) == name_of(b)) return;  // they go together already
  if constexpr (kLasts<SceneT>) end_openings(bodies_, a, b);
  const Group name = is_no_member(a)   ? name_of(b)
                     : is_no_member(b) ? name_of(a)
                                       : min_of(name_of(a), name_of(b));
  // Both groups are settled before anybody goes by another name.
  const bool stands_a = stop(a);
  const bool stands_b = stop(b);
  take_in(a, name);
  take_in(b, name);
  GroupSums<SceneT> sums = sums_of(name);
  sums.stands = sums.stands || stands_a || stands_b || sums.led > 1;
  start_group(sums, name, until);
  // Under kHolds a group may part earlier.
  if constexpr (!kHolds<SceneT>) note_held(until - bodies_.now);
}

/// How far it is off its parabola is kept. @pre both have come to now
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::hold(std::size_t a, std::size_t b, Scalar until) {
  const std::array<std::size_t, 2> slots = {a, b};
  std::array<Vec3<Scalar>, 2> off_W;
  if constexpr (SceneT::kGravity) off_W = {bodies_.states[a].off_W, bodies_.states[b].off_W};
  weld(a, b, until);
  for (std::size_t i = 0; i < slots.size(); ++i) {  // Bound: 2
    BodyState& state = bodies_.states[slots[i]];
    if (state.group == BodiesT::kAlone) continue;
    state.group_plan = GroupPlan::kHeld;
    if constexpr (SceneT::kGravity) state.off_W = off_W[i];
  }
}

/// A body, and who goes with it, come to now. @returns whether something in it cannot be moved
template <class SceneT>
[[gnu::cold]] bool Welds<SceneT>::stop(std::size_t slot) {
  const BodyState& state = bodies_.states[slot];
  if (state.group == BodiesT::kAlone) {
    if (bodies_.is_wall(slot)) return true;
    bodies_.advance_to_now(slot);
    return false;
  }
  const bool stands = state.is_led_group() && Kinematics::is_still(state.plan.motion);
  if constexpr (SceneT::kMaxBodies > 2) settle(state.group);
  return stands;
}

/// They go by another name.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::take_in(std::size_t slot, Group name) {
  const Group group = bodies_.states[slot].group;
  if (group == BodiesT::kAlone) {
    if (!is_no_member(slot)) bodies_.states[slot].group = name;
  } else if constexpr (SceneT::kMaxBodies > 2) {
    for (BodyState& other : bodies_.states) {  // Bound: kMaxBodies
      if (other.group == group) other.group = name;
    }
  }
}

template <class SceneT>
[[gnu::cold]] GroupSums<SceneT> Welds<SceneT>::sums_of(Group name) const {
  GroupSums<SceneT> sums;
  for (std::size_t slot = 0; slot < BodiesT::kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies_.states[slot].group != name) continue;
    const auto& body = bodies_.actor(slot).body;
    const bool is_led = !BodiesT::kIsFree && bodies_.is_led(slot);
    if (is_led) {
      ++sums.led;
      sums.leader = slot;
    }
    if (!(body.inverse_mass > Scalar(0))) {
      sums.stands = sums.stands || !is_led;
      continue;
    }
    if constexpr (SceneT::kGravity) {
      sums.off_W += bodies_.states[slot].off_W / body.inverse_mass;
      sums.falls = sums.falls && bodies_.falls(slot);
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
[[gnu::cold]] typename KinematicsOf<SceneT>::MotionType Welds<SceneT>::plan_of(
    const GroupSums<SceneT>& sums, Scalar duration) const {
  if constexpr (!BodiesT::kIsFree) {
    if (sums.led > 0) {
      return Kinematics::turned_about(bodies_.actor(sums.leader).body,
                                      bodies_.states[sums.leader].plan.motion, duration);
    }
  }
  auto motion = group_motion(sums.group, duration);
  if constexpr (SceneT::kGravity) {
    Vec3<Scalar> v_W = Kinematics::velocity(motion);
    const Scalar left = bodies_.dt - bodies_.now;
    if (sums.falls) v_W -= (left / 2) * bodies_.settings.gravity_W;
    if (left > Scalar(0)) v_W += sums.off_W / (sums.group.mass * left);
    Kinematics::set_velocity(motion, v_W);
  }
  return motion;
}

/// A body of a group falls as all of it do.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::start_fall(BodyState& state, const GroupSums<SceneT>& sums,
                                             bool is_led) {
  state.off_W.setZero();
  if (!is_led) state.off_W = sums.off_W / sums.group.mass;
  state.loaded = !sums.falls || is_led;
  // Of the group, and no longer its own.
  if constexpr (kCarries<SceneT>) static_cast<CarriedState<Scalar>&>(state) = {};
}

/// Gives all of a group one motion.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::start_group(const GroupSums<SceneT>& sums, Group name,
                                              Scalar until) {
  const Scalar rest = until - bodies_.now;
  auto motion = Kinematics::standing_at(position_of(bodies_.actor(name)), rest);
  bool stands = sums.stands;
  if (!stands) {
    const auto planned = plan_of(sums, rest);
    stands = !is_valid(planned);
    if (!stands) motion = planned;
  }
  const bool is_led = stands || sums.led > 0;
  for (std::size_t slot = 0; slot < BodiesT::kSlots; ++slot) {  // Bound: kMaxBodies
    BodyState& state = bodies_.states[slot];
    if (state.group != name) continue;
    state.group_plan = is_led ? GroupPlan::kLed : GroupPlan::kOwn;
    state.held_until = until;
    if constexpr (kLasts<SceneT>) state.was_jammed = true;
    end_course(bodies_, slot, bodies_.dt);
    state.start = bodies_.now;
    state.plan.motion = Kinematics::seat(motion, bodies_.actor(slot).body);
    if constexpr (SceneT::kGravity) start_fall(state, sums, is_led);
    state.changed = true;
  }
  bodies_.is_changed = true;
}

template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::part_group(std::size_t slot) {
  const Group group = bodies_.states[slot].group;
  settle(group);
  for (BodyState& state : bodies_.states) {  // Bound: kMaxBodies
    if (state.group == group) state.group = BodiesT::kAlone;
  }
}

/// It is planned anew from where it is, to end on its flight.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::shorten(std::size_t slot, Scalar until) {
  const Group name = bodies_.states[slot].group;
  start_group(sums_of(name), name, until);
}

/// The inertia turns with the group, or the angular momentum the other way as the group sees it.
template <class SceneT>
[[gnu::cold]] Scalar_of<SceneT> Welds<SceneT>::off_flight(std::size_t slot, Scalar time) const {
  const BodyState& state = bodies_.states[slot];
  if (state.is_led_group() || !(state.start < time)) return Scalar(0);
  const auto group = sums_of(state.group).group;
  const auto energy = [&group](const Vec3<Scalar>& L_W) {
    return L_W.dot(group_twist(group, L_W).w_W);
  };
  const Vec3<Scalar>& L_W = group.momentum.angular_W;
  const Quat<Scalar> q = pose_at(state.plan.motion, time - state.start).q_WB;
  const Scalar whole = energy(L_W);
  return whole > Scalar(0) ? energy(q.conjugate() * L_W) / whole - 1 : Scalar(0);
}

/// All of a group are where it has come to, each with the velocity of its place.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::settle(Group group) {
  std::size_t first = 0;
  while (bodies_.states[first].group != group) ++first;  // Bound: kMaxBodies: who asks is in it
  const BodyState& whole = bodies_.states[first];
  if constexpr (SceneT::kRotation) {
    settle_turning(whole);
  } else {
    settle_straight(whole);
  }
  [[maybe_unused]] const Scalar held = bodies_.now - whole.start;
  if constexpr (kHolds<SceneT> && !kCountsHeld<SceneT>) bodies_.report.time_held += held;
  for (std::size_t slot = first; slot < BodiesT::kSlots; ++slot) {  // Bound: kMaxBodies
    BodyState& state = bodies_.states[slot];
    if (state.group != group) continue;
    if constexpr (SceneT::kGravity) end_fall(slot);
    if constexpr (kCountsHeld<SceneT>) note_held(state.held_for += held);
    state.held_until = 0;
    state.start = bodies_.now;
    state.changed = true;
    Kinematics::restart(state.plan.motion, bodies_.actor(slot).body, bodies_.dt - bodies_.now);
  }
  bodies_.is_changed = true;
}

/// All of a group go from their places to those at the end.
template <class SceneT>
void Welds<SceneT>::go_along(const BodyState& whole, const Pose<Scalar>& X_WG) {
  for (std::size_t slot = 0; slot < BodiesT::kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies_.states[slot].group != whole.group) continue;
    auto& body = bodies_.actor(slot).body;
    take_along(body, whole.plan.motion.X_WB.p_W, X_WG);
    if constexpr (kHolds<SceneT> && !BodiesT::kIsFree) {  // nobody leads, nothing turns
      const bool is_held = whole.group_plan == GroupPlan::kHeld;
      if (is_held && is_moved_in(whole.group, slot)) turn_along(body, X_WG);
    }
  }
}

/// What rounding leaves of the sums goes to the heaviest.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::settle_turning(const BodyState& whole) {
  const GroupSums<SceneT> sums = sums_of(whole.group);
  const Pose<Scalar> X_WG = pose_at(whole.plan.motion, bodies_.now - whole.start);
  Momentum<Scalar> left = sums.group.momentum;
  Twist<Scalar> twist = whole.plan.motion.twist;
  if (whole.start < bodies_.now && !Kinematics::is_still(whole.plan.motion)) go_along(whole, X_WG);
  if (!whole.is_led_group()) twist = group_twist(sums_of(whole.group).group, left.angular_W);
  for (std::size_t slot = 0; slot < BodiesT::kSlots; ++slot) {  // Bound: kMaxBodies
    if (is_pushed_in(whole.group, slot))
      give_momentum(bodies_.actor(slot).body, X_WG.p_W, twist, left);
  }
  if (whole.is_led_group()) return;
  Momentum<Scalar>& heaviest = bodies_.actor(sums.heaviest).body.momentum;
  add_to(heaviest.linear_W, left.linear_W);
  if (sums.group.turns) add_to(heaviest.angular_W, left.angular_W);
}

template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::settle_straight(const BodyState& whole) {
  const GroupSums<SceneT> sums = sums_of(whole.group);
  Vec3<Scalar> left_W = sums.group.momentum_W;
  Vec3<Scalar> v_W = whole.plan.motion.v_W;
  if (!whole.is_led_group()) v_W = left_W / sums.group.mass;
  for (std::size_t slot = 0; slot < BodiesT::kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies_.states[slot].group != whole.group) continue;
    auto& body = bodies_.actor(slot).body;
    Kinematics::move(body, bodies_.states[slot].plan.motion, bodies_.now - whole.start);
    if (!is_pushed_in(whole.group, slot)) continue;
    body.momentum_W = v_W / body.inverse_mass;
    left_W -= body.momentum_W;
  }
  if (!whole.is_led_group()) bodies_.actor(sums.heaviest).body.momentum_W += left_W;
}

/// Whether a body is of a group, and a momentum moves it.
template <class SceneT>
bool Welds<SceneT>::is_moved_in(Group group, std::size_t slot) const {
  const BodyState& state = bodies_.states[slot];
  if (state.group != group || !(bodies_.actor(slot).body.inverse_mass > Scalar(0))) return false;
  return BodiesT::kIsFree || !state.is_led_group() || state.plan.by_momentum;
}

/// Whether its momentum is the group's.
template <class SceneT>
bool Welds<SceneT>::is_pushed_in(Group group, std::size_t slot) const {
  if (kHolds<SceneT> && bodies_.states[slot].group_plan == GroupPlan::kHeld) return false;
  return is_moved_in(group, slot);
}

/// At the end of its group a body is off its parabola; what was carried by one that was led begins
/// to fall. For who was held time stood still: gravity gave it nothing.
template <class SceneT>
[[gnu::cold]] void Welds<SceneT>::end_fall(std::size_t slot) {
  BodyState& state = bodies_.states[slot];
  const Scalar span = bodies_.dt - state.start;
  const Scalar elapsed = bodies_.now - state.start;
  const Scalar left = span > Scalar(0) ? 1 - elapsed / span : Scalar(0);
  const bool is_held = kHolds<SceneT> && state.group_plan == GroupPlan::kHeld;
  if (!is_held) state.off_W *= left;
  if (!state.loaded) state.off_W -= (elapsed * (span - elapsed) / 2) * bodies_.settings.gravity_W;
  if (state.is_led_group() && is_moved_in(state.group, slot)) {
    fall_by(slot, is_held ? -elapsed : bodies_.dt - bodies_.now);
  }
  state.loaded = state.loaded && !state.is_led_group();
}

/// Adds what gravity gives a body in that time to its momentum.
template <class SceneT>
void Welds<SceneT>::fall_by(std::size_t slot, Scalar time) {
  auto& body = bodies_.actor(slot).body;
  Kinematics::add_momentum(body, (time / body.inverse_mass) * bodies_.settings.gravity_W);
}

}  // namespace batuta::detail
