// SPDX-License-Identifier: MIT
#pragma once
// A scene is a type: what it holds and what it answers are constants of it, so that memory and the
// longest step are known when it is compiled. Derive, and hide what is different:
//   struct MyScene : batuta::Scene { static constexpr int kMaxBodies = 8; };

#include "batuta/detection/budget_law.hpp"
#include "batuta/detection/search.hpp"
#include "batuta/world/bound.hpp"
#include "batuta/world/controller.hpp"

namespace batuta {

/// What a scene does about contacts in which nearly nothing approaches [Kavan §4.2].
enum class RestingContact : std::uint8_t {
  /// Nothing: every approaching contact is answered by an impulse, however slow.
  kNone,
  /// The paper's: the bodies are moved apart to D and stand still for f(D). For what a controller
  /// holds.
  kSeparation,
  /// For bodies that lie on each other: what is left of the approach is taken out by an impulse
  /// without restitution, the gap is restored to D, and nobody stands still. The kMaxSeparations-th
  /// answer of a pair in a step, of whatever kind, is without restitution and freezes the pair for
  /// the rest of it.
  kSettling,
};

/// A scene with everything at its default: two capsules with impulses and the paper's separation.
struct Scene {
  /// Of lengths, times and everything else: float, or double where the library was built for it.
  using Scalar = float;
  /// Who moves a body; see controller.hpp. Not asked where kRotation is false: there, bodies fly by
  /// their momenta.
  using Controller = FreeFlight<float>;
  /// How contacts are found: Advancement (never misses), Translation (the same where nothing turns)
  /// or Stepping (the paper's); see detection/search.hpp. The others are not linked.
  using Search = Advancement<float>;

  // Capacities.
  /// Bodies at the same time, 2 ... 1024.
  static constexpr int kMaxBodies = 2;
  /// Capsules of one body, 1 ... 255. One: Actor::capsule_B; more: Actor::capsules_B.
  static constexpr int kCapsulesPerBody = 1;
  /// Pairs of capsules whose swept volumes may meet at the same time. Where more do, the bodies of
  /// the surplus pairs are held for the rest of the step, and counted.
  static constexpr int kMaxPairs = 1;
  /// Contacts answered in one step. Where more happen, the bodies concerned are held for the rest
  /// of it, and counted.
  static constexpr int kMaxContacts = 8;
  /// Events kept for reading after a step; a surplus is counted. 0: none, and no pair is followed.
  static constexpr int kMaxEvents = 16;
  /// Answers of one pair in one step, the last of which freezes it (kSettling).
  static constexpr int kMaxSeparations = 4;
  /// Steps in which a body must not go further than at rest_speed to be put to sleep (kSleep), 1
  /// ... 65535.
  static constexpr int kSleepSteps = 250;

  // Features. What is off is absent: no member, no code.
  /// Bodies turn. Off: StraightBody, no quaternion, no inertia; Search is Translation or Spheres.
  static constexpr bool kRotation = true;
  /// Contacts change the bodies. Off: they are found and told, and everybody moves on.
  static constexpr bool kResponse = true;
  /// Actor::restitution. Off: C = 0.
  static constexpr bool kRestitution = true;
  /// Actor::friction: Coulomb's law, sticking or sliding (response/friction.hpp).
  static constexpr bool kFriction = false;
  /// Near-parallel capsules touch at two points (response/line_contact.hpp).
  static constexpr bool kLineContact = false;
  /// What becomes of contacts in which nearly nothing approaches.
  static constexpr RestingContact kResting = RestingContact::kSeparation;
  /// WorldSettings::gravity_W, felt by what its own momentum moves.
  static constexpr bool kGravity = false;
  /// What has not left its place for a while is put to sleep until something happens to it.
  static constexpr bool kSleep = false;
  /// Actor::owner: bodies of one owner never meet.
  static constexpr bool kOwners = true;
  /// Actor::filter: who may meet whom.
  static constexpr bool kFilters = false;
  // Of the fencing application (fencing/duel.hpp), for a scene that a Duel runs.
  /// Blades are held by a grip that a blow loosens [Kavan eq. 32].
  static constexpr bool kGrip = false;
  /// Fencers have bodies that can be touched, in a hierarchy of k-DOPs.
  static constexpr bool kTargets = false;
  /// What a hand feels can be asked for (haptics/hand_force.hpp).
  static constexpr bool kHaptics = false;

