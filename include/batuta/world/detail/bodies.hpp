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

/// A contact may take the load of what falls for the rest of a step (world.md, "The fall").
template <class SceneT>
inline constexpr bool kCarries = SceneT::kGravity && !kLasts<SceneT>;

/// Bearings may have something to take in every step.
template <class SceneT>
inline constexpr bool kBearsLoads = SceneT::kResponse && (SceneT::kGravity || kLasts<SceneT>);

/// Of a body that falls.
template <class Scalar>
struct FallState {
  /// Its place on the parabola less that on the chord along which it goes, m.
  Vec3<Scalar> off_W = Vec3<Scalar>::Zero();
  bool loaded = false;  ///< something carries it: it goes with the velocity of the step's end
};
/// What carrying a body takes of who turns about an axle, or is carried itself.
template <class Scalar>
struct Reaction {
  static constexpr std::uint16_t kNobody = 0xFFFF;

  Momentum<Scalar> load;            ///< on it, per second, N and N m
  std::uint16_t carrier = kNobody;  ///< slot
};
/// Of a body that falls, where contacts do not last.
template <class Scalar>
struct CarriedState {
  Momentum<Scalar> support;  ///< by what carries it, per second, N and N m; 0: nothing does
  std::array<Reaction<Scalar>, 2> reactions;  ///< of the last two such carriers
};
/// Where the turn of a body may be the chord of a bent one, and contacts are answered.
template <class SceneT>
inline constexpr bool kBends = SceneT::kBentTurns&& SceneT::kResponse;
/// Where a group of the paper's separation may be met before it parts: its turn is a chord, too.
template <class SceneT>
inline constexpr bool kPartsGroups = SceneT::kRotation&& SceneT::kResponse&& SceneT::kResting ==
                                         RestingContact::kSeparation &&
                                     (SceneT::kMaxBodies > 2);
/// Where time may stand still for a body, which keeps its momentum: the paper's separation.
template <class SceneT>
inline constexpr bool kHolds =
    SceneT::kRotation&& SceneT::kResponse&& SceneT::kResting == RestingContact::kSeparation;
/// Of more than two bodies each has its own time for which it was held. Two are held together.
template <class SceneT>
inline constexpr bool kCountsHeld = kHolds<SceneT> && (SceneT::kMaxBodies > 2);
/// Of a body that the paper's separation may stop more than once in a step.
template <class Scalar>
struct HeldState {
  Scalar held_for = 0;  ///< it went on together with others for so long in this step, s
};
/// Where a group goes.
enum class GroupPlan : std::uint8_t {
  kOwn,   ///< by the momenta of all in it
  kLed,   ///< where a controller leads, or it stands
  kHeld,  ///< the same; who is not led keeps its momentum, and time stands still for it
};
/// Where courses may end before a contact.
template <class SceneT>
inline constexpr bool kCuts = kBends<SceneT> || kPartsGroups<SceneT>;
/// Of a body whose turn may be the chord of a bent one.
template <class Scalar>
struct BentState {
  Scalar plan_end = 0;  ///< in the step, s: until then its chord goes (bent_course.hpp)
};
/// Of a body whose contacts last.
template <class Scalar>
struct OpeningState {
  Twist<Scalar> opening;  ///< for this step, to open gaps; no part of its momentum
  /// What shifts of this step changed of its x x p, kg m^2/s (moment_account.hpp).
  Vec3<Scalar> moment_W = zero<Scalar>();
  /// As deep as two of its group were in each other when the step began, m.
  Scalar deepest = 0;
  bool is_held = false;     ///< something holds those it was opened with
  bool is_opened = true;    ///< may still be moved to open gaps
  bool is_capped = false;   ///< lies in one above it that cannot give way
  bool was_jammed = false;  ///< it did not make its own motion in this step, or lies in another
};

/// The numbers of all capsules of all bodies: parts of one body follow each other.
template <class SceneT>
struct Proxies {
  using Slot = std::uint16_t;
  static constexpr int kParts = SceneT::kCapsulesPerBody;
  static constexpr int kProxies = SceneT::kMaxBodies * kParts;

