// SPDX-License-Identifier: MIT
// The smallest program with a scene, for a look at what it links.
#include "batuta/world/world.hpp"

namespace {

struct TwoBlades : batuta::Scene {
  using Search = batuta::SEARCH<float>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
};

}  // namespace

int main() {
  batuta::World<TwoBlades> world;
  return world.step(1e-3F) == batuta::Status::kOk ? 0 : 1;
}
