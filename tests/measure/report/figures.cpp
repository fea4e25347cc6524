// SPDX-License-Identifier: MIT
// The table of sizes and bounds of docs/cost.md. They follow from the code alone, so that a test
// can hold the page to them.

#include <cstdio>

#include "batuta/fencing/duel.hpp"
#include "batuta/world/scenes.hpp"

namespace {

using namespace batuta;
using namespace batuta::fencing;

constexpr SceneOptions room_options() {
  SceneOptions scene;
  scene.max_bodies = 64;
  scene.max_pairs = 256;
  return scene;
}
using Room = Scene<room_options>;

void row(const char* what, std::size_t value, const char* unit) {
  std::printf("| %s | %zu %s |\n", what, value, unit);
}

template <class SceneT>
constexpr std::size_t longest_step() {
  return static_cast<std::size_t>(World<SceneT>::kMaxRounds) * SceneT::kMaxPairs * SceneT::kBudget;
}

}  // namespace

int main() {
  std::printf("| figure (float) | value |\n| --- | --- |\n");
  row("`Capsule`", sizeof(Capsule<float>), "B");
  row("`Body`: pose, momenta, inverse mass and moments", sizeof(Body<float>), "B");
  row("`World` of two blades in free flight", sizeof(World<TwoBlades>), "B");
  row("`World` of 64 bodies, 256 pairs", sizeof(World<Room>), "B");
  row("`Duel`: world, two sticks, grids, grips and bodies", sizeof(Duel<>), "B");
  row("distance evaluations in the longest step of two blades, default budget",
      longest_step<TwoBlades>(), "");
}
