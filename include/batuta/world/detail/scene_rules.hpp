// SPDX-License-Identifier: MIT
#pragma once
// The rules about a scene's options, and the first that they break. What each says:
// scene_check.hpp.

#include "batuta/detection/budget_law.hpp"
#include "batuta/world/scene_options.hpp"

namespace batuta::detail {

/// Rules in the order in which they are looked at.
enum class SceneRule : std::uint8_t {
  kNone,
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
  kMaxBodies,
  kCapsules,
  kMaxPairs,
  kMaxContacts,
  kMaxEvents,
  kMaxSeparations,
  kSweepAxis,
  kSleepTime,
  kFewPairs,
  kStraightSearch,
  kSpheresTurn,
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
  kSleepRest,
  kSleepEvents,
  kSmallRotation,
  kSmallResponse,
  kSmallParts,
  kSmallEvents,
  kSmallBodies,
  kTurnRange,
  kTurnSearch,
  kTurnBudget,
  kLawBudget,
};

/// What the rules ask of a search.
struct SearchTraits {
  bool for_straight_flight = false;
  bool for_spheres = false;
  bool has_tolerance = false;
  std::uint32_t default_budget = 0;
};

constexpr SceneRule broken_capacity(const SceneOptions& scene) {
  using R = SceneRule;
  if (scene.max_bodies < 2 || scene.max_bodies > 65534) return R::kMaxBodies;
  if (scene.capsules_per_body < 1 || scene.capsules_per_body > 255) return R::kCapsules;
  if (scene.max_bodies * scene.capsules_per_body > 65535) return R::kCapsules;
  if (scene.max_pairs < 1) return R::kMaxPairs;
  if (scene.max_contacts < 1) return R::kMaxContacts;
  if (scene.max_events < 0) return R::kMaxEvents;
  if (scene.max_separations < 1) return R::kMaxSeparations;
  if (scene.sweep_axis < 0 || scene.sweep_axis > 2) return R::kSweepAxis;
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
  if (!scene.sleep) return R::kNone;
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
  return scene.max_bodies > 8 ? R::kSmallBodies : R::kNone;
}

constexpr SceneRule broken_by_search(const SceneOptions& scene, const SearchTraits& search) {
  using R = SceneRule;
  const bool is_turn_stated = scene.turn_per_step != 0;
  const bool is_tolerance_stated = scene.contact_tolerance != 0;
  if (!(scene.turn_per_step >= 0 && scene.contact_tolerance >= 0 && scene.contact_tolerance <= 1))
    return R::kTurnRange;
  if (!is_turn_stated && !is_tolerance_stated) return R::kNone;
  if (!search.has_tolerance) return R::kTurnSearch;
  if (!is_turn_stated) return R::kNone;
  const std::uint32_t budget = scene.budget > 0 ? scene.budget : search.default_budget;
  if (budget < kLeastLawBudget) return R::kTurnBudget;
  const bool suffices =
      !is_tolerance_stated || budget_for(scene.turn_per_step, scene.contact_tolerance) <= budget;
  return suffices ? R::kNone : R::kLawBudget;
}

/// The first rule that the options break. The engine comes first: what it cannot do is not to be
/// said in terms of a feature that only the other one has.
constexpr SceneRule broken_rule(const SceneOptions& scene, const SearchTraits& search) {
  SceneRule rule = broken_capacity(scene);
  if (rule == SceneRule::kNone) rule = broken_by_engine(scene);
  if (rule == SceneRule::kNone) rule = broken_by_straight_flight(scene, search);
  if (rule == SceneRule::kNone) rule = broken_by_silence(scene);
  if (rule == SceneRule::kNone) rule = broken_by_rest(scene);
  return rule == SceneRule::kNone ? broken_by_search(scene, search) : rule;
}

}  // namespace batuta::detail
