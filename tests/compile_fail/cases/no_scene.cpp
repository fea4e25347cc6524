// SPDX-License-Identifier: MIT
// What a user may take for a scene, and what one is.
#include "batuta/world/world.hpp"

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
#elif defined(NO_FUNCTION)
using MyScene = Scene<64>;
#elif defined(SEARCH_LEFT_OUT)
using MyScene = Scene<mine, FreeFlight<float> >;
#else
using MyScene = Scene<mine>;
#endif

}  // namespace

#include "use_scene.inc"
