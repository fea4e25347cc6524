// SPDX-License-Identifier: MIT
#pragma once
// Combinations that no scene can have, each with what to change. A World checks its scene here.

#include "batuta/world/scene.hpp"

namespace batuta::detail {

template <class SceneT>
struct SceneCheck {
  static constexpr bool kRests = SceneT::kResting != RestingContact::kNone;
  static constexpr bool kSettles = SceneT::kResting == RestingContact::kSettling;
  static constexpr bool kHasSpheres = SceneT::Search::kForSpheres;

  static_assert(kIsScalar<typename SceneT::Scalar>, "Scene::Scalar: choose float or double");
  static_assert(SceneT::kMaxBodies >= 2 && SceneT::kMaxBodies <= 1024,
                "Scene::kMaxBodies: choose 2 ... 1024");
  static_assert(
      SceneT::kCapsulesPerBody >= 1 && SceneT::kCapsulesPerBody <= 255 &&
          SceneT::kMaxBodies * SceneT::kCapsulesPerBody <= 65535,
      "Scene::kCapsulesPerBody: choose 1 ... 255, and no more than 65535 capsules in all");
  static_assert(SceneT::kMaxPairs >= 1, "Scene::kMaxPairs: at least 1");
  static_assert(SceneT::kMaxContacts >= 1, "Scene::kMaxContacts: at least 1");
  static_assert(SceneT::kMaxEvents >= 0, "Scene::kMaxEvents: at least 0");
  static_assert(SceneT::kMaxSeparations >= 1, "Scene::kMaxSeparations: at least 1");
  static_assert(SceneT::kSweepAxis >= 0 && SceneT::kSweepAxis <= 2,
                "Scene::kSweepAxis: choose 0, 1 or 2");
  static_assert(SceneT::kSleepSteps >= 1 && SceneT::kSleepSteps <= 65535,
                "Scene::kSleepSteps: choose 1 ... 65535");

  static_assert(SceneT::kRotation || SceneT::Search::kForStraightFlight,
                "Scene: without kRotation, Search is Translation<Scalar> or Spheres<Scalar>");
  static_assert(!SceneT::kRotation || !kHasSpheres,
                "Scene: Search = Spheres<Scalar> takes kRotation = false");
  static_assert(!kHasSpheres || SceneT::kCapsulesPerBody == 1,
                "Scene: Search = Spheres<Scalar> takes kCapsulesPerBody = 1");
  static_assert(SceneT::kRotation || !kRests,
                "Scene: without kRotation, set kResting = RestingContact::kNone; slow contacts are "
                "answered by impulses");
  static_assert(
      SceneT::kRotation || !SceneT::kFriction,
      "Scene: kFriction takes kRotation = true: a contact that rubs turns what it touches");
  static_assert(SceneT::kRotation || !SceneT::kLineContact,
                "Scene: kLineContact takes kRotation = true: where nothing turns, one point does");
  static_assert(SceneT::kResponse || !SceneT::kRestitution,
                "Scene: without kResponse, set kRestitution = false as well");
  static_assert(SceneT::kResponse || !SceneT::kFriction,
                "Scene: without kResponse, set kFriction = false as well");
  static_assert(SceneT::kResponse || !SceneT::kLineContact,
                "Scene: without kResponse, set kLineContact = false as well");
  static_assert(SceneT::kResponse || !kRests,
                "Scene: without kResponse, set kResting = RestingContact::kNone as well");
  static_assert(SceneT::kResponse || SceneT::kMaxEvents > 0,
                "Scene: without kResponse, set kMaxEvents > 0: events are all there is to see");
  static_assert(
      !SceneT::kFriction || SceneT::kResting != RestingContact::kSeparation,
      "Scene: kFriction takes kResting = kSettling (or kNone): a separation pushes nothing "
      "that could rub");
  static_assert(!SceneT::kSleep || kSettles, "Scene: kSleep takes kResting = kSettling");
  static_assert(!SceneT::kSleep || SceneT::kMaxEvents > 0,
                "Scene: kSleep takes kMaxEvents > 0: what a sleeper lies on has to be followed");
  static_assert(!SceneT::kGrip || SceneT::kRotation, "Scene: kGrip takes kRotation = true");
  static_assert(!SceneT::kTargets || SceneT::kRotation, "Scene: kTargets takes kRotation = true");
  static_assert(!SceneT::kHaptics || SceneT::kRotation, "Scene: kHaptics takes kRotation = true");
  static_assert(!SceneT::kHaptics || SceneT::kMaxEvents > 0,
                "Scene: kHaptics takes kMaxEvents > 0: events tell the blows that a hand feels");
  static constexpr bool kIsPossible = true;
};

}  // namespace batuta::detail