  static std::size_t body_of(int proxy) { return static_cast<std::size_t>(proxy / kParts); }
  static int part_at(int proxy) { return proxy % kParts; }
  static Slot proxy_of(std::size_t slot, int part) {
    return static_cast<Slot>(static_cast<int>(slot) * kParts + part);
  }
};

/// The bodies of a world, and the time.
template <class SceneT>
class Bodies : public Proxies<SceneT> {
 public:
  using Scalar = Scalar_of<SceneT>;
  using Kinematics = KinematicsOf<SceneT>;
  using ActorType = Actor<SceneT>;
  using typename Proxies<SceneT>::Slot;
  using Proxies<SceneT>::body_of;
  using Proxies<SceneT>::part_at;
  static constexpr std::size_t kSlots = static_cast<std::size_t>(SceneT::kMaxBodies);
  /// Names a group: the lowest slot of those that go on together.
  using Group = std::conditional_t<(SceneT::kMaxBodies < 255), std::uint8_t, std::uint16_t>;
  /// In no group.
  static constexpr Group kAlone = std::numeric_limits<Group>::max();
  /// Nobody has a controller that leads, or is to be told anything.
  static constexpr bool kIsFree =
      !SceneT::kRotation || std::is_same_v<typename SceneT::Controller, FreeFlight<Scalar>>;

  /// What the step knows of a body besides the actor.
  struct BodyState : FeatureIf<SceneT::kGravity, FallState<Scalar>, 2>,
                     FeatureIf<kLasts<SceneT>, OpeningState<Scalar>, 3>,
                     FeatureIf<kBends<SceneT>, BentState<Scalar>, 4>,
                     FeatureIf<kCarries<SceneT>, CarriedState<Scalar>, 5>,
                     FeatureIf<kCountsHeld<SceneT>, HeldState<Scalar>, 6> {
    [[gnu::noinline]] BodyState() {}  // kept apart: some calls, and no copies
    typename Kinematics::PlanType plan;
    Scalar start = 0;       ///< in the step, s: the body's own pose is the one of this time
    Scalar held_until = 0;  ///< in the step, s: until then it goes with its group
    Group group = kAlone;   ///< with whom it goes on together
    bool present = false;   ///< takes part in the step
    bool changed = false;   ///< it has to be planned anew
    bool fresh = false;     ///< it was planned, its pairs are not collected yet
    bool stands = false;    ///< it was planned to stand still for a whole step, and did
    bool boxed = false;     ///< its boxes are those of its planned motion
    bool asleep = false;    ///< it sleeps (sleep.hpp)
    GroupPlan group_plan = GroupPlan::kOwn;  ///< of its group

    bool is_led_group() const { return group_plan != GroupPlan::kOwn; }
  };

  explicit Bodies(std::uint16_t number) : actors(number) {}

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
  void advance_to_now(std::size_t slot) {
    if (states[slot].start < now) advance(slot, now - states[slot].start);
  }
  /// The end of the step.
  void finish(std::size_t slot);

