// SPDX-License-Identifier: MIT
#pragma once
// What a scene has room for and what it does, as a value with named members. A function returns it,
// and the function names the scene (scene.hpp):
//   constexpr SceneOptions rack() {
//     SceneOptions scene;
//     scene.max_bodies = 64;
//     return scene;
//   }
//   using Rack = Scene<rack>;
// What a scene cannot have is refused in one sentence (scene_check.hpp).

#include <cstdint>

#include "batuta/world/detail/option_types.hpp"

namespace batuta {

/// Which world runs a scene.
enum class Engine : std::uint8_t {
  /// GeneralWorld: everything that a scene can ask for.
  kGeneral,
  /// SmallWorld: up to eight bodies of one capsule or ball each that fly straight, without events,
  /// in a fraction of the flash. What it cannot do is refused.
  kSmall,
};

/// What a scene does about contacts in which nearly nothing approaches [Kavan §4.2].
enum class RestingContact : std::uint8_t {
  /// Nothing special: every approaching contact gets an impulse, however slow.
  kNone,
  /// The paper's: the bodies are moved apart to D and go on together for f(D). For bodies that a
  /// hand or a grip moves.
  kSeparation,
  /// For bodies that lie on each other: contacts that last are solved together before anybody
  /// moves, group by group; blows are answered one by one, and passed on through the group. A pair
  /// that asks for more than max_separations answers in quick succession goes on as one body for
  /// the rest of the step.
  kSettling,
};

/// Everything that a scene chooses, with its default: two capsules, impulses and the paper's
/// separation.
struct SceneOptions {
  SceneOptions() = default;
  /// What is left of the options of an application (DuelOptions): no scene takes it, because what
  /// they add is lost.
  template <class Other, class = std::enable_if_t<std::is_base_of_v<SceneOptions, Other> &&
                                                  !std::is_same_v<SceneOptions, Other>>>
  // cppcheck-suppress noExplicitConstructor ; deviation: scene-options
  constexpr SceneOptions(const Other& /*options*/) : is_rest_of_others(true) {}

  /// Which world runs the scene; no other option chooses it.
  Engine engine = Engine::kGeneral;

  // Capacities.
  /// Bodies at the same time, 2 ... 65534.
  detail::WholeNumber max_bodies = 2;
  /// Capsules of one body, 1 ... 255. One: Actor::capsule_B; more: Actor::capsules_B.
  detail::WholeNumber capsules_per_body = 1;
  /// Pairs of capsules whose swept volumes may meet at the same time, at least max_bodies / 2.
  /// Where more do, the bodies of the surplus pairs go on together for the rest of the step, and
  /// are counted.
  /// Engine::kSmall has room for all pairs, and takes no number. At most 65535.
  detail::WholeNumber max_pairs = 1;
  /// Contacts answered in one step, and contacts that last at the same time (kSettling). Where more
  /// happen, the bodies concerned go on together for the rest of it, and are counted. 1 ... 65535.
  detail::WholeNumber max_contacts = 8;
  /// Events kept for reading after a step; a surplus is counted. 0: none, and no pair is followed.
  /// At most 65535.
  detail::WholeNumber max_events = 16;
  /// Answers of one pair in one step that come within 1/128 of it of the one before; beyond them
  /// its bodies go on together (kSettling); 1 ... 65535.
  detail::WholeNumber max_separations = 8;
  /// For so long the bodies of a group must not go further than at rest_speed to be put to sleep
  /// (sleep), s, above 0 and at most 60.
  detail::RealNumber sleep_time = 0.25F;

  // Features. What is off is absent: no member, no code.
  /// Bodies turn. Off: StraightBody, no quaternion, no inertia; the search is Translation or
  /// Spheres.
  detail::TrueOrFalse rotation = true;
  /// Bodies with three unlike moments, and bodies with two equal ones and a capsule off their axis:
  /// their turn in a step is the chord of a bent one (src/world/world.md, "Bent turns"). Off: such
  /// a body is refused, Status::kInvalidArgument; one that make_actor() makes of its capsule is
  /// none.
  detail::TrueOrFalse bent_turns = true;
  /// Contacts change the bodies. Off: they are found and told, and everybody moves on.
  detail::TrueOrFalse response = true;
  /// Actor::restitution. Off: C = 0.
  detail::TrueOrFalse restitution = true;
  /// Actor::friction: Coulomb's law, sticking or sliding (response/friction.hpp).
  detail::TrueOrFalse friction = false;
  /// Actor::rolling_resistance: what presses resists turning (kSettling with friction).
  detail::TrueOrFalse rolling_resistance = false;
  /// Near-parallel capsules touch at two points (response/line_contact.hpp).
  detail::TrueOrFalse line_contact = false;
  /// What becomes of contacts in which nearly nothing approaches.
  RestingContact resting = RestingContact::kSeparation;
  /// WorldSettings::gravity_W, felt by what its own momentum moves.
  detail::TrueOrFalse gravity = false;
  /// What has not left its place for a while is put to sleep until something happens to it.
  detail::TrueOrFalse sleep = false;
  /// Actor::owner: bodies of one owner never meet.
  detail::TrueOrFalse owners = true;
  /// Actor::filter: who may meet whom.
  detail::TrueOrFalse filters = false;

  // Searching.
  /// The axis along which a scene is longest, 0 ... 2: boxes are kept in order along it.
  detail::WholeNumber sweep_axis = 0;
  /// Distance evaluations of one search, from its kLeastBudget to 4096; of Stepping what is beyond
  /// 25 are steps. 0: the search's own default. Where they do not suffice, the bodies go on
  /// together, and are counted.
  detail::WholeNumber budget = 0;
  // Where turn_per_step is stated, contact_tolerance follows from it and the budget by
  // detection/budget_law.hpp; where both are, a budget that does not suffice is refused.
  /// Furthest that a body turns in a step, rad, at most half a turn; 0: not stated.
  detail::RealNumber turn_per_step = 0;
  /// A gap of contact_tolerance times S counts as contact, S = MovingPair::scale; 0: not stated,
  /// then what the law asks for, and no less than the search's own default.
  detail::RealNumber contact_tolerance = 0;
  /// Set where these are what is left of an application's options.
  bool is_rest_of_others = false;
};

}  // namespace batuta
