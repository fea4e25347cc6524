// SPDX-License-Identifier: MIT
#pragma once
// Who sleeps (SceneOptions::sleep; src/world/world.md, "Sleep"): groups that something holds, of
// which nobody has left its place for a while. One of the five that make a step
// (general_world.hpp).

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

template <class SceneT>
class Sleep {
 public:
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  using GroupsT = ContactGroups<SceneT>;

  /// Awake, and from where it is.
  void start_over(BodiesT& bodies, std::size_t slot) {
    bodies.states[slot].asleep = false;
    rests_[slot] = {bodies.actor(slot).body.X_WB, Scalar(0)};
  }
  /// Wakes whom the caller has disturbed, or something that moves presses on; before a step.
  void begin_step(BodiesT& bodies, const GroupsT& groups);
  /// Wakes a body and all that sleep against it. Calls woken(slot) for each.
  /// Bound: kMaxBodies, and their contacts.
  template <class Woken>
  void wake(BodiesT& bodies, const GroupsT& groups, std::size_t slot, const Woken& woken);
  /// Wakes all. Bound: kMaxBodies.
  void wake_all(BodiesT& bodies);
  /// Who falls asleep, after a step.
  void end_step(BodiesT& bodies, GroupsT& groups);
  void copy(const Sleep& saved) { *this = saved; }
  template <class Archive>
  void archive(Archive& ar) {
    for (Rest& rest : rests_) ar(rest.anchor, rest.quiet);  // Bound: kMaxBodies
  }

 private:
  static constexpr std::size_t kSlots = BodiesT::kSlots;
  struct Rest {
    Pose<Scalar> anchor;
    Scalar quiet = 0;  ///< for so long it has not left the anchor, s
  };

  bool is_disturbed(const BodiesT& bodies, std::size_t slot) const;
  bool is_moving(const BodiesT& bodies, std::size_t slot) const;
  void wake_pressed(BodiesT& bodies, const GroupsT& groups);
  bool count_quiet(BodiesT& bodies, const GroupsT& groups);
  void find_sleepers(const BodiesT& bodies, GroupsT& groups);
  void fall_asleep(BodiesT& bodies);
  bool has_left(const BodiesT& bodies, const GroupsT& groups, std::size_t slot) const;
  bool may_sleep(const BodiesT& bodies, std::size_t slot) const {
    return bodies.states[slot].present && !bodies.states[slot].asleep && !bodies.is_led(slot);
  }

  std::array<Rest, kSlots> rests_{};
  FixedList<std::uint16_t, SceneT::kMaxBodies> stack_;
  std::array<bool, kSlots> awake_{};   ///< of the lowest of a group: somebody in it is
  std::array<bool, kSlots> sleeps_{};  ///< who is to fall asleep
};

/// Whether somebody else has moved what stood, or given it a momentum.
template <class SceneT>
bool Sleep<SceneT>::is_disturbed(const BodiesT& bodies, std::size_t slot) const {
  const auto& body = bodies.actor(slot).body;
  return !BodiesT::Kinematics::is_at_start(body, bodies.states[slot].plan.motion) ||
         !is_zero(body.momentum.linear_W) || !is_zero(body.momentum.angular_W);
}

/// Whether what is awake goes faster than rest somewhere.
template <class SceneT>
bool Sleep<SceneT>::is_moving(const BodiesT& bodies, std::size_t slot) const {
  const auto& actor = bodies.actor(slot);
  const auto& plan = bodies.states[slot].plan;
  const Twist<Scalar> twist = BodiesT::Kinematics::twist_at(actor.body, plan);
  return most_speed(actor, twist) > bodies.settings.rest_speed;
}

template <class SceneT>
void Sleep<SceneT>::begin_step(BodiesT& bodies, const GroupsT& groups) {
  const auto wake_neighbours = [&](std::size_t slot) {
    groups.contacts.for_each_neighbour(
        slot, [&](std::size_t other) { wake(bodies, groups, other, [](std::size_t) {}); });
  };
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.actors.at_index(slot) == nullptr) continue;
    const bool stood = bodies.states[slot].asleep || bodies.states[slot].stands;
    if (!stood || !is_disturbed(bodies, slot)) continue;
    if (bodies.states[slot].asleep) wake(bodies, groups, slot, [](std::size_t) {});
    wake_neighbours(slot);
  }
  wake_pressed(bodies, groups);
}