  /// How it moves now: its matter, not its planned motion.
  auto twist_now(std::size_t slot) const;
  /// Whether it falls freely: then its momentum, which is that of the step's end, is not yet its
  /// velocity's.
  bool falls(std::size_t slot) const {
    if constexpr (SceneT::kGravity) {
      const BodyState& state = states[slot];
      return state.plan.by_momentum && !state.loaded && !is_asleep(slot) &&
             actor(slot).body.inverse_mass > Scalar(0);
    } else {
      return false;
    }
  }
  /// The caller has it, and may change it: it is compared with all others. Where bodies sleep, a
  /// sum tells whether anything was changed.
  void look_again(std::size_t slot) {
    states[slot].boxed = false;
    if constexpr (!SceneT::kSleep) states[slot].stands = false;
  }
  bool is_asleep(std::size_t slot) const { return SceneT::kSleep && states[slot].asleep; }
  /// Nothing that happens to it changes how it moves.
  bool is_led(std::size_t slot) const {
    return !states[slot].plan.by_momentum || is_asleep(slot) ||
           Kinematics::is_immovable(actor(slot).body);
  }
  /// Who lies on it is carried: it is led, or turns about an axle and goes nowhere.
  bool holds(std::size_t slot) const {
    return is_led(slot) || !(actor(slot).body.inverse_mass > Scalar(0));
  }
  /// In the step, s: until then its planned motion goes.
  Scalar plan_end(std::size_t slot) const {
    if constexpr (kBends<SceneT>) return states[slot].plan_end;
    return dt;
  }
  /// In the step, s: until then it goes alone, or with its group.
  Scalar goes_until(std::size_t slot) const {
    return states[slot].group == kAlone ? plan_end(slot) : states[slot].held_until;
  }
  /// Nothing that happened to it has changed how it is led: its controller is asked once a step.
  bool keeps_course(std::size_t slot) const {
    if constexpr (kIsFree) return false;
    const BodyState& state = states[slot];
    const bool went_alone = state.held_until == Scalar(0);
    return now > Scalar(0) && went_alone && !state.plan.by_momentum && !is_asleep(slot) &&
           Kinematics::is_immovable(actor(slot).body);
  }
  /// Stands where it is, whatever happens to it.
  [[gnu::noinline]] bool is_wall(std::size_t slot) const {
    return Kinematics::is_still(states[slot].plan.motion) &&
           (states[slot].group != kAlone || is_asleep(slot) ||
            Kinematics::is_immovable(actor(slot).body));
  }

  /// Whether a pair that was read names two bodies that are there, in their order. Their capsules
  /// may have been taken off since the step.
  bool has_bodies(ProxyPair pair) const {
    const std::size_t a = body_of(pair.first), b = body_of(pair.second);
    return a < b && actors.at_index(a) != nullptr && actors.at_index(b) != nullptr;
  }
  /// From now on.
  typename Kinematics::Mover mover(int proxy, Scalar until) const;
  /// A capsule where it is now.
  Capsule<Scalar> shape_W(int proxy) const;

  /// The two, and whoever goes with one of them already, go on together (weld.hpp).
  void weld(std::size_t a, std::size_t b, Scalar until);
  /// The same of two of which one is moved by nothing that the other does: for the other, time
  /// stands still. @pre nothing carries that; both are alone, and have come to now
  void hold(std::size_t a, std::size_t b, Scalar until);
  /// Those of the body's group go on alone, from now.
  void part_group(std::size_t slot);
  /// They part then. @pre the group was made now
  void shorten_group(std::size_t slot, Scalar until);
  /// By how much the energy of the turn of the body's group would be off what it was when the group
  /// was made, at a time of the step; of the latter.
  Scalar group_off_flight(std::size_t slot, Scalar time);

  WorldSettings<SceneT> settings;
  StepReport<Scalar> report;
  Pool<ActorType, SceneT::kMaxBodies> actors;
  std::array<BodyState, kSlots> states{};
  Scalar now = 0;           ///< in the step, s
  Scalar dt = 0;            ///< length of the step, s
  bool is_changed = false;  ///< somebody has to be planned anew
  bool is_shifted = false;  ///< in this step somebody was, that nothing may hold
};

