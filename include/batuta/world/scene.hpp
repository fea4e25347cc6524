// SPDX-License-Identifier: MIT
#pragma once
// A scene is a type: what it has room for and what it does are constants of it, so that memory and
// the longest step are known when it is compiled. A function returns the options, and names the
// scene:
//   constexpr SceneOptions duel() { SceneOptions scene; scene.max_bodies = 8; return scene; }
//   using MyScene = batuta::Scene<duel>;

#include "batuta/detection/budget_law.hpp"
#include "batuta/detection/search.hpp"
#include "batuta/world/bound.hpp"
#include "batuta/world/controller.hpp"
#include "batuta/world/scene_options.hpp"

namespace batuta {

namespace detail {

/// Marks scenes, and what is derived from one.
struct SceneMark {};

/// Whether a function returns Options.
template <class Options, auto kOptions, class = void>
inline constexpr bool kReturnsOptions = false;
template <class Options, auto kOptions>
inline constexpr bool
    kReturnsOptions<Options, kOptions,
                    std::enable_if_t<std::is_same_v<Options, std::decay_t<decltype(kOptions())>>>> =
        true;

/// Whether it does so when the compiler calls it.
template <class Options, auto kOptions, class = void>
inline constexpr bool kGivesOptions = false;
template <class Options, auto kOptions>
inline constexpr bool kGivesOptions<
    Options, kOptions,
    std::enable_if_t<kReturnsOptions<Options, kOptions> && (static_cast<void>(kOptions()), true)>> =
    true;

/// What it returns; the defaults where there is nothing to call (scene_check.hpp refuses that).
template <class Options, auto kOptions>
constexpr Options options_of() {
  if constexpr (kGivesOptions<Options, kOptions>) {
    return kOptions();
  } else {
    return {};
  }
}

/// A function of the right type that gives no constant: g++ is made to say why, and says nothing
/// where the reason is an error that it has told already. clang++ would tell that twice; there the
/// program does not link (refused_scene.hpp).
template <auto kOptions, bool kSpeaks>
struct OptionsSpeak {};
template <auto kOptions>
struct OptionsSpeak<kOptions, true> {
  static constexpr auto kOptionsOfAConstexprFunction = kOptions();
};

/// Scalar of a search; float where it has none.
template <class SearchT, class = void>
struct SearchScalar {
  using Type = float;
};
template <class SearchT>
struct SearchScalar<SearchT, std::void_t<typename SearchT::Scalar>> {
  using Type = typename SearchT::Scalar;
};

template <class SearchT, class = void>
inline constexpr std::uint32_t kDefaultBudgetOf = 0;
template <class SearchT>
inline constexpr std::uint32_t
    kDefaultBudgetOf<SearchT, std::void_t<decltype(SearchT::kDefaultBudget)>> =
        SearchT::kDefaultBudget;

/// The options as constants, for scenes of all applications.
template <class Options, auto kOptions, class SearchT, class ControllerT, class BoundT>
struct SceneConstants : SceneMark {
  using Scalar = typename SearchScalar<SearchT>::Type;
  using Search = SearchT;
  using Controller = ControllerT;
  using Bound = BoundT;

  using Speak = OptionsSpeak<kOptions, kReturnsOptions<Options, kOptions> &&
                                           !kGivesOptions<Options, kOptions> && kTellsErrorsOnce>;
  static constexpr bool kHasOptionsFunction = kReturnsOptions<Options, kOptions>;
  static constexpr bool kHasOptions = kGivesOptions<Options, kOptions>;
  static constexpr Options kStated = options_of<Options, kOptions>();
  static constexpr Engine kEngine = kStated.engine;
  static constexpr int kMaxBodies = kStated.max_bodies;
  static constexpr int kCapsulesPerBody = kStated.capsules_per_body;
  static constexpr int kMaxPairs = kStated.max_pairs;
  static constexpr int kMaxContacts = kStated.max_contacts;
  static constexpr int kMaxEvents = kStated.max_events;
  static constexpr int kMaxSeparations = kStated.max_separations;
  static constexpr float kSleepTime = kStated.sleep_time;
  static constexpr bool kRotation = kStated.rotation;
  static constexpr bool kBentTurns = kStated.rotation && kStated.bent_turns;
  static constexpr bool kResponse = kStated.response;
  static constexpr bool kRestitution = kStated.restitution;
  static constexpr bool kFriction = kStated.friction;
  static constexpr bool kRollingResistance = kStated.rolling_resistance;
  static constexpr bool kLineContact = kStated.line_contact;
  static constexpr RestingContact kResting = kStated.resting;
  static constexpr bool kGravity = kStated.gravity;
  static constexpr bool kSleep = kStated.sleep;
  static constexpr bool kOwners = kStated.owners;
  static constexpr bool kFilters = kStated.filters;
  static constexpr int kSweepAxis = kStated.sweep_axis;
  static constexpr std::uint32_t kBudget = kStated.budget > 0
                                               ? static_cast<std::uint32_t>(kStated.budget.value)
                                               : kDefaultBudgetOf<SearchT>;
  static constexpr float kTurnPerStep = kStated.turn_per_step;
  static constexpr float kContactTolerance = kStated.contact_tolerance;
};

}  // namespace detail

/// The scene with the options that a function returns.
/// @tparam kOptions  a constexpr function that returns SceneOptions
/// @tparam SearchT  how contacts are found: Advancement (never misses), Translation (the same where
///   nothing turns), Spheres, or Stepping (the paper's); see detection/search.hpp. The others are
///   not linked. Its Scalar is the scene's.
/// @tparam ControllerT  who moves a body; see controller.hpp. Not asked where rotation is false:
///   there, bodies fly by their momenta.
/// @tparam BoundT  what holds a capsule over a step: SweptBox (exact) or CoarseBox; see bound.hpp
template <auto kOptions, class SearchT = Advancement<float>,
          class ControllerT = FreeFlight<typename detail::SearchScalar<SearchT>::Type>,
          class BoundT = SweptBox>
struct Scene : detail::SceneConstants<SceneOptions, kOptions, SearchT, ControllerT, BoundT> {};

namespace detail {

/// What the members of a world do not show of its scene, for the fingerprint of what is saved.
template <class SceneT, class Archive>
void archive_scene(Archive& ar) {
  ar.constant(static_cast<std::uint32_t>(SceneT::kMaxContacts));
  ar.constant(static_cast<std::uint32_t>(SceneT::kMaxSeparations));
  constexpr float kMicroseconds = 1e6F;
  ar.constant(static_cast<std::uint32_t>(kMicroseconds * SceneT::kSleepTime));
  ar.constant(static_cast<std::uint32_t>(SceneT::kBudget));
  ar.constant(static_cast<std::uint32_t>(SceneT::kResting));
  ar.constant(SceneT::Search::kNumber);
  constexpr std::uint32_t kFlags = (SceneT::kRotation ? 1U : 0U) | (SceneT::kResponse ? 2U : 0U) |
                                   (SceneT::kLineContact ? 4U : 0U) | (SceneT::kGravity ? 8U : 0U) |
                                   (SceneT::kSleep ? 16U : 0U);
  ar.constant(kFlags);
}

}  // namespace detail

}  // namespace batuta
