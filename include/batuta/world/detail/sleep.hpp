// SPDX-License-Identifier: MIT
#pragma once
// Who sleeps (SceneOptions::sleep; src/world/world.md, "Sleep"): groups that something holds, of
// which nobody has left its place for a while. One of the five that make a step
// (general_world.hpp).

#include "batuta/world/detail/actor_sum.hpp"
#include "batuta/world/detail/quiet.hpp"

namespace batuta::detail {

template <class SceneT>
class Sleep {
 public:
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  using GroupsT = ContactGroups<SceneT>;
  using PairsT = Pairs<SceneT>;

  /// A body is new.
  void add(BodiesT& bodies, std::size_t slot) {
    start_over(bodies, slot);
    rests_[slot].sum = sum_of(bodies.actor(slot)) & ~kFlags;
  }
  /// Wakes whom the caller has disturbed, and who lies against what he has; before a step.
  void begin_step(BodiesT& bodies, const GroupsT& groups);
  /// Wakes who is pressed, or touched by what is led elsewhere, before contacts are solved: else a
  /// sleeper would be a wall to it. Calls woken(slot) for each. @pre all have boxes
  /// @returns whether somebody was woken. Bound: the pairs of boxes that meet.
  template <class Woken>
  bool wake_touched(BodiesT& bodies, GroupsT& groups, PairsT& pairs, const Woken& woken);
  /// Wakes a body and all that sleep against it. Calls woken(slot) for each.
  /// Bound: kMaxBodies, and their contacts.
  template <class Woken>
  void wake(BodiesT& bodies, const GroupsT& groups, std::size_t slot, const Woken& woken);
  /// Something has happened to a body: it wakes, with all that sleep against it, or has to be quiet
  /// for all of sleep_time once more. Bound: as wake().
  void disturb(BodiesT& bodies, const GroupsT& groups, std::size_t slot) {
    wake(bodies, groups, slot, [](std::size_t) {});
    rests_[slot].quiet = 0;
  }
  /// To all that it is near. Bound: as wake(), for each.
  void disturb_neighbours(BodiesT& bodies, const GroupsT& groups, std::size_t slot) {
    groups.contacts.for_each_neighbour(slot,
                                       [&](std::size_t other) { disturb(bodies, groups, other); });
  }
  /// To all. Bound: kMaxBodies.
  void disturb_all(BodiesT& bodies);
  /// Whether a body sleeps, or is led, stood still in the step, and nobody had changed it before.
  bool rests(const BodiesT& bodies, std::size_t slot) const {
    const auto& state = bodies.states[slot];
    return state.asleep ||
           (state.stands && bodies.is_led(slot) && (rests_[slot].sum & kHasCome) == 0);
  }
  /// Who falls asleep, after a step.
  void end_step(BodiesT& bodies, GroupsT& groups);
  void copy(const Sleep& saved) { *this = saved; }
  template <class Archive>
  void archive(Archive& ar) {
    for (Rest& rest : rests_) ar(rest.anchor, rest.quiet, rest.sum);  // Bound: kMaxBodies
  }

 private:
  static constexpr std::size_t kSlots = BodiesT::kSlots;
  static constexpr std::uint32_t kWasLed = 1;   ///< and awake, in the last step
  static constexpr std::uint32_t kHasCome = 2;  ///< within a step: moved or changed before it
  static constexpr std::uint32_t kFlags = kWasLed | kHasCome;
  struct Rest {
    Pose<Scalar> anchor;
    Scalar quiet = 0;  ///< for so long it has not left the anchor, s
    /// Of what the caller may change (actor_sum.hpp), but for its lowest bits: kFlags.
    std::uint32_t sum = 0;
  };

