// SPDX-License-Identifier: MIT
#pragma once
// Ready-made scenes: derive from one, or read them as examples. The duel is DuelScene
// (fencing/duel.hpp). What each costs on a part stands in docs/cost.md.

#include "batuta/world/scene.hpp"

namespace batuta {

/// Up to eight balls that fly straight and bounce off each other; no events, report() counts.
struct StraightSpheres : Scene {
  using Search = Spheres<float>;  ///< one closed form for each pair
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;   ///< one evaluation
  static constexpr int kMaxBodies = 8;                               ///< eight balls
  static constexpr int kMaxPairs = 28;                               ///< all of them
  static constexpr int kMaxEvents = 0;                               ///< none: report() counts
  static constexpr bool kRotation = false;                           ///< off: StraightBody
  static constexpr bool kOwners = false;                             ///< off: all meet all
  static constexpr RestingContact kResting = RestingContact::kNone;  ///< every blow is answered
};

/// Two capsules on plans that the caller knows: events say when and where they meet, and change
/// nothing.
struct DetectionOnly : Scene {
  static constexpr bool kResponse = false;     ///< off: contacts are told and change nothing
  static constexpr bool kRestitution = false;  ///< off: nothing bounces
  static constexpr bool kOwners = false;       ///< off: both meet
  static constexpr RestingContact kResting = RestingContact::kNone;  ///< nothing is moved apart
};

/// Two capsules with impulses and the paper's separation.
struct TwoBlades : Scene {};

/// 64 capsules that fall, rub, pile up and come to rest.
struct Rack : Scene {
  static constexpr int kMaxBodies = 64;       ///< 64 capsules
  static constexpr int kMaxPairs = 256;       ///< four for each body
  static constexpr int kMaxContacts = 256;    ///< answered in one step
  static constexpr int kMaxEvents = 256;      ///< kept for reading after a step
  static constexpr bool kFriction = true;     ///< Coulomb's law
  static constexpr bool kLineContact = true;  ///< a flat landing does not spin
  static constexpr bool kGravity = true;      ///< what its momentum moves falls
  static constexpr bool kSleep = true;        ///< what stays in its place sleeps
  /// bodies lie on each other
  static constexpr RestingContact kResting = RestingContact::kSettling;
};

}  // namespace batuta
