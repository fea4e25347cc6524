// SPDX-License-Identifier: MIT
#pragma once
// The scene of a duel, and what its features bring: who moves the blades, and which settings there
// are. What a scene leaves out is an empty base (world/actor.hpp).

// First, as in world.hpp.
#include "batuta/world/detail/scene_check.hpp"

#include "batuta/control/stick.hpp"
#include "batuta/fencing/bout.hpp"
#include "batuta/fencing/feet.hpp"
#include "batuta/fencing/grip.hpp"
#include "batuta/fencing/target.hpp"
#include "batuta/world/world.hpp"

namespace batuta::fencing {

/// Capsules of a weapon that collide: blade, guard, hand.
inline constexpr int kWeaponCapsules = 3;

/// The options of a duel of two blades. In a function that returns them, `DuelOptions scene =
/// two_fencers();` and what is different.
struct DuelOptions : SceneOptions {
  /// A weapon is blade, guard and hand. With capsules_per_body = 1 and max_pairs = 1 it is the
  /// blade alone, and passes through guards and hands. Its parts lie on one axis (bent_turns is
  /// off): a weapon that is curved, or heavier on one side, is refused.
  constexpr DuelOptions() {
    capsules_per_body = kWeaponCapsules;
    max_pairs = kWeaponCapsules * kWeaponCapsules;
    max_contacts = 16;
    max_events = 10;
    bent_turns = false;
  }
  /// Blades are held by a grip that a blow loosens [Kavan eq. 32]. Off: each blade is carried by a
  /// Hand, which has whatever strength it takes; Fencer::grip is not looked at.
  batuta::detail::TrueOrFalse grip = true;
  /// Fencers have bodies that can be touched, in a hierarchy of k-DOPs. Off: blades only, nobody
  /// can be touched; Fencer::build is not looked at.
  batuta::detail::TrueOrFalse targets = true;
  /// Fencers advance and retreat on a strip. Off: they stay where they are.
  batuta::detail::TrueOrFalse feet = true;
  /// What a hand feels can be asked for (haptics/hand_force.hpp). Off: Duel::held_hand_W() is
  /// absent, and what needs it: nothing of room haptics is linked.
  batuta::detail::TrueOrFalse haptics = true;
};

/// The options of the standard duel.
constexpr DuelOptions two_fencers() {
  return {};
}

/// The scene of a Duel. Who moves the blades is the duel's own (BladeController).
///   constexpr DuelOptions drill() { DuelOptions scene; scene.targets = false; return scene; }
///   using Drill = DuelScene<drill>;
/// @tparam kOptions  a constexpr function that returns DuelOptions
/// @tparam SearchT  how blades and touches are found: Advancement, or the paper's Stepping to
///   compare it with; its Scalar is the duel's
template <auto kOptions = two_fencers, class SearchT = Advancement<float>>
struct DuelScene
    : batuta::detail::SceneConstants<
          DuelOptions, kOptions, SearchT,
          FreeFlight<typename batuta::detail::SearchScalar<SearchT>::Type>, CoarseBox> {
  /// DuelOptions::grip.
  static constexpr bool kGrip = DuelScene::kStated.grip;
  /// DuelOptions::targets.
  static constexpr bool kTargets = DuelScene::kStated.targets;
  /// DuelOptions::feet.
  static constexpr bool kFeet = DuelScene::kStated.feet;
  /// DuelOptions::haptics.
  static constexpr bool kHaptics = DuelScene::kStated.haptics;
};

}  // namespace batuta::fencing

namespace batuta::detail {

/// @cond
template <auto kOptions, class SearchT>
inline constexpr bool kIsNamedScene<fencing::DuelScene<kOptions, SearchT>> = true;
template <auto kOptions, class SearchT>
inline constexpr bool kIsForDuel<fencing::DuelScene<kOptions, SearchT>> = true;
/// @endcond

}  // namespace batuta::detail