  /// Awake, and from where it is.
  void start_over(BodiesT& bodies, std::size_t slot) {
    bodies.states[slot].asleep = false;
    rests_[slot].anchor = bodies.actor(slot).body.X_WB;
    rests_[slot].quiet = 0;
  }
  bool is_disturbed(const BodiesT& bodies, std::size_t slot) const;
  bool is_another(const BodiesT& bodies, std::size_t slot);
  bool is_led_off(BodiesT& bodies, std::size_t slot) const;
  bool is_felt(const BodiesT& bodies, GroupsT& groups, PairsT& pairs, ProxyPair pair,
               std::size_t other) const;
  void rouse(BodiesT& bodies, const GroupsT& groups, std::size_t slot);
  bool rouse_touched(BodiesT& bodies, GroupsT& groups, PairsT& pairs);
  bool is_let_go(const BodiesT& bodies, std::size_t slot) const;
  bool rouse_carried(BodiesT& bodies, const GroupsT& groups);
  bool count_quiet(BodiesT& bodies, const GroupsT& groups);
  void find_sleepers(const BodiesT& bodies, GroupsT& groups);
  void fall_asleep(BodiesT& bodies);
  Scalar place_of(const BodiesT& bodies, const GroupsT& groups, std::size_t slot) const;
  bool may_sleep(const BodiesT& bodies, std::size_t slot) const {
    return bodies.states[slot].present && !bodies.states[slot].asleep && !bodies.is_led(slot);
  }

  std::array<Rest, kSlots> rests_{};
  FixedList<std::uint16_t, SceneT::kMaxBodies> stack_;
  std::array<bool, kSlots> awake_{};   ///< of the lowest of a group: somebody in it is
  std::array<bool, kSlots> sleeps_{};  ///< who is to fall asleep, or was woken
};

/// Whether a body stood in the last step, and nobody has moved it since.
template <class SceneT>
bool has_stood(const Bodies<SceneT>& bodies, std::size_t slot) {
  const auto& state = bodies.states[slot];
  return state.stands &&
         KinematicsOf<SceneT>::is_at_start(bodies.actor(slot).body, state.plan.motion);
}

/// Whether somebody else has moved a sleeper, or given it a momentum.
template <class SceneT>
bool Sleep<SceneT>::is_disturbed(const BodiesT& bodies, std::size_t slot) const {
  if (!bodies.states[slot].asleep) return false;
  const auto& momentum = bodies.actor(slot).body.momentum;
  return !has_stood(bodies, slot) || !is_zero(momentum.linear_W) || !is_zero(momentum.angular_W);
}

/// Whether the caller has changed what keeps a body where it is.
template <class SceneT>
bool Sleep<SceneT>::is_another(const BodiesT& bodies, std::size_t slot) {
  if (bodies.states[slot].boxed) return false;  // nobody but those who read it has had it
  const std::uint32_t flags = rests_[slot].sum & kFlags;
  const std::uint32_t sum = (sum_of(bodies.actor(slot)) & ~kFlags) | flags;
  const bool is_another = sum != rests_[slot].sum;
  rests_[slot].sum = sum;
  return is_another;
}

/// Whether a sleeper's controller leads it from now on.
template <class SceneT>
bool Sleep<SceneT>::is_led_off([[maybe_unused]] BodiesT& bodies,
                               [[maybe_unused]] std::size_t slot) const {
  if constexpr (!BodiesT::kIsFree) {
    if (bodies.states[slot].asleep) {
      typename BodiesT::Kinematics::PlanType plan;
      BodiesT::Kinematics::ask(bodies.actor(slot), Scalar(0), bodies.dt, plan);
      return !plan.by_momentum;
    }
  }
  return false;
}

template <class SceneT>
void Sleep<SceneT>::begin_step(BodiesT& bodies, const GroupsT& groups) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.actors.at_index(slot) == nullptr) continue;
    const bool is_another = this->is_another(bodies, slot) || is_led_off(bodies, slot);
    if (is_another || !has_stood(bodies, slot)) rests_[slot].sum |= kHasCome;
    if (!is_another && !is_disturbed(bodies, slot)) continue;
    disturb(bodies, groups, slot);
    disturb_neighbours(bodies, groups, slot);
    if (is_another) bodies.states[slot].stands = false;  // it has just come, for who sleeps near it
  }
}