  // Searching.
  /// What holds a capsule over a step: SweptBox (exact) or CoarseBox; see bound.hpp.
  using Bound = SweptBox;
  /// The axis along which a scene is longest, 0 ... 2: boxes are kept in order along it.
  static constexpr int kSweepAxis = 0;
  /// Distance evaluations of one search. Where they do not suffice, the bodies are held, and
  /// counted.
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
  // A scene may state two of kTurnPerStep, kContactTolerance and kBudget; detection/budget_law.hpp
  // gives the third.
  /// Furthest that a body turns in a step, rad; 0: not stated.
  static constexpr float kTurnPerStep = 0;
  /// A gap of kContactTolerance S counts as contact (MovingPair::scale); 0: not stated, then what
  /// the law asks for, and no less than the search's own default.
  static constexpr float kContactTolerance = 0;
};

/// What the members of a world do not show of its scene, for the fingerprint of what is saved.
template <class SceneT, class Archive>
void archive_scene(Archive& ar) {
  ar.constant(static_cast<std::uint32_t>(SceneT::kMaxContacts));
  ar.constant(static_cast<std::uint32_t>(SceneT::kMaxSeparations));
  ar.constant(static_cast<std::uint32_t>(SceneT::kSleepSteps));
  ar.constant(static_cast<std::uint32_t>(SceneT::kBudget));
  ar.constant(static_cast<std::uint32_t>(SceneT::kResting));
  ar.constant(SceneT::Search::kNumber);
  constexpr std::uint32_t kFlags = (SceneT::kRotation ? 1U : 0U) | (SceneT::kResponse ? 2U : 0U) |
                                   (SceneT::kLineContact ? 4U : 0U) | (SceneT::kGravity ? 8U : 0U);
  ar.constant(kFlags);
}

/// What a scene asks of its searches.
template <class SceneT>
struct SearchOf {
  /// The scene's.
  using Scalar = typename SceneT::Scalar;
  /// The scene's.
  using Search = typename SceneT::Search;
  /// What one search needs to know.
  using Options = typename Search::Options;

  static_assert(std::is_same_v<typename Search::Scalar, Scalar>,
                "Scene::Search: name it with the scene's Scalar");
  static_assert(SceneT::kTurnPerStep >= 0 && SceneT::kContactTolerance >= 0 &&
                    SceneT::kContactTolerance <= 1,
                "Scene: kTurnPerStep is at least 0, kContactTolerance 0 ... 1");
  static_assert(Search::kHasContactTolerance ||
                    (SceneT::kContactTolerance == 0 && SceneT::kTurnPerStep == 0),
                "Scene: kContactTolerance and kTurnPerStep have a meaning for Advancement and "
                "Translation only");
  static_assert(SceneT::kTurnPerStep == 0 || SceneT::kBudget >= kLeastLawBudget,
                "Scene: kTurnPerStep takes a kBudget of at least 8");
  static_assert(SceneT::kContactTolerance == 0 || SceneT::kTurnPerStep == 0 ||
                    budget_for(SceneT::kTurnPerStep, SceneT::kContactTolerance) <= SceneT::kBudget,
                "Scene: kBudget does not suffice for this kTurnPerStep and kContactTolerance; "
                "budget_for(turn, contact_tolerance) tells what does");

  /// Options that spend the scene's budget.
  static constexpr Options options() {
    const Scalar stated = static_cast<Scalar>(SceneT::kContactTolerance);
    const Scalar asked =
        contact_tolerance_for(static_cast<Scalar>(SceneT::kTurnPerStep), SceneT::kBudget);
    if constexpr (Search::kHasContactTolerance) {
      const Scalar own = Options{}.contact_tolerance;
      return Search::options(SceneT::kBudget, stated > Scalar(0) ? stated : max_of(own, asked));
    } else {
      return Search::options(SceneT::kBudget, Scalar(0));
    }
  }
};

/// Tolerances of contacts that rest, and of when a contact ends.
template <class Scalar>
struct RestSettings {
  /// eps_r [Kavan §4], m/s, > 0. With gravity, what a body gains by falling for two steps or
  /// through 4 D counts as rest as well.
  Scalar rest_speed = Scalar(0.01);
  Scalar separation = Scalar(1e-4);  ///< D [Kavan §4.2], m, > 0; a contact ends beyond 2 D
  Scalar min_separation_time = Scalar(1e-4);  ///< least f(D), s, > 0
};
/// What pulls at every body, in a scene with kGravity.
template <class Scalar>
struct GravitySettings {
  Vec3<Scalar> gravity_W = {0, 0, Scalar(-9.81)};  ///< m/s^2, finite
};
/// What stands in the place of a feature that a scene leaves out; numbers keep the types apart, so
/// that none takes room.
template <int kNumber>
struct Absent {};

/// Scenes that tell resting contacts from others, or follow contacts to their end.
template <class SceneT>
inline constexpr bool kKnowsRest =
    SceneT::kResting != RestingContact::kNone || SceneT::kMaxEvents > 0;

/// The tolerances of a world, SI units, all relative to what the scene's user knows.
template <class SceneT>
struct WorldSettings
    : std::conditional_t<kKnowsRest<SceneT>, RestSettings<typename SceneT::Scalar>, Absent<0>>,
      std::conditional_t<SceneT::kGravity, GravitySettings<typename SceneT::Scalar>, Absent<1>> {
  /// The scene's.
  using Scalar = typename SceneT::Scalar;

  /// Those of the scene's search, within Scene::kBudget evaluations.
  typename SceneT::Search::Options search = SearchOf<SceneT>::options();
};

/// Whether settings are in range.
/// @returns kOk | kInvalidArgument: an option out of its range, or a search that may take more than
/// Scene::kBudget evaluations
template <class SceneT>
Status validate(const WorldSettings<SceneT>& settings) {
  bool good = validate(settings.search) == Status::kOk &&
              SceneT::Search::most_evaluations(settings.search) <= SceneT::kBudget;
  if constexpr (kKnowsRest<SceneT>) {
    good = good && is_positive(settings.rest_speed) && is_positive(settings.separation) &&
           is_positive(settings.min_separation_time);
  }
  if constexpr (SceneT::kGravity) good = good && is_finite(settings.gravity_W);
  return good ? Status::kOk : Status::kInvalidArgument;
}

}  // namespace batuta