namespace batuta::fencing {

namespace detail {

/// Whether a type is a DuelScene itself, not what is derived from one.
template <class SceneT>
inline constexpr bool kIsDuelScene = false;
/// A DuelScene is.
template <auto kOptions, class SearchT>
inline constexpr bool kIsDuelScene<DuelScene<kOptions, SearchT>> = true;

/// What a scene lacks that a duel asks for.
enum class DuelRule : std::uint8_t {
  kNone,         ///< nothing
  kNoDuelScene,  ///< to be a DuelScene
  kEngine,       ///< the engine in which bodies turn
  kTwoBlades,    ///< two bodies
  kRotation,     ///< bodies that turn
  kParts,        ///< blade, guard and hand, or the blade alone
  kPairs,        ///< room for each pair of their capsules
  kHapticEvents  ///< events, from which a hand learns of blows
};

/// Whether so many capsules are a weapon, or the blade of one.
constexpr bool is_weapon_of(int capsules) {
  return capsules == 1 || capsules == kWeaponCapsules;
}

/// What a duel asks of its scene comes before what every scene is asked.
template <class SceneT>
constexpr DuelRule broken_duel_rule() {
  if constexpr (!kIsDuelScene<SceneT>) {
    return DuelRule::kNoDuelScene;
  } else {
    if (SceneT::kEngine != Engine::kGeneral) return DuelRule::kEngine;
    constexpr int kCapsules = SceneT::kCapsulesPerBody;
    if (SceneT::kMaxBodies != 2) return DuelRule::kTwoBlades;
    if (!SceneT::kRotation) return DuelRule::kRotation;
    if (!is_weapon_of(kCapsules)) return DuelRule::kParts;
    if (SceneT::kMaxPairs != kCapsules * kCapsules) return DuelRule::kPairs;
    const bool is_deaf = SceneT::kHaptics && SceneT::kMaxEvents <= 0;
    return is_deaf ? DuelRule::kHapticEvents : DuelRule::kNone;
  }
}

template <class SceneT, bool kIsKept>
struct PlayedOf {
  using Played = DuelScene<>;
};
template <class SceneT>
struct PlayedOf<SceneT, true> {
  static constexpr bool kIsPossible =
      batuta::detail::KeptScene<SceneT, batuta::detail::broken_rule_of<SceneT>() ==
                                            batuta::detail::SceneRule::kNone>::kIsPossible;
  using Played = std::conditional_t<kIsPossible, SceneT, DuelScene<>>;
};

/// Says what to change. What it answers is in its base: a compiler may leave a class where it finds
/// the first sentence in it.
template <class SceneT>
struct DuelVerdict : PlayedOf<SceneT, broken_duel_rule<SceneT>() == DuelRule::kNone> {
  static constexpr DuelRule kRule = broken_duel_rule<SceneT>();

  static_assert(kRule != DuelRule::kNoDuelScene,
                "Duel: name a DuelScene itself: using Drill = DuelScene<my_options>; my_options is "
                "a constexpr function that returns DuelOptions");
  static_assert(kRule != DuelRule::kEngine, "DuelScene: engine = Engine::kGeneral: blades turn");
  static_assert(kRule != DuelRule::kTwoBlades, "DuelScene: max_bodies = 2: a duel has two blades");
  static_assert(kRule != DuelRule::kRotation, "DuelScene: rotation = true: blades turn");
  static_assert(kRule != DuelRule::kParts,
                "DuelScene: capsules_per_body = 3 (blade, guard, hand) or 1 (the blade alone)");
  static_assert(
      kRule != DuelRule::kPairs,
      "DuelScene: max_pairs = capsules_per_body squared: each may meet each of the other");
  static_assert(kRule != DuelRule::kHapticEvents,
                "DuelScene: haptics takes max_events > 0: events tell the blows that a hand feels");
};

/// What is to be said of it as of any scene, where nothing was said of it as one of a duel.
struct NoVerdict {};
/// SceneVerdict of a scene that a duel takes; else NoVerdict.
template <class SceneT>
using OtherVerdict = std::conditional_t<broken_duel_rule<SceneT>() == DuelRule::kNone,
                                        batuta::detail::SceneVerdict<SceneT>, NoVerdict>;

}  // namespace detail

/// The scene that a duel plays: the one it is given, or the standard one in place of what is
/// refused, so that nothing else is said.
template <class SceneT>
using PlayedScene = typename detail::DuelVerdict<SceneT>::Played;

/// Where a blade was when a contact of the step was resolved, for the touches of the same step.
template <class Scalar>
struct Waypoint {
  Scalar time = 0;    ///< in the step, s
  Pose<Scalar> X_WB;  ///< of the blade then
};

/// When there was no blow in a step, s: beyond the longest of them.
template <class Scalar>
inline constexpr Scalar kNoBlow = Scalar(1);

/// Most corners of a blade's way that are kept in a step. Where more contacts are answered, its way
/// after the last but one is known as a whole only, and touches there are not certain.
inline constexpr int kMostCorners = 8;

/// Parts that a blade does not go into: the world has the weapon's own hand.
inline constexpr PartMask kSteelParts = kAllParts & ~mask_of(BodyPart::kWeaponHand);

/// What stops a blade in a step: the other fencer's body.
template <class Scalar>
struct Steel {
  Target<Scalar>* body = nullptr;  ///< whose start and end of the step are known; outlives the step
  Capsule<Scalar> blade_B;         ///< what does not go in
  Twist<Scalar> came;              ///< of the blade in the step before

