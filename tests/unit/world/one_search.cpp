// SPDX-License-Identifier: MIT
// The smallest program with a scene, for a look at what it links.
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace {

using TwoBlades = batuta::Scene<batuta::two_blades, batuta::SEARCH<float>>;

}  // namespace

int main() {
  batuta::World<TwoBlades> world;
  return world.step(1e-3F) == batuta::Status::kOk ? 0 : 1;
}
