// SPDX-License-Identifier: MIT
#pragma once
// Bodies and their clocks: who takes part in a step, how each body moves from when on, and who goes
// on together (src/world/world.md). One of the five that make a step (general_world.hpp).

#include "batuta/core/pool.hpp"
#include "batuta/response/straight_impulse.hpp"
#include "batuta/world/detail/candidate_pair.hpp"
#include "batuta/world/detail/straight_kinematics.hpp"
#include "batuta/world/detail/turning_kinematics.hpp"
#include "batuta/world/event.hpp"

namespace batuta::detail {

/// The scalar of a scene.
template <class SceneT>
using Scalar_of = typename SceneT::Scalar;
/// What bodies of a scene are made of: turning or straight.
template <class SceneT>
using KinematicsOf =
    std::conditional_t<SceneT::kRotation, TurningKinematics<SceneT>, StraightKinematics<SceneT>>;
/// Contacts that last are solved together.
template <class SceneT>
inline constexpr bool kLasts = SceneT::kResting == RestingContact::kSettling;

/// Of a body that falls.
template <class Scalar>
struct FallState {
  /// Its place on the parabola less that on the chord along which it goes, m.
  Vec3<Scalar> off_W = Vec3<Scalar>::Zero();
  bool loaded = false;  ///< something carries it: it goes with the velocity of the step's end
};
/// Where the turn of a body may be the chord of a bent one, and contacts are answered.
template <class SceneT>
inline constexpr bool kBends = SceneT::kRotation&& SceneT::kResponse &&
                               (SceneT::kCapsulesPerBody > 1 || kLasts<SceneT>);
/// Of a body whose turn may be the chord of a bent one.
template <class Scalar>
struct BentState {
  Scalar course_end = 0;  ///< in the step, s: until then its chord goes (bent_course.hpp)
};
/// Of a body whose contacts last.
template <class Scalar>
struct OpeningState {
  Twist<Scalar> opening;  ///< for this step, to open gaps; no part of its momentum
};

template <class SceneT>
struct GroupSums;

/// The bodies of a world, and the time.
template <class SceneT>
class Bodies {
 public:
  using Scalar = Scalar_of<SceneT>;
  using Kinematics = KinematicsOf<SceneT>;
  using ActorType = Actor<SceneT>;
  using Slot = std::uint16_t;
  static constexpr std::size_t kSlots = static_cast<std::size_t>(SceneT::kMaxBodies);
  static constexpr int kParts = SceneT::kCapsulesPerBody;
  static constexpr int kProxies = SceneT::kMaxBodies * kParts;
  /// In no group.
  static constexpr Slot kAlone = 0xFFFF;
  /// Nobody has a controller that leads, or is to be told anything.
  static constexpr bool kIsFree =
      !SceneT::kRotation || std::is_same_v<typename SceneT::Controller, FreeFlight<Scalar>>;

  /// What the step knows of a body besides the actor.
  struct State : FeatureIf<SceneT::kGravity, FallState<Scalar>, 2>,
                 FeatureIf<kLasts<SceneT>, OpeningState<Scalar>, 3>,
                 FeatureIf<kBends<SceneT>, BentState<Scalar>, 4> {
    [[gnu::noinline]] State() {}  // kept apart: some calls, and no copies
    typename Kinematics::PlanType plan;
    Scalar start = 0;           ///< in the step, s: the body's own pose is the one of this time
    Scalar held_until = 0;      ///< in the step, s: until then it goes with its group
    Slot group = kAlone;        ///< the lowest slot of those that go on together
    bool present = false;       ///< takes part in the step
    bool changed = false;       ///< it has to be planned anew
    bool fresh = false;         ///< it was planned, its pairs are not collected yet
    bool stands = false;        ///< it was planned to stand still for a whole step, and did
    bool boxed = false;         ///< its boxes are those of its planned motion
    bool asleep = false;        ///< it sleeps (sleep.hpp)
    bool is_led_group = false;  ///< its group goes where a controller leads, or stands
  };

  explicit Bodies(std::uint16_t number) : actors(number) {}

  static std::size_t body_of(int proxy) { return static_cast<std::size_t>(proxy / kParts); }
  static int part_at(int proxy) { return proxy % kParts; }
  static Slot proxy_of(std::size_t slot, int part) {
    return static_cast<Slot>(static_cast<int>(slot) * kParts + part);
  }
  ActorType& actor(std::size_t slot) { return actors.at(slot); }
  const ActorType& actor(std::size_t slot) const { return actors.at(slot); }

