// SPDX-License-Identifier: MIT
#include <cstdio>

#include "batuta/world/world.hpp"
using namespace batuta;

struct TwoBlades : Scene {};  // a scene is a type: capacities, scalar, controller, search

Actor<TwoBlades> blade(Vec3<float> center, Vec3<float> velocity) {
  Actor<TwoBlades> actor;
  actor.capsule_B = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};  // 0.9 m long, 5 mm radius
  const auto mass = solid_capsule(actor.capsule_B, 7850.0F).value;
  actor.body =
      make_body<float>({center, Quat<float>::Identity()}, mass.mass, mass.inertia_S.diagonal())
          .value;
  actor.body.momentum.linear_W = mass.mass * velocity;
  actor.restitution = 0.6F;
  return actor;
}

int main() {
  World<TwoBlades> world;  // one object, no heap
  (void)world.add(blade({0, 0, 1}, {4, 0, 0}));
  (void)world.add(blade({0.2F, 0, 1.3F}, {0, 0, 0}));
  for (int millisecond = 0; millisecond < 100; ++millisecond) {
    if (world.step(1e-3F) != Status::kOk || !world.report().complete()) return 1;
    for (const auto& event : world.events()) {
      if (event.kind != EventKind::kBegin) continue;
      std::printf("beat at %d ms, %.2f N s, %.0f %% up the first blade\n", millisecond,
                  static_cast<double>(event.impulse), static_cast<double>(100 * event.place_A));
    }
  }
}