  /// The motion that a carrier plans from t on, stopped at the body.
  void stop(const Body<Scalar>& blade, Scalar t, PlannedMotion<Scalar>& planned) const {
    if (body->stop(blade, blade_B, t, kSteelParts, planned.motion)) planned.by_momentum = false;
  }
};

/// The corners of a blade's way in the step.
template <class Scalar, int N>
struct Corners {
  FixedList<Waypoint<Scalar>, N> corners;  ///< in the order of time
  Scalar first_blow = kNoBlow<Scalar>;     ///< when the first blow of the step came, s
  bool is_cut = false;                     ///< there were more than N
  const Steel<Scalar>* steel = nullptr;    ///< within World::step() alone: what stops the blade

  /// The step begins.
  void begin() {
    corners.clear();
    first_blow = kNoBlow<Scalar>;
    is_cut = false;
  }
  /// A contact was answered.
  void keep(const Feedback<Scalar>& feedback, const Pose<Scalar>& X_WB) {
    if (feedback.impulse > Scalar(0)) first_blow = min_of(first_blow, feedback.time);
    if (corners.push({feedback.time, X_WB})) return;
    corners[N - 1] = {feedback.time, X_WB};
    is_cut = true;
  }
};
/// Corners, in a scene whose fencers can be touched.
template <class SceneT>
using CornersOf = batuta::detail::FeatureIf<
    SceneT::kTargets, Corners<typename SceneT::Scalar, min_of(SceneT::kMaxContacts, kMostCorners)>,
    16>;

/// Grip or hand, which remembers the corners of the blade's way where there is somebody to touch.
template <class SceneT>
struct BladeController : CornersOf<SceneT> {
  /// Of lengths and times.
  using Scalar = typename SceneT::Scalar;

  std::conditional_t<SceneT::kGrip, Grip<Scalar>, Hand<Scalar>>
      carrier;  ///< what carries the blade

  /// Takes the blade where it is, at hand_B. @returns kOk | kInvalidArgument (settings)
  Status take(const Pose<Scalar>& X_WB, [[maybe_unused]] const GripSettings<Scalar>& settings,
              [[maybe_unused]] const Vec3<Scalar>& hand_B) {
    place(X_WB);
    if constexpr (SceneT::kGrip) {
      carrier.hold_at(hand_B);
      return carrier.configure(settings);
    }
    return Status::kOk;
  }
  /// Puts hand and blade somewhere, still.
  void place(const Pose<Scalar>& X_WB) {
    if constexpr (SceneT::kGrip) {
      carrier.place(X_WB);
    } else {
      carrier.target_W = X_WB;
    }
  }
  /// Where the blade is wanted at the end of the coming step of length dt. @pre finite; dt > 0
  void command(const Pose<Scalar>& X_WB, Scalar dt) {
    if constexpr (SceneT::kTargets) this->begin();
    if constexpr (SceneT::kGrip) {
      carrier.command(X_WB, dt);
    } else {
      carrier.target_W = X_WB;
      carrier.step = dt;
    }
  }

  /// That of the carrier, stopped at the other's body.
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const {
    PlannedMotion<Scalar> planned = carrier.plan(body, t, duration);
    if constexpr (SceneT::kTargets) {
      if (this->steel != nullptr) this->steel->stop(body, t, planned);
    }
    return planned;
  }
  /// Keeps the corner, and tells the carrier.
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
    if constexpr (SceneT::kTargets) this->keep(feedback, body.X_WB);
    carrier.on_contact(body, feedback);
  }
  /// What the hand has of the weapon: Grip::control(); all of it where a Hand carries it.
  Scalar control() const {
    if constexpr (SceneT::kGrip) return carrier.control();
    return Scalar(1);
  }
  /// Tells the carrier.
  void on_step_end(const Body<Scalar>& body, Scalar dt) { carrier.on_step_end(body, dt); }
};

