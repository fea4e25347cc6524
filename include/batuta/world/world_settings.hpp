// SPDX-License-Identifier: MIT
#pragma once
// The tolerances of a world: those of its search, of contacts that rest, and gravity. What a scene
// leaves out has none.

#include "batuta/world/detail/scene_check.hpp"

namespace batuta {

namespace detail {

/// What a scene asks of its searches.
template <class SceneT>
struct SearchOf {
  using Scalar = typename SceneT::Scalar;
  using Search = typename SceneT::Search;
  using Options = typename Search::Options;

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
  /// eps_r [Kavan §4], m/s, > 0. Under kSettling with gravity, what a body gains by falling for a
  /// step counts as rest as well; under kNone all that approaches collides.
  Scalar rest_speed = Scalar(0.01);
  Scalar separation = Scalar(1e-4);  ///< D [Kavan §4.2], m, > 0; a contact ends beyond 2 D
  Scalar min_separation_time = Scalar(1e-4);  ///< least f(D), s, > 0
};
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

}  // namespace detail

/// The tolerances of a world, SI units, all relative to what the scene's user knows.
template <class SceneT>
struct WorldSettings
    : std::conditional_t<detail::kKnowsRest<typename detail::SceneVerdict<SceneT>::Seen>,
                         detail::RestSettings<detail::ScalarFor<SceneT>>, detail::Absent<0>>,
      std::conditional_t<detail::SceneFor<SceneT>::kGravity,
                         detail::GravitySettings<detail::ScalarFor<SceneT>>, detail::Absent<1>> {
  /// The scene's.
  using Scalar = detail::ScalarFor<SceneT>;

  /// Those of the scene's search, within SceneOptions::budget evaluations.
  typename detail::SceneFor<SceneT>::Search::Options search =
      detail::SearchOf<detail::SceneFor<SceneT>>::options();
};

/// @returns kOk | kInvalidArgument: an option out of its range, or a search that may take more than
/// the scene's budget
template <class SceneT>
Status validate(const WorldSettings<SceneT>& settings) {
  bool good = validate(settings.search) == Status::kOk &&
              SceneT::Search::most_evaluations(settings.search) <= SceneT::kBudget;
  if constexpr (detail::kKnowsRest<SceneT>) {
    good = good && is_positive(settings.rest_speed) && is_positive(settings.separation) &&
           is_positive(settings.min_separation_time);
  }
  if constexpr (SceneT::kGravity) good = good && is_finite(settings.gravity_W);
  return good ? Status::kOk : Status::kInvalidArgument;
}

}  // namespace batuta
