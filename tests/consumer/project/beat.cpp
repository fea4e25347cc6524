// SPDX-License-Identifier: MIT
#include <cstdio>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
using namespace batuta;

bool add_blade(World<TwoBlades>& world, Vec3<float> center, Vec3<float> velocity) {
  const Capsule<float> steel = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};  // 0.9 m, 5 mm radius
  auto blade = make_actor<TwoBlades>(steel, 7850.0F, {center, Quat<float>::Identity()},
                                     {velocity, Vec3<float>::Zero()});
  blade.value.restitution = 0.6F;
  return blade.ok() && world.add(blade.value).ok();
}

int main() {
  World<TwoBlades> world;  // one object, no heap
  if (!add_blade(world, {0, 0, 1}, {4, 0, 0})) return 1;
  if (!add_blade(world, {0.2F, 0, 1.3F}, {0, 0, 0})) return 1;
  for (int millisecond = 0; millisecond < 100; ++millisecond) {
    if (world.step(1e-3F) != Status::kOk || !world.report().complete()) return 1;
    for (const auto& event : world.events()) {
      if (event.kind != EventKind::kBegin) continue;
      std::printf("beat at %d ms, %.2f N s, %.0f %% up the first blade\n", millisecond,
                  static_cast<double>(event.impulse), static_cast<double>(100 * event.place_A));
    }
  }
}
