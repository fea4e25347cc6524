// SPDX-License-Identifier: MIT
// Asks a duel for what its scene leaves out, or for a scene that no duel can have.
#include "batuta/fencing/duel.hpp"

#ifndef CHANGE
#define CHANGE scene.sleep = false
#endif
#ifndef CALL
#define CALL steps()
#endif
#ifndef SCENE
#define SCENE DuelScene<drill>
#endif

namespace {

using namespace batuta;
using namespace batuta::fencing;

constexpr DuelOptions drill() {
  DuelOptions scene = two_fencers();
  CHANGE;
  return scene;
}
constexpr SceneOptions plain() {
  return {};
}
struct Derived : DuelScene<drill> {
  static constexpr bool kTargets = false;
};
using Drill = SCENE;

}  // namespace

void use(const Duel<Drill>& duel);
void use(const Duel<Drill>& duel) {
  (void)duel.CALL;
  (void)duel.bout();
  (void)duel.world().events();
}
