// SPDX-License-Identifier: MIT
#pragma once
// What no scene can be, each with what to change. World, Actor and WorldSettings look at their
// scene here, once; the first rule that it breaks is said, and none after it. What is refused gets
// stand-ins (refused_scene.hpp), so that nothing else is said.

#include "batuta/world/detail/controller_check.hpp"
#include "batuta/world/detail/refused_scene.hpp"
#include "batuta/world/detail/scene_rules.hpp"

namespace batuta::detail {

template <class SearchT, class ControllerT>
constexpr SearchTraits traits_of() {
  return {SearchT::kForStraightFlight,
          SearchT::kForSpheres,
          SearchT::kHasContactTolerance,
          std::is_same_v<ControllerT, FreeFlight<typename SearchT::Scalar>>,
          SearchT::kDefaultBudget,
          SearchT::kLeastBudget};
}

template <class ControllerT, class Scalar>
constexpr SceneRule broken_by_controller() {
  switch (ControllerCheck<ControllerT, Scalar>::fault()) {
    case ControllerFault::kScalar:
      return SceneRule::kControllerScalar;
    case ControllerFault::kPlan:
      return SceneRule::kControllerPlan;
    case ControllerFault::kContact:
      return SceneRule::kControllerContact;
    case ControllerFault::kStepEnd:
      return SceneRule::kControllerStepEnd;
    case ControllerFault::kNone:
      break;
  }
  return SceneRule::kNone;
}

template <class BoundT, class Scalar, class = void>
inline constexpr bool kIsBound = false;
template <class BoundT, class Scalar>
inline constexpr bool kIsBound<
    BoundT, Scalar,
    std::enable_if_t<std::is_same_v<
        Aabb<Scalar>, decltype(BoundT::of(std::declval<const MovingCapsule<Scalar>&>()))>>> = true;

/// What names a scene itself: the class templates of the library whose arguments are options.
template <class SceneT>
inline constexpr bool kIsNamedScene = false;
template <auto kOptions, class SearchT, class ControllerT, class BoundT>
inline constexpr bool kIsNamedScene<Scene<kOptions, SearchT, ControllerT, BoundT>> = true;

/// Whether a scene is for a Duel, which makes a world of it that a World alone is not.
template <class SceneT>
inline constexpr bool kIsForDuel = false;

/// The first rule that a scene breaks.
template <class SceneT>
constexpr SceneRule broken_rule_of() {
  if constexpr (std::is_const_v<SceneT> || std::is_volatile_v<SceneT>) {
    return SceneRule::kConst;
  } else if constexpr (!kIsNamedScene<SceneT>) {
    return std::is_base_of_v<SceneMark, SceneT> ? SceneRule::kDerived : SceneRule::kNoScene;
  } else if constexpr (!SceneT::kHasOptionsFunction) {
    return SceneRule::kNoOptions;
  } else if constexpr (!kIsSearch<typename SceneT::Search>) {
    return SceneRule::kNoSearch;
  } else if constexpr (!kIsScalar<typename SceneT::Scalar>) {
    return SceneRule::kScalar;
  } else if constexpr (constexpr SceneRule kBroken =
                           broken_by_controller<typename SceneT::Controller,
                                                typename SceneT::Scalar>();
                       kBroken != SceneRule::kNone) {
    return kBroken;
  } else if constexpr (!kIsBound<typename SceneT::Bound, typename SceneT::Scalar>) {
    return SceneRule::kBound;
  } else {
    return broken_rule(SceneT::kStated,
                       traits_of<typename SceneT::Search, typename SceneT::Controller>());
  }
}

enum class WorldKind : std::uint8_t { kRefused, kGeneral, kSmall };

/// Where the compiler can call the options function; see OptionsSpeak for where it cannot.
template <class SceneT, bool kIsKept>
struct KeptScene : SceneT::Speak {
  static constexpr bool kIsPossible = SceneT::kHasOptions;
  static constexpr WorldKind kKind = !kIsPossible                        ? WorldKind::kRefused
                                     : SceneT::kEngine == Engine::kSmall ? WorldKind::kSmall
                                                                         : WorldKind::kGeneral;
  using Seen = std::conditional_t<kIsPossible, SceneT, RefusedScene<SceneT>>;
};
template <class SceneT>
struct KeptScene<SceneT, false> {
  static constexpr bool kIsPossible = false;
  static constexpr WorldKind kKind = WorldKind::kRefused;
  using Seen = RefusedScene<SceneT>;
};

template <class SceneT>
struct SceneVerdict : KeptScene<SceneT, broken_rule_of<SceneT>() == SceneRule::kNone> {
  using R = SceneRule;
  static constexpr SceneRule kRule = broken_rule_of<SceneT>();