/// Whether a body is awake, led, and moves or has just come.
template <class SceneT>
bool is_led_elsewhere(const Bodies<SceneT>& bodies, std::size_t slot) {
  const auto& state = bodies.states[slot];
  if (!state.present || state.asleep || !bodies.is_led(slot)) return false;
  return !state.stands || !KinematicsOf<SceneT>::is_still(state.plan.motion);
}

/// Whether a sleeper has something to answer from another that is awake. What is led: where it
/// moves, or has just come. What goes by its momentum: where it would press, were the sleeper a
/// wall; its momentum is that of the step's end.
template <class SceneT>
bool Sleep<SceneT>::is_felt(const BodiesT& bodies, GroupsT& groups, PairsT& pairs, ProxyPair pair,
                            std::size_t other) const {
  const bool is_led = bodies.is_led(other);
  if (is_led && !is_led_elsewhere(bodies, other)) return false;
  NearPair<Scalar> near;
  const Scalar D = rest_gap(bodies, pair);
  if (!is_near(bodies, pairs, pair, D, near)) return false;
  if (is_led) return true;
  LastingContactOf<SceneT> contact;
  contact.pair = pair;
  contact.rest_gap = D;
  const std::size_t a = a_of<SceneT>(contact);
  const std::size_t b = b_of<SceneT>(contact);
  find_points(contact, near.A_W, near.B_W, near.axes, position_of(bodies.actor(a)),
              off_middle(bodies, a, b));
  groups.load(bodies, a);
  groups.load(bodies, b);
  prepare(contact, groups.solved[a], groups.solved[b], bodies.dt);
  return would_press(contact, groups.solved[a], groups.solved[b]);
}

/// Wakes a sleeper and all that sleep against it, and marks them.
template <class SceneT>
void Sleep<SceneT>::rouse(BodiesT& bodies, const GroupsT& groups, std::size_t slot) {
  wake(bodies, groups, slot, [this](std::size_t woken) { sleeps_[woken] = true; });
}

/// Who feels somebody awake. @returns whether somebody does
template <class SceneT>
bool Sleep<SceneT>::rouse_touched(BodiesT& bodies, GroupsT& groups, PairsT& pairs) {
  bool is_any = false;
  pairs.for_each_pair([&](ProxyPair pair) {
    const std::size_t a = BodiesT::body_of(pair.first);
    const std::size_t b = BodiesT::body_of(pair.second);
    const bool sleeps_a = bodies.states[a].asleep;
    if (sleeps_a == bodies.states[b].asleep || !may_meet(bodies.actor(a), bodies.actor(b))) return;
    if (!is_felt(bodies, groups, pairs, pair, sleeps_a ? b : a)) return;
    is_any = true;
    rouse(bodies, groups, sleeps_a ? a : b);
  });
  return is_any;
}

/// Whether a body was led in the last step, and is not any more.
template <class SceneT>
bool Sleep<SceneT>::is_let_go(const BodiesT& bodies, std::size_t slot) const {
  const bool is_awake = bodies.states[slot].present && !bodies.states[slot].asleep;
  return is_awake && (rests_[slot].sum & kWasLed) != 0 && !bodies.is_led(slot);
}

/// Whether a body takes no part in this step: the caller has made it unusable.
template <class SceneT>
bool is_left_out(const Bodies<SceneT>& bodies, std::size_t slot) {
  return !bodies.states[slot].present && bodies.actors.at_index(slot) != nullptr;
}

/// Who lies on what moves, was let go or is left out, at whatever gap: D was another one if it fell
/// asleep in a longer step. @returns whether somebody does
template <class SceneT>
bool Sleep<SceneT>::rouse_carried(BodiesT& bodies, const GroupsT& groups) {
  bool is_any = false;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies, and their contacts
    const bool is_lost = is_let_go(bodies, slot) || is_left_out(bodies, slot);
    if (!is_lost && !is_led_elsewhere(bodies, slot)) continue;
    groups.contacts.for_each_neighbour(slot, [&](std::size_t other) {
      if (!bodies.states[other].asleep) return;
      is_any = true;
      rouse(bodies, groups, other);
    });
  }
  return is_any;
}