template <class SceneT>
bool Bodies<SceneT>::begin(std::size_t slot) {
  BodyState& state = states[slot];
  const bool stood = state.stands;
  state.present = state.stands = state.changed = state.fresh = false;
  state.group = kAlone;
  state.start = state.held_until = 0;
  end_course(*this, slot, dt);
  if constexpr (SceneT::kGravity) {
    state.off_W.setZero();
    state.loaded = false;
  }
  if constexpr (kCarries<SceneT>) static_cast<CarriedState<Scalar>&>(state) = {};
  if constexpr (kCountsHeld<SceneT>) state.held_for = 0;
  if constexpr (kLasts<SceneT>) {
    state.opening = {};
    state.moment_W.setZero();
    state.deepest = 0;
    state.is_held = false;
    state.is_opened = true;
    state.is_capped = false;
    state.was_jammed = false;
  }
  ActorType& actor = actors.at(slot);
  if (!has_valid_features(actor) || !Kinematics::is_usable(actor.body) ||
      !Kinematics::may_turn(actor.body)) {
    ++report.plans_invalid;
    return false;
  }
  state.present = true;
  Kinematics::make_unit(actor.body);
  const bool stayed = stood && Kinematics::is_at_start(actor.body, state.plan.motion);
  begin_motion(*this, slot);
  if constexpr (SceneT::kGravity) {
    if (falls(slot)) {
      Kinematics::add_momentum(actor.body, (dt / actor.body.inverse_mass) * settings.gravity_W);
    }
  }
  return stayed;
}

template <class SceneT>
void Bodies<SceneT>::plan(std::size_t slot) {
  BodyState& state = states[slot];
  state.start = now;
  if (state.group != kAlone) return;
  const ActorType& actor = this->actor(slot);
  const Scalar rest = dt - now;
  if (keeps_course(slot)) return;
  if (is_asleep(slot)) {
    state.plan.motion = Kinematics::standing(actor.body, rest);
    return;
  }
  Kinematics::ask(actor, now, plan_end(slot) - now, state.plan);
  const bool is_known = is_valid(state.plan.motion);
  if (!is_known) go_straight(*this, slot, rest);
  set_course(*this, slot);
  if (!is_known || (SceneT::kGravity && !is_valid(state.plan.motion))) tell_unknown(*this, slot);
}

template <class SceneT>
void Bodies<SceneT>::advance(std::size_t slot, Scalar elapsed) {
  BodyState& state = states[slot];
  if constexpr (SceneT::kGravity) {
    const Scalar whole = dt - state.start;
    const Scalar left = whole > Scalar(0) ? 1 - elapsed / whole : Scalar(0);
    state.off_W *= left;
    if (falls(slot)) state.off_W -= (elapsed * (whole - elapsed) / 2) * settings.gravity_W;
  }
  move_on(*this, slot, elapsed);
  Kinematics::restart(state.plan.motion, actor(slot).body, dt - now);
  state.start = now;
  state.changed = true;
  is_changed = true;
}

template <class SceneT>
void Bodies<SceneT>::finish(std::size_t slot) {
  if constexpr (SceneT::kResponse) {  // else nobody goes with anybody
    if (states[slot].group != kAlone) part_group(slot);
  }
  const BodyState& state = states[slot];
  ActorType& actor = this->actor(slot);
  if (!state.stands && state.start < dt) move_on(*this, slot, dt - state.start);
  if constexpr (kBearsLoads<SceneT>) Kinematics::drop_held(actor.body);
  if constexpr (!kIsFree) actor.controller.on_step_end(actor.body, dt);
}

template <class SceneT>
auto Bodies<SceneT>::twist_now(std::size_t slot) const {
  const BodyState& state = states[slot];
  const auto& body = actor(slot).body;
  auto twist = Kinematics::twist_at(body, state.plan);
  if constexpr (SceneT::kGravity) {
    if (falls(slot)) Kinematics::add_velocity(twist, -((dt - now) * settings.gravity_W));
  }
  return twist;
}

template <class SceneT>
typename KinematicsOf<SceneT>::Mover Bodies<SceneT>::mover(int proxy, Scalar until) const {
  const BodyState& state = states[body_of(proxy)];
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

/// Whether a world takes an actor.
template <class SceneT>
bool may_come(const Actor<SceneT>& actor) {
  using Kinematics = KinematicsOf<SceneT>;
  return has_valid_features(actor) && Kinematics::is_addable(actor.body) &&
         Kinematics::may_come(actor);
}

}  // namespace batuta::detail

#include "batuta/world/detail/course.hpp"
#include "batuta/world/detail/weld.hpp"