  static_assert(kRule != R::kConst, "World: name its scene without const or volatile");
  static_assert(
      kRule != R::kDerived,
      "World: name the scene itself: using MyScene = Scene<my_options>; nobody reads what "
      "a struct that is derived from a scene adds");
  static_assert(kRule != R::kNoScene,
                "World: its scene is a Scene: using MyScene = Scene<my_options>; my_options is a "
                "constexpr function that returns SceneOptions");
  static_assert(kRule != R::kNoOptions,
                "Scene: its first argument is a constexpr function that returns SceneOptions; that "
                "of a DuelScene, one that returns DuelOptions");
  static_assert(kRule != R::kNoSearch,
                "Scene: its second argument is a search: Advancement<float>, Translation<float>, "
                "Spheres<float> or Stepping<float>, or of double");
  static_assert(kRule != R::kScalar, "Scene: its search is one of float or double");
  static_assert(
      kRule != R::kControllerScalar,
      "Scene: its controller and its search take different scalars; name both with float, or "
      "both with double");
  static_assert(
      kRule != R::kControllerPlan,
      "Scene: its controller lacks PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, "
      "Scalar duration) const");
  static_assert(kRule != R::kControllerContact,
                "Scene: its controller lacks void on_contact(const Body<Scalar>& body, const "
                "Feedback<Scalar>& feedback)");
  static_assert(
      kRule != R::kControllerStepEnd,
      "Scene: its controller lacks void on_step_end(const Body<Scalar>& body, Scalar dt)");
  static_assert(kRule != R::kBound, "Scene: its fourth argument is SweptBox or CoarseBox");

  static_assert(
      kRule != R::kRestOfOthers,
      "Scene: its options lost what DuelOptions add: let the function return DuelOptions, "
      "for a DuelScene");
  static_assert(kRule != R::kEngine, "Scene: engine: choose Engine::kGeneral or Engine::kSmall");
  static_assert(kRule != R::kResting,
                "Scene: resting: choose RestingContact::kNone, kSeparation or kSettling");
  static_assert(kRule != R::kMaxBodies, "Scene: max_bodies: choose 2 ... 65534");
  static_assert(
      kRule != R::kCapsules,
      "Scene: capsules_per_body: choose 1 ... 255, and no more than 65535 capsules in all");
  static_assert(kRule != R::kMaxPairs, "Scene: max_pairs: choose 1 ... 65535");
  static_assert(kRule != R::kMaxContacts, "Scene: max_contacts: choose 1 ... 65535");
  static_assert(kRule != R::kMaxEvents, "Scene: max_events: choose 0 ... 65535");
  static_assert(kRule != R::kMaxSeparations, "Scene: max_separations: choose 1 ... 65535");
  static_assert(kRule != R::kSweepAxis, "Scene: sweep_axis: choose 0, 1 or 2");
  static_assert(kRule != R::kSleepTime, "Scene: sleep_time: choose a time above 0, at most 60 s");
  static_assert(kRule != R::kBudget,
                "Scene: budget: choose 1 ... 4096 (of Stepping, its halvings + 2 ... 1000000000), "
                "or 0 for the search's own");
  static_assert(kRule != R::kFewPairs,
                "Scene: max_pairs: at least max_bodies / 2, so that each body can be near another");

