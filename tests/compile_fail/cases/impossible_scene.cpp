// SPDX-License-Identifier: MIT
// A scene made of BASE, which is possible, and what the macros below change in it: ON and OFF name
// a feature, NUMBER a capacity with its VALUE, RESTING and SEARCH what these are to be, SCALAR a
// type.
#include "batuta/world/world.hpp"

#ifndef BASE
#define BASE Scene
#endif

namespace {

using namespace batuta;

struct Straight : Scene {
  using Search = Translation<float>;
  static constexpr RestingContact kResting = RestingContact::kNone;
  static constexpr bool kRotation = false;
};
struct Silent : Scene {
  static constexpr RestingContact kResting = RestingContact::kNone;
  static constexpr bool kResponse = false;
  static constexpr bool kRestitution = false;
};
struct Unrested : Scene {
  static constexpr RestingContact kResting = RestingContact::kNone;
};
struct Settling : Scene {
  static constexpr RestingContact kResting = RestingContact::kSettling;
};
struct Sleepy : Settling {
  static constexpr bool kSleep = true;
};
struct Spherical : Straight {
  using Search = Spheres<float>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
};
struct Crowd : Scene {
  static constexpr int kMaxBodies = 1024;
};

struct MyScene : BASE {
#ifdef ON
  static constexpr bool ON = true;
#endif
#ifdef OFF
  static constexpr bool OFF = false;
#endif
#ifdef NUMBER
  static constexpr int NUMBER = VALUE;
#endif
#ifdef RESTING
  static constexpr RestingContact kResting = RestingContact::RESTING;
#endif
#ifdef SEARCH
  using Search = SEARCH<float>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
#endif
#ifdef SCALAR
  using Scalar = SCALAR;
#endif
};

}  // namespace

batuta::Status check();
batuta::Status check() {
  batuta::World<MyScene> world;
  return world.step(1.0F);
}