/// The scene as its world runs it.
template <class SceneT>
struct BladesOf : SceneT {
  /// Grip or hand, by the scene.
  using Controller = BladeController<SceneT>;
};

/// What there is to say about touches.
template <class SceneT>
struct TouchSettings {
  /// Of lengths and times.
  using Scalar = typename SceneT::Scalar;

  /// The bout goes to so many touches of one fencer, 1 ... kMostTouches. Two at once count for
  /// both; where one touch is missing to either, they are annulled, but not in a bout to one touch,
  /// which ends with them.
  std::int32_t touches = 1;
  /// From the end of an exchange until both are on guard again, us, 0 ... 10000000
  std::int32_t halt_us = 1000000;
  /// A second touch within this time counts as double, us, 0 ... 10000000
  std::int32_t double_window_us = 40000;
  /// The end of the blade that touches, m, > 0, at most kLargestReach and the blade: what the rest
  /// meets is none.
  Scalar point_length = Scalar(0.02F);
  /// The point goes into the body along the blade at least so fast, m/s, 0 ... kLargestReach
  Scalar least_speed = Scalar(1);
  /// The hand has its weapon in its power: Grip::control() is no less, 0 ... 1. In a scene without
  /// grip it always has.
  Scalar least_control = Scalar(0.8F);
  /// The grip is no further from where the hand wants it, m, 0 ... kLargestReach
  Scalar largest_slip = Scalar(0.15F);
  /// Search for touches.
  typename SceneT::Search::Options touch = batuta::detail::SearchOf<SceneT>::options();
  PartMask target = kAllParts;  ///< parts where a touch counts: the weapon's convention
};
/// TouchSettings, in a scene whose fencers can be touched.
template <class SceneT>
using TouchSettingsOf = batuta::detail::FeatureIf<SceneT::kTargets, TouchSettings<SceneT>, 17>;

/// The strip on which fencers advance and retreat, its middle that of the salle. Lengths in m.
template <class Scalar>
struct Strip {
  Scalar length = Scalar(14);  ///< between its end lines
  /// The origin of F comes no nearer to the end line behind: the rear foot of a guard stays on the
  /// strip. Nobody leaves it, so that no touch is given for that.
  Scalar end_room = Scalar(0.4F);
  /// The origins of both F come no nearer to each other: trunks and heads of two full lunges are
  /// still apart.
  Scalar least_distance = Scalar(1.5F);
  /// Corps a corps: once both have stood as near as that, or 5 cm further apart, for this long, and
  /// nobody is touched, there is a halt without a touch, us, 0 ... 10000000. 0: never. In a scene
  /// with targets. Where Salle::distance is no more than that, each exchange ends so.
  std::int32_t corps_a_corps_us = 2000000;
};

/// What there is to say about feet.
template <class SceneT>
struct FootworkSettings {
  FeetSettings<typename SceneT::Scalar> feet;  ///< of both fencers
  Strip<typename SceneT::Scalar> strip;        ///< where they walk
};
/// FootworkSettings, in a scene whose fencers have feet.
template <class SceneT>
using FootworkSettingsOf = batuta::detail::FeatureIf<SceneT::kFeet, FootworkSettings<SceneT>, 18>;

}  // namespace batuta::fencing

namespace batuta::detail {

template <class SceneT>
struct SceneVerdict<fencing::BladesOf<SceneT>> : SceneVerdict<SceneT> {
  using Seen = fencing::BladesOf<SceneT>;
};

}  // namespace batuta::detail

namespace batuta::fencing {

/// What a duel can be told.
/// @tparam SceneT  a DuelScene
template <class SceneT = DuelScene<>>
struct DuelSettings : TouchSettingsOf<typename detail::DuelVerdict<SceneT>::Played>,
                      FootworkSettingsOf<PlayedScene<SceneT>> {
  std::int32_t step_us = 1000;                         ///< length of a step, us, 100 ... 20000
  StickSettings stick;                                 ///< of both sticks
  WorldSettings<BladesOf<PlayedScene<SceneT>>> world;  ///< blades: defaults of duel_settings()
  Salle<typename PlayedScene<SceneT>::Scalar> salle;   ///< where the fencers stand
};

/// Settings that suit the two fencers of the library. For a scene of one's own, include
/// fencing/duel_definitions.hpp.
template <class SceneT = DuelScene<>>
DuelSettings<SceneT> duel_settings();

}  // namespace batuta::fencing