  static_assert(kRule != R::kStraightSearch,
                "Scene: without rotation, the search is Translation<Scalar> or Spheres<Scalar>");
  static_assert(kRule != R::kStraightController,
                "Scene: without rotation, bodies fly by their momenta and ask no controller: leave "
                "it out, or FreeFlight<Scalar>");
  static_assert(kRule != R::kSpheresTurn, "Scene: Spheres<Scalar> takes rotation = false");
  static_assert(kRule != R::kSpheresBudget,
                "Scene: Spheres<Scalar> takes one evaluation: leave out budget");
  static_assert(kRule != R::kSpheresParts, "Scene: Spheres<Scalar> takes capsules_per_body = 1");
  static_assert(
      kRule != R::kStraightRest,
      "Scene: without rotation, set resting = RestingContact::kNone; slow contacts are answered by "
      "impulses");
  static_assert(kRule != R::kStraightFriction,
                "Scene: friction takes rotation = true: a contact that rubs turns what it touches");
  static_assert(kRule != R::kStraightLine,
                "Scene: line_contact takes rotation = true: where nothing turns, one point does");
  static_assert(kRule != R::kSilentRestitution,
                "Scene: without response, set restitution = false as well");
  static_assert(kRule != R::kSilentFriction,
                "Scene: without response, set friction = false as well");
  static_assert(kRule != R::kSilentLine,
                "Scene: without response, set line_contact = false as well");
  static_assert(kRule != R::kSilentRest,
                "Scene: without response, set resting = RestingContact::kNone as well");
  static_assert(kRule != R::kSilentEvents,
                "Scene: without response, set max_events > 0: events are all there is to see");
  static_assert(
      kRule != R::kFrictionSeparation,
      "Scene: friction takes resting = RestingContact::kSettling (or kNone): a separation pushes "
      "nothing that could rub");
  static_assert(kRule != R::kRollingRest,
                "Scene: rolling_resistance takes friction = true and resting = "
                "RestingContact::kSettling");
  static_assert(kRule != R::kRestless,
                "Scene: max_separations takes resting = RestingContact::kSettling");
  static_assert(kRule != R::kSleepless, "Scene: sleep_time takes sleep = true");
  static_assert(kRule != R::kSleepRest, "Scene: sleep takes resting = RestingContact::kSettling");
  static_assert(kRule != R::kSleepEvents,
                "Scene: sleep takes max_events > 0: what a sleeper lies on has to be followed");

  static_assert(kRule != R::kSmallRotation,
                "Scene: Engine::kSmall takes rotation = false; what turns takes Engine::kGeneral");
  static_assert(kRule != R::kSmallResponse,
                "Scene: Engine::kSmall takes response = true; detection only takes "
                "Engine::kGeneral");
  static_assert(kRule != R::kSmallParts,
                "Scene: Engine::kSmall takes capsules_per_body = 1; more take Engine::kGeneral");
  static_assert(kRule != R::kSmallEvents,
                "Scene: Engine::kSmall takes max_events = 0; events take Engine::kGeneral");
  static_assert(kRule != R::kSmallBodies,
                "Scene: Engine::kSmall takes max_bodies of at most 8; more take Engine::kGeneral");

  static_assert(kRule != R::kSmallPairs,
                "Scene: Engine::kSmall has room for all pairs: leave out max_pairs");
  static_assert(kRule != R::kSmallAxis,
                "Scene: Engine::kSmall keeps no boxes in order: leave out sweep_axis");

  static_assert(
      kRule != R::kTurnRange,
      "Scene: turn_per_step: choose 0 ... 3.14 (half a turn); contact_tolerance: 0 ... 1");
  static_assert(kRule != R::kTurnStraight, "Scene: turn_per_step takes rotation = true");
  static_assert(kRule != R::kTurnSearch,
                "Scene: contact_tolerance and turn_per_step have a meaning for Advancement and "
                "Translation only");
  static_assert(kRule != R::kTurnBudget, "Scene: turn_per_step takes a budget of at least 8");
  static_assert(kRule != R::kLawBudget,
                "Scene: budget does not suffice for this turn_per_step and contact_tolerance; "
                "budget_for(turn, "
                "contact_tolerance) tells what does");
};

/// Whether a type is a scene, and one that can be: says what to change where it is not.
template <class SceneT>
inline constexpr bool kIsPossibleScene = detail::SceneVerdict<SceneT>::kIsPossible;

/// The scene, or what stands in for one that is refused.
template <class SceneT>
using SceneFor = typename detail::SceneVerdict<SceneT>::Seen;
template <class SceneT>
using ScalarFor = typename SceneFor<SceneT>::Scalar;

}  // namespace batuta::detail
