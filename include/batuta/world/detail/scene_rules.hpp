// SPDX-License-Identifier: MIT
#pragma once
// The rules about a scene's options, and the first that they break. What each says:
// scene_check.hpp.

#include "batuta/detection/advancement.hpp"
#include "batuta/detection/budget_law.hpp"
#include "batuta/world/scene_options.hpp"

namespace batuta::detail {

/// Rules, those of one subject together. broken_rule() has the order in which they are looked at.
enum class SceneRule : std::uint8_t {
  kNone,
  kConst,
  kDerived,
  kNoScene,
  kNoOptions,
  kNoSearch,
  kScalar,
  kControllerScalar,
  kControllerPlan,
  kControllerContact,
  kControllerStepEnd,
  kBound,
  kRestOfOthers,
  kEngine,
  kResting,
  kMaxBodies,
  kCapsules,
  kMaxPairs,
  kMaxContacts,
  kMaxEvents,
  kMaxSeparations,
  kSweepAxis,
  kSleepTime,
  kBudget,
  kFewPairs,
  kStraightController,
  kStraightSearch,
  kSpheresTurn,
  kSpheresBudget,
  kSpheresParts,
  kStraightRest,
  kStraightFriction,
  kStraightLine,
  kSilentRestitution,
  kSilentFriction,
  kSilentLine,
  kSilentRest,
  kSilentEvents,
  kFrictionSeparation,
  kRollingRest,
  kSleepless,
  kRestless,
  kSleepRest,
  kSleepEvents,
  kSmallRotation,
  kSmallResponse,
  kSmallParts,
  kSmallEvents,
  kSmallBodies,
  kSmallPairs,
  kSmallAxis,
  kTurnRange,
  kTurnStraight,
  kTurnSearch,
  kTurnBudget,
  kLawBudget,
};

/// What the rules ask of a search, and of the controller beside it.
struct SearchTraits {
  bool for_straight_flight = false;
  bool for_spheres = false;
  bool has_tolerance = false;
  bool has_free_flight = false;  ///< the controller beside it is the one that a scene has by itself
  std::uint32_t default_budget = 0;
  std::uint32_t least_budget = 0;
};

/// Most pairs, contacts, events and contacts of one pair: what a 16-bit index can name.
inline constexpr int kMostEntries = 65535;
/// Most steps of Stepping: ten times what batuta-answer gives it.
inline constexpr int kMostSteps = 1000000000;
/// Most that a body is told to turn in a step, rad: half a turn.
inline constexpr float kMostTurn = 3.1415927F;

constexpr bool is_within(int low, int x, int high) {
  return low <= x && x <= high;
}
constexpr bool is_within(float low, float x, float high) {
  return low <= x && x <= high;
}

/// Options as they were stated, with enumerators, not numbers that were cast.
constexpr SceneRule broken_choice(const SceneOptions& scene) {
  using R = SceneRule;
  if (scene.is_rest_of_others) return R::kRestOfOthers;
  if (scene.engine != Engine::kGeneral && scene.engine != Engine::kSmall) return R::kEngine;
  const bool is_known = scene.resting == RestingContact::kNone ||
                        scene.resting == RestingContact::kSeparation ||
                        scene.resting == RestingContact::kSettling;
  return is_known ? R::kNone : R::kResting;
}

constexpr SceneRule broken_capacity(const SceneOptions& scene) {
  using R = SceneRule;
  if (!is_within(2, scene.max_bodies, 65534)) return R::kMaxBodies;
  if (!is_within(1, scene.capsules_per_body, 255)) return R::kCapsules;
  if (scene.max_bodies * scene.capsules_per_body > 65535) return R::kCapsules;
  if (!is_within(1, scene.max_pairs, kMostEntries)) return R::kMaxPairs;
  if (!is_within(1, scene.max_contacts, kMostEntries)) return R::kMaxContacts;
  if (!is_within(0, scene.max_events, kMostEntries)) return R::kMaxEvents;
  if (!is_within(1, scene.max_separations, kMostEntries)) return R::kMaxSeparations;
  if (!is_within(0, scene.sweep_axis, 2)) return R::kSweepAxis;
  if (!(scene.sleep_time > 0 && scene.sleep_time <= 60)) return R::kSleepTime;
  const bool has_few = scene.max_pairs < scene.max_bodies / 2;
  return has_few && scene.engine == Engine::kGeneral ? R::kFewPairs : R::kNone;
}

constexpr SceneRule broken_by_straight_flight(const SceneOptions& scene,
                                              const SearchTraits& search) {
  using R = SceneRule;
  if (search.for_spheres && scene.rotation) return R::kSpheresTurn;
  if (search.for_spheres && scene.capsules_per_body != 1) return R::kSpheresParts;
  if (scene.rotation) return R::kNone;
  if (!search.for_straight_flight) return R::kStraightSearch;
  if (!search.has_free_flight) return R::kStraightController;
  if (scene.resting != RestingContact::kNone) return R::kStraightRest;
  if (scene.friction) return R::kStraightFriction;
  return scene.line_contact ? R::kStraightLine : R::kNone;
}

constexpr SceneRule broken_by_silence(const SceneOptions& scene) {
  using R = SceneRule;
  if (scene.response) return R::kNone;
  if (scene.restitution) return R::kSilentRestitution;
  if (scene.friction) return R::kSilentFriction;
  if (scene.line_contact) return R::kSilentLine;
  if (scene.resting != RestingContact::kNone) return R::kSilentRest;
  return scene.max_events > 0 ? R::kNone : R::kSilentEvents;
}

constexpr SceneRule broken_by_rest(const SceneOptions& scene) {
  using R = SceneRule;
  const bool separates = scene.resting == RestingContact::kSeparation;
  if (scene.friction && separates) return R::kFrictionSeparation;
  const bool settles = scene.resting == RestingContact::kSettling;
  if (scene.rolling_resistance && !(scene.friction && settles)) return R::kRollingRest;
  if (!settles && scene.max_separations != SceneOptions().max_separations) return R::kRestless;
  if (!scene.sleep)
    return !(scene.sleep_time < SceneOptions().sleep_time ||
             scene.sleep_time > SceneOptions().sleep_time)
               ? R::kNone
               : R::kSleepless;
  if (scene.resting != RestingContact::kSettling) return R::kSleepRest;
  return scene.max_events > 0 ? R::kNone : R::kSleepEvents;
}

constexpr SceneRule broken_by_engine(const SceneOptions& scene) {
  using R = SceneRule;
  if (scene.engine != Engine::kSmall) return R::kNone;
  if (scene.rotation) return R::kSmallRotation;
  if (!scene.response) return R::kSmallResponse;
  if (scene.capsules_per_body != 1) return R::kSmallParts;
  if (scene.max_events != 0) return R::kSmallEvents;
  if (scene.max_bodies > 8) return R::kSmallBodies;
  if (scene.max_pairs != SceneOptions().max_pairs) return R::kSmallPairs;
  return scene.sweep_axis == 0 ? R::kNone : R::kSmallAxis;
}

constexpr SceneRule broken_budget(const SceneOptions& scene, const SearchTraits& search) {
  if (scene.budget == 0) return SceneRule::kNone;
  if (search.for_spheres) return SceneRule::kSpheresBudget;
  const int least = static_cast<int>(search.least_budget);
  const int most = search.has_tolerance ? static_cast<int>(kMaxBudget) : kMostSteps;
  return is_within(least, scene.budget, most) ? SceneRule::kNone : SceneRule::kBudget;
}

/// Of turn and contact tolerance, and what the law asks of the budget for them.
constexpr SceneRule broken_law(const SceneOptions& scene, const SearchTraits& search) {
  using R = SceneRule;
  if (!is_within(0.0F, scene.turn_per_step, kMostTurn)) return R::kTurnRange;
  if (!is_within(0.0F, scene.contact_tolerance, 1.0F)) return R::kTurnRange;
  const bool is_turn_stated = scene.turn_per_step != 0;
  const bool is_tolerance_stated = scene.contact_tolerance != 0;
  if (is_turn_stated && !scene.rotation) return R::kTurnStraight;
  if (!is_turn_stated && !is_tolerance_stated) return R::kNone;
  if (!search.has_tolerance) return R::kTurnSearch;
  if (!is_turn_stated) return R::kNone;
  const std::uint32_t budget =
      scene.budget > 0 ? static_cast<std::uint32_t>(scene.budget.value) : search.default_budget;
  if (budget < kLeastLawBudget) return R::kTurnBudget;
  const bool suffices =
      !is_tolerance_stated || budget_for(scene.turn_per_step, scene.contact_tolerance) <= budget;
  return suffices ? R::kNone : R::kLawBudget;
}

/// The first rule that the options break. The engine comes first: what it cannot do is not to be
/// said in terms of a feature that only the other one has.
constexpr SceneRule broken_rule(const SceneOptions& scene, const SearchTraits& search) {
  SceneRule rule = broken_choice(scene);
  if (rule == SceneRule::kNone) rule = broken_capacity(scene);
  if (rule == SceneRule::kNone) rule = broken_by_engine(scene);
  if (rule == SceneRule::kNone) rule = broken_by_straight_flight(scene, search);
  if (rule == SceneRule::kNone) rule = broken_by_silence(scene);
  if (rule == SceneRule::kNone) rule = broken_by_rest(scene);
  if (rule == SceneRule::kNone) rule = broken_budget(scene, search);
  return rule == SceneRule::kNone ? broken_law(scene, search) : rule;
}

}  // namespace batuta::detail
