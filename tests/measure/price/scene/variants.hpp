// SPDX-License-Identifier: MIT
#pragma once
// TwoBlades with one feature changed at a time: what a feature costs is the difference of two of
// these (tools/scenes.py names which).

#include "batuta/world/scenes.hpp"

namespace batuta::price {

struct NoRestitution : TwoBlades {
  static constexpr bool kRestitution = false;
};
struct RestingNone : TwoBlades {
  static constexpr RestingContact kResting = RestingContact::kNone;
};
struct RestingSettling : TwoBlades {
  static constexpr RestingContact kResting = RestingContact::kSettling;
};
struct NoResponse : RestingNone {
  static constexpr bool kResponse = false;
  static constexpr bool kRestitution = false;
};
struct Friction : RestingSettling {
  static constexpr bool kFriction = true;
};
struct LineContact : TwoBlades {
  static constexpr bool kLineContact = true;
};
struct Gravity : TwoBlades {
  static constexpr bool kGravity = true;
};
struct Sleep : RestingSettling {
  static constexpr bool kSleep = true;
};
struct detail::NoEvents : TwoBlades {
  static constexpr int kMaxEvents = 0;
};
struct NoOwners : TwoBlades {
  static constexpr bool kOwners = false;
};
struct Filters : TwoBlades {
  static constexpr bool kFilters = true;
};
struct TwoParts : TwoBlades {
  static constexpr int kCapsulesPerBody = 2;
  static constexpr int kMaxPairs = 4;
};
struct WithTranslation : TwoBlades {
  using Search = Translation<float>;
};
struct WithStepping : TwoBlades {
  using Search = Stepping<float>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
};
struct WithCoarseBox : TwoBlades {
  using Bound = CoarseBox;
};
/// Turns, but is searched as if it did not: what NoRotation is compared with.
struct Unturned : RestingNone {
  using Search = Translation<float>;
};
struct NoRotation : Unturned {
  static constexpr bool kRotation = false;
};
struct Balls : NoRotation {
  using Search = Spheres<float>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
};
/// What StraightSpheres is compared with.
struct SpheresWithEvents : StraightSpheres {
  static constexpr int kMaxEvents = 16;
};

}  // namespace batuta::price