template <class SceneT>
template <class Woken>
bool Sleep<SceneT>::wake_touched(BodiesT& bodies, GroupsT& groups, PairsT& pairs,
                                 const Woken& woken) {
  const bool is_touched = rouse_touched(bodies, groups, pairs);
  const bool is_any = rouse_carried(bodies, groups) || is_touched;
  for (std::size_t slot = 0; slot < kSlots && is_any; ++slot) {  // Bound: kMaxBodies
    if (sleeps_[slot]) woken(slot);
    sleeps_[slot] = false;
  }
  return is_any;
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
void Sleep<SceneT>::disturb_all(BodiesT& bodies) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies.states[slot].asleep) start_over(bodies, slot);
    rests_[slot].quiet = 0;
  }
}

/// What a body keeps its place by: so far it goes in sleep_time at rest_speed, or its gaps let it
/// sway, m.
template <class SceneT>
Scalar_of<SceneT> Sleep<SceneT>::place_of(const BodiesT& bodies, const GroupsT& groups,
                                          std::size_t slot) const {
  return max_of(2 * groups.contacts.widest_rest_gap(slot),
                bodies.settings.rest_speed * static_cast<Scalar>(SceneT::kSleepTime));
}

/// How long each has not left its place, by a motion of its own: who was held by a weld, or lies
/// in another, stands where it would not. @returns whether that is long enough for somebody
template <class SceneT>
bool Sleep<SceneT>::count_quiet(BodiesT& bodies, const GroupsT& groups) {
  const auto time = static_cast<Scalar>(SceneT::kSleepTime);
  bool is_any = false;
  for (int i = 0; i < groups.contacts.size(); ++i) {  // Bound: kMaxContacts
    const auto& contact = groups.contacts[i];
    if (!contact.is_solved || !is_in_another(bodies, contact)) continue;
    bodies.states[a_of<SceneT>(contact)].was_jammed = true;
    bodies.states[b_of<SceneT>(contact)].was_jammed = true;
  }
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!may_sleep(bodies, slot)) continue;
    const auto& actor = bodies.actor(slot);
    const Scalar place = place_of(bodies, groups, slot);
    Scalar& quiet = rests_[slot].quiet;
    quiet = min_of(quiet + bodies.dt, 2 * time);
    if (bodies.states[slot].was_jammed || has_gone(actor, rests_[slot].anchor, place) ||
        (!(quiet < time) && is_faster(actor, leaving_speed(bodies, place / time)))) {
      start_over(bodies, slot);
    }
    is_any = is_any || !(quiet < time);
  }
  return is_any;
}

/// Groups that something holds, of which each has been quiet for long enough. A body that is near
/// enough to press on them would wake them, so it falls asleep with them.
template <class SceneT>
void Sleep<SceneT>::find_sleepers(const BodiesT& bodies, GroupsT& groups) {
  const auto time = static_cast<Scalar>(SceneT::kSleepTime);
  groups.group_all(bodies);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    sleeps_[slot] = may_sleep(bodies, slot) && !(rests_[slot].quiet < time) &&
                    groups.is_held(groups.group_of(slot));
  }
  for_each_solved(groups, false, [&](std::size_t a, std::size_t b) {
    if (is_carried(bodies, a, b)) sleeps_[b] = false;
    if (is_carried(bodies, b, a)) sleeps_[a] = false;
  });
  join_all(bodies, groups, false);
  awake_.fill(false);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (may_sleep(bodies, slot) && !sleeps_[slot]) awake_[groups.group_of(slot)] = true;
  }
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    sleeps_[slot] = sleeps_[slot] && !awake_[groups.group_of(slot)];
  }
}

template <class SceneT>
void Sleep<SceneT>::end_step(BodiesT& bodies, GroupsT& groups) {
  if (count_quiet(bodies, groups)) {
    find_sleepers(bodies, groups);
    fall_asleep(bodies);
  }
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    rests_[slot].sum &= ~kFlags;
    if (bodies.actors.at_index(slot) == nullptr) continue;
    if (bodies.states[slot].asleep) {
      ++bodies.report.asleep;
    } else if (bodies.states[slot].present && bodies.is_led(slot)) {
      rests_[slot].sum |= kWasLed;
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