/// Those that something touches which moves.
template <class SceneT>
void Sleep<SceneT>::wake_pressed(BodiesT& bodies, const GroupsT& groups) {
  for (int i = 0; i < groups.contacts.size(); ++i) {  // Bound: kMaxContacts
    const std::size_t a = BodiesT::body_of(groups.contacts[i].pair.first);
    const std::size_t b = BodiesT::body_of(groups.contacts[i].pair.second);
    if (bodies.states[a].asleep == bodies.states[b].asleep) continue;
    const std::size_t sleeper = bodies.states[a].asleep ? a : b;
    if (is_moving(bodies, a + b - sleeper)) wake(bodies, groups, sleeper, [](std::size_t) {});
  }
}

template <class SceneT>
template <class Woken>
void Sleep<SceneT>::wake(BodiesT& bodies, const GroupsT& groups, std::size_t slot,
                         const Woken& woken) {
  if (!bodies.states[slot].asleep) return;
  stack_.clear();
  start_over(bodies, slot);
  stack_.push(static_cast<std::uint16_t>(slot));
  woken(slot);
  while (!stack_.empty()) {  // Bound: kMaxBodies: each is woken once
    const std::size_t next = stack_[stack_.size() - 1];
    stack_.remove_swapping(stack_.size() - 1);
    groups.contacts.for_each_neighbour(next, [&](std::size_t other) {
      if (!bodies.states[other].asleep) return;
      start_over(bodies, other);
      stack_.push(static_cast<std::uint16_t>(other));
      woken(other);
    });
  }
}

template <class SceneT>
void Sleep<SceneT>::wake_all(BodiesT& bodies) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.states[slot].asleep) start_over(bodies, slot);
  }
}

/// Whether the body has gone further than it would at rest_speed, or than its gaps let it sway.
template <class SceneT>
bool Sleep<SceneT>::has_left(const BodiesT& bodies, const GroupsT& groups, std::size_t slot) const {
  const auto& actor = bodies.actor(slot);
  const Scalar limit = max_of(2 * groups.contacts.widest_rest_gap(slot),
                              bodies.settings.rest_speed * static_cast<Scalar>(SceneT::kSleepTime));
  const auto is_far = [&](const Vec3<Scalar>& x_B) {
    const Vec3<Scalar> way = to_world(actor.body.X_WB, x_B) - to_world(rests_[slot].anchor, x_B);
    return way.squaredNorm() > limit * limit;
  };
  bool left = false;
  for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
    const Segment<Scalar>& axis = part_of(actor, i).axis;
    left = left || is_far(axis.a) || is_far(axis.b);
  }
  return left;
}

/// How long each has not left its place. @returns whether that is long enough for somebody
template <class SceneT>
bool Sleep<SceneT>::count_quiet(BodiesT& bodies, const GroupsT& groups) {
  const auto time = static_cast<Scalar>(SceneT::kSleepTime);
  bool is_any = false;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!may_sleep(bodies, slot)) continue;
    if (has_left(bodies, groups, slot)) {
      start_over(bodies, slot);
    } else {
      rests_[slot].quiet = min_of(rests_[slot].quiet + bodies.dt, 2 * time);
    }
    is_any = is_any || !(rests_[slot].quiet < time);
  }
  return is_any;
}

/// Groups that something holds, of which each has been quiet for long enough.
template <class SceneT>
void Sleep<SceneT>::find_sleepers(const BodiesT& bodies, GroupsT& groups) {
  const auto time = static_cast<Scalar>(SceneT::kSleepTime);
  groups.group_all(bodies);
  awake_.fill(false);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (may_sleep(bodies, slot) && rests_[slot].quiet < time) awake_[groups.group_of(slot)] = true;
  }
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    const std::size_t group = groups.group_of(slot);
    if (!may_sleep(bodies, slot) || awake_[group] || !groups.is_held(group)) continue;
    sleeps_[slot] = true;
  }
}

template <class SceneT>
void Sleep<SceneT>::end_step(BodiesT& bodies, GroupsT& groups) {
  if (count_quiet(bodies, groups)) {
    find_sleepers(bodies, groups);
    fall_asleep(bodies);
  }
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.actors.at_index(slot) != nullptr && bodies.states[slot].asleep) {
      ++bodies.report.asleep;
    }
  }
}

template <class SceneT>
void Sleep<SceneT>::fall_asleep(BodiesT& bodies) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!sleeps_[slot]) continue;
    sleeps_[slot] = false;
    auto& state = bodies.states[slot];
    auto& body = bodies.actor(slot).body;
    body.momentum = {};
    state.asleep = state.stands = true;
    // Where it is found if nobody disturbs it.
    state.plan.motion = BodiesT::Kinematics::standing(body, Scalar(0));
  }
}

}  // namespace batuta::detail
