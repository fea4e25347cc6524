// SPDX-License-Identifier: MIT
#pragma once
// A scene is a type: what it holds and what it answers are constants of it, so that memory and the
// longest step are known when it is compiled. Derive, and hide what is different:
//   struct MyScene : batuta::Scene { static constexpr int kMaxBodies = 8; };

#include "batuta/detection/budget_law.hpp"
#include "batuta/detection/search.hpp"
#include "batuta/world/driver.hpp"

namespace batuta {

struct Scene {
  using Scalar = float;
  /// Who moves a body; see driver.hpp.
  using Driver = FreeFlight<float>;
  /// How contacts are found: Advancement (never misses), Translation (the same where nothing turns)
  /// or Stepping (the paper's); see detection/search.hpp. The others are not linked.
  using Search = Advancement<float>;
  /// Bodies at the same time, 2 ... 1024.
  static constexpr int kMaxBodies = 2;
  /// Pairs whose swept volumes may meet at the same time. Where more do, the bodies of the surplus
  /// pairs are held for the rest of the step, and counted.
  static constexpr int kMaxPairs = 1;
  /// Contacts answered in one step. Where more happen, the bodies concerned are held for the rest
  /// of it, and counted.
  static constexpr int kMaxContacts = 8;
  /// Events kept for reading after a step; a surplus is counted.
  static constexpr int kMaxEvents = 16;
  /// Distance evaluations of one search. Where they do not suffice, the bodies are held, and
  /// counted.
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
  // A scene may state two of kTurnPerStep, kSlab and kBudget; detection/budget_law.hpp gives the
  // third.
  /// Furthest that a body turns in a step, rad; 0: not stated.
  static constexpr float kTurnPerStep = 0;
  /// A gap of kSlab S counts as contact (MovingPair::scale); 0: not stated, then what the law asks
  /// for, and no less than the search's own default.
  static constexpr float kSlab = 0;
};

/// Restitution of a pair from those of its bodies: the bouncier one decides, as a scene may.
template <class Scalar>
constexpr Scalar pair_restitution(Scalar a, Scalar b) {
  return max_of(a, b);
}

/// What a scene asks of its searches.
template <class SceneT>
struct SearchOf {
  using Scalar = typename SceneT::Scalar;
  using Search = typename SceneT::Search;
  using Options = typename Search::Options;

  static_assert(std::is_same_v<typename Search::Scalar, Scalar>,
                "Scene::Search: name it with the scene's Scalar");
  static_assert(SceneT::kTurnPerStep >= 0 && SceneT::kSlab >= 0 && SceneT::kSlab <= 1,
                "Scene: kTurnPerStep is at least 0, kSlab 0 ... 1");
  static_assert(
      Search::kHasSlab || (SceneT::kSlab == 0 && SceneT::kTurnPerStep == 0),
      "Scene: kSlab and kTurnPerStep have a meaning for Advancement and Translation only");
  static_assert(SceneT::kTurnPerStep == 0 || SceneT::kBudget >= kLeastLawBudget,
                "Scene: kTurnPerStep takes a kBudget of at least 8");
  static_assert(SceneT::kSlab == 0 || SceneT::kTurnPerStep == 0 ||
                    budget_for(SceneT::kTurnPerStep, SceneT::kSlab) <= SceneT::kBudget,
                "Scene: kBudget does not suffice for this kTurnPerStep and kSlab; "
                "budget_for(turn, slab) tells what does");

  /// Options that spend the scene's budget.
  static constexpr Options options() {
    const Scalar stated = static_cast<Scalar>(SceneT::kSlab);
    const Scalar asked = slab_for(static_cast<Scalar>(SceneT::kTurnPerStep), SceneT::kBudget);
    if constexpr (Search::kHasSlab) {
      const Scalar own = Options{}.slab;
      return Search::options(SceneT::kBudget, stated > Scalar(0) ? stated : max_of(own, asked));
    } else {
      return Search::options(SceneT::kBudget, Scalar(0));
    }
  }
};

/// The tolerances of a world, SI units, all relative to what the scene's user knows.
template <class SceneT>
struct WorldSettings {
  using Scalar = typename SceneT::Scalar;

  /// Those of the scene's search, within Scene::kBudget evaluations.
  typename SceneT::Search::Options search = SearchOf<SceneT>::options();
  Scalar rest_speed = Scalar(0.01);  ///< eps_r [Kavan §4], m/s, > 0
  Scalar separation = Scalar(1e-4);  ///< D [Kavan §4.2], m, > 0; a contact ends beyond 2 D
  Scalar min_separation_time = Scalar(1e-4);  ///< least f(D), s, > 0
};

/// @returns kOk | kInvalidArgument: an option out of its range, or a search that may take more than
/// Scene::kBudget evaluations
template <class SceneT>
Status validate(const WorldSettings<SceneT>& settings) {
  const bool good = validate(settings.search) == Status::kOk &&
                    SceneT::Search::most_evaluations(settings.search) <= SceneT::kBudget &&
                    is_positive(settings.rest_speed) && is_positive(settings.separation) &&
                    is_positive(settings.min_separation_time);
  return good ? Status::kOk : Status::kInvalidArgument;
}

}  // namespace batuta