  /// The body begins a step: what moves by its momentum is given the fall of the whole step. Sets
  /// `present`. @returns whether it stood still for the last step, and has not been moved
  bool begin(std::size_t slot);
  /// Where it goes from now on.
  void plan(std::size_t slot);
  /// Moves it on its planned motion, by `elapsed`, to now; from there it has to be planned anew.
  void advance(std::size_t slot, Scalar elapsed);
  /// To now.
  void bring(std::size_t slot) {
    if (states[slot].start < now) advance(slot, now - states[slot].start);
  }
  /// The end of the step.
  void finish(std::size_t slot);
  /// Within a step, what slept is at rest, and carried for the rest of it.
  void wake_now(std::size_t slot);
  /// The two, which are where they are now, are off their parabolas by the same from now on: what
  /// makes up for it does not bring them nearer to each other. Their common centre stays on its
  /// own.
  void share_off(std::size_t a, std::size_t b);
  /// A blow of two bodies that do not turn, with their velocities of now.
  StraightHit<Scalar> strike_straight(std::size_t a, std::size_t b, const Vec3<Scalar>& normal_BA_W,
                                      Scalar restitution);

  /// How it moves now: its matter, not its planned motion.
  auto twist_now(std::size_t slot) const;
  /// Whether it falls freely: then its momentum, which is that of the step's end, is not yet its
  /// velocity's.
  bool falls(std::size_t slot) const {
    if constexpr (SceneT::kGravity) {
      const State& state = states[slot];
      return state.plan.by_momentum && !state.loaded && !is_asleep(slot) &&
             actor(slot).body.inverse_mass > Scalar(0);
    } else {
      return false;
    }
  }
  bool is_asleep(std::size_t slot) const { return SceneT::kSleep && states[slot].asleep; }
  /// Nothing that happens to it changes how it moves.
  bool is_led(std::size_t slot) const {
    return !states[slot].plan.by_momentum || is_asleep(slot) ||
           Kinematics::is_immovable(actor(slot).body);
  }
  /// In the step, s: until then its planned motion goes.
  Scalar course_end(std::size_t slot) const {
    if constexpr (kBends<SceneT>) return states[slot].course_end;
    return dt;
  }
  /// @pre now < time
  void end_course(std::size_t slot, Scalar time) {
    if constexpr (kBends<SceneT>) states[slot].course_end = time;
  }
  /// Stands where it is, whatever happens to it.
  [[gnu::noinline]] bool is_wall(std::size_t slot) const {
    return Kinematics::is_still(states[slot].plan.motion) &&
           (states[slot].group != kAlone || is_asleep(slot) ||
            Kinematics::is_immovable(actor(slot).body));
  }

  /// From now on.
  typename Kinematics::Mover mover(int proxy, Scalar until) const;
  /// A capsule where it is now.
  Capsule<Scalar> shape_W(int proxy) const;

  /// Where its own point is now.
  Vec3<Scalar> place_now(std::size_t slot) const {
    const State& state = states[slot];
    if (state.start < now && state.group == kAlone) {
      return state.plan.motion.X_WB.p_W + (now - state.start) * state.plan.motion.twist.v_W;
    }
    return place_of(slot);
  }

  /// The two, and whoever goes with one of them already, go on together (weld.hpp).
  void weld(std::size_t a, std::size_t b, Scalar until);
  /// Those of the body's group go on alone, from now.
  void part_group(std::size_t slot);

  WorldSettings<SceneT> settings;
  StepReport<Scalar> report;
  Pool<ActorType, SceneT::kMaxBodies> actors;
  std::array<State, kSlots> states{};
  Scalar now = 0;           ///< in the step, s
  Scalar dt = 0;            ///< length of the step, s
  bool is_changed = false;  ///< somebody has to be planned anew

