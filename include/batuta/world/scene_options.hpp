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
  /// The paper's: the bodies are moved apart to D and held for f(D). For bodies that a hand or a
  /// grip moves.
  kSeparation,
  /// For bodies that lie on each other: contacts that last are solved together before anybody
  /// moves, group by group; blows are answered one by one, and passed on through the group. A pair
  /// that asks for more than max_separations answers in a step goes on as one body for the rest of
  /// it.
  kSettling,
};

/// Everything that a scene chooses, with its default: two capsules, impulses and the paper's
/// separation.
struct SceneOptions {
  /// Which world runs the scene; no other option chooses it.
  Engine engine = Engine::kGeneral;

  // Capacities.
  /// Bodies at the same time, 2 ... 65534.
  int max_bodies = 2;
  /// Capsules of one body, 1 ... 255. One: Actor::capsule_B; more: Actor::capsules_B.
  int capsules_per_body = 1;
  /// Pairs of capsules whose swept volumes may meet at the same time, at least max_bodies / 2.
  /// Where more do, the bodies of the surplus pairs go on together for the rest of the step, and
  /// are counted.
  /// Engine::kSmall has room for all pairs.
  int max_pairs = 1;
  /// Contacts answered in one step, and contacts that last at the same time (kSettling). Where more
  /// happen, the bodies concerned go on together for the rest of it, and are counted.
  int max_contacts = 8;
  /// Events kept for reading after a step; a surplus is counted. 0: none, and no pair is followed.
  int max_events = 16;
  /// Answers of one pair in one step; beyond them its bodies go on together (kSettling).
  int max_separations = 4;
  /// For so long the bodies of a group must not go further than at rest_speed to be put to sleep
  /// (sleep), s, above 0 and at most 60.
  float sleep_time = 0.25F;

  // Features. What is off is absent: no member, no code.
  /// Bodies turn. Off: StraightBody, no quaternion, no inertia; the search is Translation or
  /// Spheres.
  bool rotation = true;
  /// Contacts change the bodies. Off: they are found and told, and everybody moves on.
  bool response = true;
  /// Actor::restitution. Off: C = 0.
  bool restitution = true;
  /// Actor::friction: Coulomb's law, sticking or sliding (response/friction.hpp).
  bool friction = false;
  /// Actor::rolling_resistance: what presses resists turning (kSettling with friction).
  bool rolling_resistance = false;
  /// Near-parallel capsules touch at two points (response/line_contact.hpp).
  bool line_contact = false;
  /// What becomes of contacts in which nearly nothing approaches.
  RestingContact resting = RestingContact::kSeparation;
  /// WorldSettings::gravity_W, felt by what its own momentum moves.
  bool gravity = false;
  /// What has not left its place for a while is put to sleep until something happens to it.
  bool sleep = false;
  /// Actor::owner: bodies of one owner never meet.
  bool owners = true;
  /// Actor::filter: who may meet whom.
  bool filters = false;

  // Searching.
  /// The axis along which a scene is longest, 0 ... 2: boxes are kept in order along it.
  int sweep_axis = 0;
  /// Distance evaluations of one search; 0: the search's own default. Where they do not suffice,
  /// the bodies go on together, and are counted.
  std::uint32_t budget = 0;
  // A scene may state two of turn_per_step, contact_tolerance and budget; detection/budget_law.hpp
  // gives the third.
  /// Furthest that a body turns in a step, rad; 0: not stated.
  float turn_per_step = 0;
  /// A gap of contact_tolerance times S counts as contact, S = MovingPair::scale; 0: not stated,
  /// then what the law asks for, and no less than the search's own default.
  float contact_tolerance = 0;
};

}  // namespace batuta
