// SPDX-License-Identifier: MIT
// Two blades meet in the air: a world is filled and stepped, its events are read, and momentum,
// angular momentum and energy are added up before and after. A blow of the paper keeps the first
// two and takes some of the third; restitution says how fast the blades part.
#include <cstdio>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
using namespace batuta;

using Blades = World<TwoBlades>;

struct Totals {
  Vec3<float> momentum = Vec3<float>::Zero();  // kg m/s
  Vec3<float> spin = Vec3<float>::Zero();      // angular momentum about the origin, kg m^2/s
  float energy = 0;                            // J
};

bool add_blade(Blades& world, const Vec3<float>& center, const Vec3<float>& velocity) {
  const Capsule<float> steel = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};  // 0.9 m, 5 mm radius
  auto blade = make_actor<TwoBlades>(steel, 7850.0F, {center, Quat<float>::Identity()},
                                     {velocity, Vec3<float>::Zero()});
  blade.value.restitution = 0.6F;
  return blade.ok() && world.add(blade.value).ok();
}

Totals totals_of(const Blades& world) {
  Totals totals;
  for (std::uint16_t slot = 0; slot < TwoBlades::kMaxBodies; ++slot) {
    const auto* blade = world.get(world.id_at(slot));
    if (blade == nullptr) continue;
    const Body<float>& body = blade->body;
    totals.momentum += body.momentum.linear_W;
    totals.spin += body.momentum.angular_W + body.X_WB.p_W.cross(body.momentum.linear_W);
    totals.energy += kinetic_energy(body);
  }
  return totals;
}

// How fast the bodies of a contact part along its normal, m/s; negative: they approach.
float parting_speed(const Blades& world, const ContactEvent<float>& event) {
  const Body<float>& A = world.get(world.id_at(event.body_A))->body;
  const Body<float>& B = world.get(world.id_at(event.body_B))->body;
  const Vec3<float> v_A_W = velocity_at(A.X_WB, twist_of(A), event.contact.point_W);
  const Vec3<float> v_B_W = velocity_at(B.X_WB, twist_of(B), event.contact.point_W);
  return event.contact.normal_BA_W.dot(v_A_W - v_B_W);
}

void print(const char* when, const Totals& totals) {
  std::printf("%s: momentum %.5f %.5f %.5f, about the origin %.5f %.5f %.5f, energy %.4f J\n", when,
              static_cast<double>(totals.momentum.x()), static_cast<double>(totals.momentum.y()),
              static_cast<double>(totals.momentum.z()), static_cast<double>(totals.spin.x()),
              static_cast<double>(totals.spin.y()), static_cast<double>(totals.spin.z()),
              static_cast<double>(totals.energy));
}

int main() {
  Blades world;
  if (!add_blade(world, {0, 0, 1}, {4, 0, 0})) return 1;
  if (!add_blade(world, {0.2F, 0, 1.3F}, {0, 0, 0})) return 1;
  print("before", totals_of(world));
  int beats = 0;
  for (int millisecond = 0; millisecond < 100; ++millisecond) {
    if (world.step(1e-3F) != Status::kOk || !world.report().complete()) return 1;
    for (const auto& event : world.events()) {
      if (event.kind != EventKind::kBegin) continue;
      ++beats;
      std::printf("beat at %.2f ms: approach %.3f m/s, parting %.3f m/s, %.3f N s, %.1f %% up\n",
                  millisecond + 1e3 * static_cast<double>(event.time),
                  -static_cast<double>(event.v_rel),
                  static_cast<double>(parting_speed(world, event)),
                  static_cast<double>(event.impulse), 100 * static_cast<double>(event.place_A));
    }
  }
  print("after", totals_of(world));
  return beats == 1 ? 0 : 1;
}