 private:
  const Vec3<Scalar>& place_of(std::size_t slot) const { return position_of(actor(slot)); }
  void tell_unknown(std::size_t slot);
  void go_straight(std::size_t slot, Scalar duration);
  void set_course(std::size_t slot);
  void move(std::size_t slot, Scalar elapsed);
  // Groups: weld.hpp.
  Slot name_of(std::size_t slot) const {
    return states[slot].group == kAlone ? static_cast<Slot>(slot) : states[slot].group;
  }
  void end_openings();
  bool take_in(std::size_t slot, Slot name);
  GroupSums<SceneT> sums_of(Slot name) const;
  typename Kinematics::MotionType course_of(const GroupSums<SceneT>& sums, Scalar duration) const;
  void start_group(const GroupSums<SceneT>& sums, Slot name, Scalar until);
  void settle(Slot group);
  void settle_turning(const State& whole);
  void settle_straight(const State& whole);
  bool is_pushed_in(Slot group, std::size_t slot) const;
  void end_fall(std::size_t slot);
};

template <class SceneT>
bool Bodies<SceneT>::begin(std::size_t slot) {
  State& state = states[slot];
  const bool stood = state.stands;
  state.present = state.stands = state.changed = state.fresh = false;
  state.group = kAlone;
  state.start = state.held_until = 0;
  end_course(slot, dt);
  if constexpr (SceneT::kGravity) {
    state.off_W.setZero();
    state.loaded = false;
  }
  if constexpr (kLasts<SceneT>) state.opening = {};
  ActorType& actor = actors.at(slot);
  if (!has_valid_features(actor) || !Kinematics::is_usable(actor.body)) {
    ++report.plans_invalid;
    return false;
  }
  state.present = true;
  const bool stayed = stood && Kinematics::is_at_start(actor.body, state.plan.motion);
  if (is_asleep(slot)) {
    state.plan.motion = Kinematics::standing(actor.body, dt);
  } else if constexpr (kIsFree && kLasts<SceneT>) {
    state.plan.by_momentum = true;
    state.plan.motion = Kinematics::free_motion(actor.body, dt);
  } else if constexpr (kLasts<SceneT> || SceneT::kGravity) {
    Kinematics::ask(actor, Scalar(0), dt, state.plan);
  }
  if constexpr (kLasts<SceneT>) {
    if (!is_valid(state.plan.motion)) go_straight(slot, dt);
  }
  if constexpr (SceneT::kGravity) {
    if (falls(slot)) {
      Kinematics::linear_momentum(actor.body) +=
          (dt / actor.body.inverse_mass) * settings.gravity_W;
    }
  }
  return stayed;
}

template <class SceneT>
void Bodies<SceneT>::plan(std::size_t slot) {
  State& state = states[slot];
  state.start = now;
  if (state.group != kAlone) return;
  const ActorType& actor = this->actor(slot);
  const Scalar rest = dt - now;
  if (is_asleep(slot)) {
    state.plan.motion = Kinematics::standing(actor.body, rest);
    return;
  }
  Kinematics::ask(actor, now, course_end(slot) - now, state.plan);
  const bool is_known = is_valid(state.plan.motion);
  if (!is_known) go_straight(slot, rest);
  set_course(slot);
  if (!is_known || (SceneT::kGravity && !is_valid(state.plan.motion))) tell_unknown(slot);
}

/// Where it turns is not known: it goes on without a turn; where not even that is known, it stands.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::tell_unknown(std::size_t slot) {
  auto& motion = states[slot].plan.motion;
  ++report.plans_invalid;
  if (is_valid(motion)) return;
  motion = Kinematics::standing(actor(slot).body, dt - now);
  report.time_held = max_of(report.time_held, dt - now);
}

/// By its momentum, without a turn.
template <class SceneT>
[[gnu::cold]] void Bodies<SceneT>::go_straight(std::size_t slot, Scalar duration) {
  auto& motion = states[slot].plan.motion;
  motion = Kinematics::standing(actor(slot).body, duration);
  Kinematics::velocity(motion) = Kinematics::momentum_velocity(actor(slot).body);
}

/// The chord of the parabola, and what the last one lacked (world.md, "The fall").
template <class SceneT>
void Bodies<SceneT>::set_course(std::size_t slot) {
  State& state = states[slot];
  const Scalar rest = dt - now;
  if constexpr (SceneT::kGravity) {
    const bool moves = state.plan.by_momentum && actor(slot).body.inverse_mass > Scalar(0);
    if (moves && rest > Scalar(0)) {
      Vec3<Scalar>& v_W = Kinematics::velocity(state.plan.motion);
      v_W = Kinematics::momentum_velocity(actor(slot).body);
      if (!state.loaded) v_W -= (rest / 2) * settings.gravity_W;
      v_W += state.off_W / rest;
    }
  }
  if constexpr (kLasts<SceneT>) {
    if (!state.plan.by_momentum) return;
    state.plan.motion.twist.v_W += state.opening.v_W;
    state.plan.motion.twist.w_W += state.opening.w_W;
  }
}

/// An opening turns a body as no momentum does: where that would add energy, what turns it is less.
template <class SceneT>
void Bodies<SceneT>::move(std::size_t slot, Scalar elapsed) {
  auto& body = actor(slot).body;
  const auto& motion = states[slot].plan.motion;
  if constexpr (kLasts<SceneT>) {
    if (!is_zero(states[slot].opening.w_W)) {
      const auto energy = [&body] { return body.momentum.angular_W.dot(twist_of(body).w_W); };
      const Scalar before = energy();
      Kinematics::move(body, motion, elapsed);
      const Scalar after = energy();
      using std::sqrt;
      if (after > before) body.momentum.angular_W *= sqrt(before / after);
      return;
    }
  }
  Kinematics::move(body, motion, elapsed);
}

