// SPDX-License-Identifier: MIT
// What a user may take for a scene, and what one is.
#if defined(DUEL_OPTIONS) || defined(DUEL_SCENE)
#include "batuta/fencing/duel.hpp"
#else
#include "batuta/world/world.hpp"
#endif

namespace {

using namespace batuta;

constexpr SceneOptions mine() {
  return {};
}

#if defined(DERIVED)
struct MyScene : Scene<mine> {
  static constexpr int kMaxBodies = 64;
};
#elif defined(DERIVED_IN_PRIVATE)
struct MyScene : private Scene<mine> {
  static constexpr int kMaxBodies = 64;
};
#elif defined(WITHOUT_BASE)
struct MyScene {
  static constexpr int kMaxBodies = 64;
};
#elif defined(OTHER_BASE)
struct MyScene : SceneOptions {
  static constexpr int kMaxBodies = 64;
};
#elif defined(NUMBER)
using MyScene = int;
#elif defined(OPTIONS_OF_ANOTHER_TYPE)
struct MyOptions : SceneOptions {
  bool grip = true;
};
constexpr MyOptions other() {
  return {};
}
using MyScene = Scene<other>;
#elif defined(DUEL_OPTIONS)
constexpr SceneOptions drill() {
  fencing::DuelOptions scene = fencing::two_fencers();
  scene.targets = false;
  return scene;
}
using MyScene = Scene<drill>;
#elif defined(DUEL_SCENE)
using MyScene = fencing::DuelScene<>;
#elif defined(QUALIFIER)
using MyScene = QUALIFIER Scene<mine>;
#elif defined(NO_FUNCTION)
using MyScene = Scene<64>;
#elif defined(SEARCH_LEFT_OUT)
using MyScene = Scene<mine, FreeFlight<float> >;
#else
using MyScene = Scene<mine>;
#endif

}  // namespace

#include "use_scene.inc"
