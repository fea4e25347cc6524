// SPDX-License-Identifier: MIT
// Twelve rods fall into a trough of four logs, pile up, rub and come to rest. A scene of one's
// own starts from a ready-made one; gravity, friction, rolling resistance and sleep are options of
// it. What sleeps costs nothing until something happens to it.
#include <array>
#include <cstdio>
#include <limits>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
using namespace batuta;

constexpr int kLogs = 4;
constexpr int kRods = 12;

constexpr SceneOptions trough() {
  SceneOptions scene = rack();  // gravity, friction, line contact, settling, sleep
  scene.max_bodies = kLogs + kRods;
  scene.rolling_resistance = true;
  return scene;
}
using Trough = Scene<trough>;

bool add(World<Trough>& world, const Capsule<float>& capsule_G, float density,
         const Pose<float>& X_WG) {
  auto actor = make_actor<Trough>(capsule_G, density, X_WG);
  actor.value.friction = 0.6F;
  actor.value.rolling_resistance = 1e-3F;  // or a rod that lies across would roll on and on
  return actor.ok() && world.add(actor.value).ok();
}

// Two fixed logs along y, with their tops at height 0, between two higher ones; each touches the
// next. Above them the rods, turned and tilted each in its own way.
bool fill(World<Trough>& world) {
  const float fixed = std::numeric_limits<float>::infinity();
  bool good = true;
  for (const float side : {-1.0F, 1.0F}) {
    for (const auto& [x, z] : {std::array{0.5F, -0.5F}, std::array{1.3F, 0.1F}}) {
      const Capsule<float> log = {{{side * x, -4, z}, {side * x, 4, z}}, 0.5F};
      good = good && add(world, log, fixed, {});
    }
  }
  const Capsule<float> rod = {{{-0.15F, 0, 0}, {0.15F, 0, 0}}, 0.03F};
  for (int i = 0; i < kRods; ++i) {
    const auto n = static_cast<float>(i);
    const Quat<float> turned(1, 0.1F * n, 0.2F * static_cast<float>(i % 3), 0.7F * n);
    good = good && add(world, rod, 700.0F, {{0, 0, 0.2F * (n + 1)}, turned.normalized()});
  }
  return good;
}

int print_rods(const World<Trough>& world) {
  int asleep = 0;
  for (std::uint16_t slot = kLogs; slot < kLogs + kRods; ++slot) {
    const auto id = world.id_at(slot);
    const auto& rod = *world.get(id);
    const Segment<float> axis = to_world(rod.body.X_WB, rod.capsule_B).axis;
    asleep += world.is_asleep(id) ? 1 : 0;
    std::printf("rod %2d from (%.4f %.4f %.4f) to (%.4f %.4f %.4f), %s\n", slot - kLogs + 1,
                static_cast<double>(axis.a.x()), static_cast<double>(axis.a.y()),
                static_cast<double>(axis.a.z()), static_cast<double>(axis.b.x()),
                static_cast<double>(axis.b.y()), static_cast<double>(axis.b.z()),
                world.is_asleep(id) ? "asleep" : "awake");
  }
  return asleep;
}

int main() {
  World<Trough> world;
  if (!fill(world)) return 1;
  int at_rest = 0;  // ms from which on all rods sleep
  for (int millisecond = 1; millisecond <= 20'000 && at_rest == 0; ++millisecond) {
    if (world.step(1e-3F) != Status::kOk || !world.report().complete()) return 1;
    if (world.report().asleep >= kRods) at_rest = millisecond;
  }
  const int asleep = print_rods(world);
  std::printf("%d of %d rods are asleep after %.2f s\n", asleep, kRods, 1e-3 * at_rest);
  return at_rest > 0 ? 0 : 1;
}
