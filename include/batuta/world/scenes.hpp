// SPDX-License-Identifier: MIT
#pragma once
// Ready-made scenes: derive from one, or read them as examples. The duel is DuelScene
// (fencing/duel.hpp). What each costs on a part stands in the README.

#include "batuta/world/scene.hpp"

namespace batuta {

/// Up to eight balls that fly straight and bounce off each other; no events, report() counts.
struct StraightSpheres : Scene {
  using Search = Spheres<float>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
  static constexpr int kMaxBodies = 8;
  static constexpr int kMaxPairs = 28;  // all of them
  static constexpr int kMaxEvents = 0;
  static constexpr bool kRotation = false;
  static constexpr bool kOwners = false;
  static constexpr RestingContact kResting = RestingContact::kNone;
};

/// Two capsules on plans that the caller knows: events say when and where they meet, and change
/// nothing.
struct DetectionOnly : Scene {
  static constexpr bool kResponse = false;
  static constexpr bool kRestitution = false;
  static constexpr bool kOwners = false;
  static constexpr RestingContact kResting = RestingContact::kNone;
};

/// Two capsules with impulses and the paper's separation.
struct TwoBlades : Scene {};

/// 64 capsules that fall, rub, pile up and come to rest.
struct Rack : Scene {
  static constexpr int kMaxBodies = 64;
  static constexpr int kMaxPairs = 256;
  static constexpr int kMaxContacts = 256;
  static constexpr int kMaxEvents = 256;
  static constexpr bool kFriction = true;
  static constexpr bool kLineContact = true;
  static constexpr bool kGravity = true;
  static constexpr bool kSleep = true;
  static constexpr RestingContact kResting = RestingContact::kSettling;
};

}  // namespace batuta
