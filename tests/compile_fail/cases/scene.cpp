// SPDX-License-Identifier: MIT
#include "batuta/world/world.hpp"

#ifndef BUDGET
#define BUDGET 16
#endif
#ifndef SEARCH
#define SEARCH Advancement<float>
#endif

namespace {

struct MyScene : batuta::Scene {
  using Search = batuta::SEARCH;
  static constexpr std::uint32_t kBudget = BUDGET;
  static constexpr float kTurnPerStep = 0.785F;
  static constexpr float kContactTolerance = 8e-4F;
};

}  // namespace

batuta::Status check();
batuta::Status check() {
  batuta::World<MyScene> world;
  return world.step(1.0F);
}