template <class SceneT>
void Bodies<SceneT>::advance(std::size_t slot, Scalar elapsed) {
  State& state = states[slot];
  if constexpr (SceneT::kGravity) {
    const Scalar whole = dt - state.start;
    const Scalar left = whole > Scalar(0) ? 1 - elapsed / whole : Scalar(0);
    state.off_W *= left;
    if (falls(slot)) state.off_W -= (elapsed * (whole - elapsed) / 2) * settings.gravity_W;
  }
  move(slot, elapsed);
  Kinematics::restart(state.plan.motion, actor(slot).body, dt - now);
  state.start = now;
  state.changed = true;
  is_changed = true;
}

template <class SceneT>
void Bodies<SceneT>::finish(std::size_t slot) {
  if (states[slot].group != kAlone) part_group(slot);
  const State& state = states[slot];
  ActorType& actor = this->actor(slot);
  if (!state.stands && state.start < dt) {
    move(slot, dt - state.start);
  }
  if constexpr (!kIsFree) actor.controller.on_step_end(actor.body, dt);
}

template <class SceneT>
void Bodies<SceneT>::wake_now(std::size_t slot) {
  State& state = states[slot];
  state.plan.motion = Kinematics::standing(actor(slot).body, dt - now);
  state.start = now;
  if constexpr (SceneT::kGravity) state.loaded = true;
  state.changed = is_changed = true;
}

template <class SceneT>
void Bodies<SceneT>::share_off(std::size_t a, std::size_t b) {
  if constexpr (SceneT::kGravity) {
    const Scalar of_a = actor(b).body.inverse_mass;  // a's share of both masses, and b's
    const Scalar of_b = actor(a).body.inverse_mass;
    Vec3<Scalar> mean_W = Vec3<Scalar>::Zero();
    if (!is_led(a) && !is_led(b) && of_a + of_b > Scalar(0)) {
      mean_W = (of_a * states[a].off_W + of_b * states[b].off_W) / (of_a + of_b);
    }
    states[a].off_W = states[b].off_W = mean_W;
  }
}

template <class SceneT>
StraightHit<Scalar_of<SceneT>> Bodies<SceneT>::strike_straight(std::size_t a, std::size_t b,
                                                               const Vec3<Scalar>& normal_BA_W,
                                                               Scalar restitution) {
  const auto fall_by = [this](std::size_t slot, Scalar time) {
    if constexpr (SceneT::kGravity) {
      if (!falls(slot)) return;
      auto& body = actor(slot).body;
      body.momentum_W += (time / body.inverse_mass) * settings.gravity_W;
    }
  };
  fall_by(a, now - dt);
  fall_by(b, now - dt);
  const auto hit = straight_impulse(actor(a).body, actor(b).body, normal_BA_W, restitution);
  fall_by(a, dt - now);
  fall_by(b, dt - now);
  return hit;
}

template <class SceneT>
auto Bodies<SceneT>::twist_now(std::size_t slot) const {
  const State& state = states[slot];
  const auto& body = actor(slot).body;
  auto twist = Kinematics::twist_at(body, state.plan);
  if constexpr (SceneT::kGravity) {
    if (falls(slot)) Kinematics::linear(twist) -= (dt - now) * settings.gravity_W;
  }
  return twist;
}

template <class SceneT>
typename KinematicsOf<SceneT>::Mover Bodies<SceneT>::mover(int proxy, Scalar until) const {
  const State& state = states[body_of(proxy)];
  const ActorType& actor = this->actor(body_of(proxy));
  auto mover = Kinematics::mover(actor, part_at(proxy), state.plan.motion);
  Kinematics::skip(mover.motion, now - state.start, until - now);
  if constexpr (SceneT::kMaxBodies > 2) {  // of two bodies nobody else meets a group
    if (state.group != kAlone) Kinematics::put_in_group(mover, actor, state.plan.motion);
  }
  return mover;
}

template <class SceneT>
Capsule<Scalar_of<SceneT>> Bodies<SceneT>::shape_W(int proxy) const {
  const auto moving = mover(proxy, now);
  return to_world(moving.motion.X_WB, moving.capsule_B);
}

}  // namespace batuta::detail

#include "batuta/world/detail/weld.hpp"
