// SPDX-License-Identifier: MIT
// Two blades meet in free flight: when, how hard, and where.
#include <batuta.h>

using namespace batuta;

World<TwoBlades> world;  // one object, no heap

// Where the library ends that was used wrongly: switch your actuators off here.
extern "C" void batuta_trap(std::uint32_t, std::uint32_t) {
  for (;;) {
  }
}

bool add_blade(float x, float z, float speed) {
  const Capsule<float> steel = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};  // 0.9 m, 5 mm radius
  auto blade = make_actor<TwoBlades>(steel, 7850.0F, {{x, 0, z}, Quat<float>::Identity()},
                                     {{speed, 0, 0}, Vec3<float>::Zero()});
  blade.value.restitution = 0.6F;
  return blade.ok() && world.add(blade.value).ok();
}

bool ready = false;

void setup() {
  Serial.begin(115200);
  ready = rounds_each_operation<float>() && add_blade(0, 1, 4) && add_blade(0.2F, 1.3F, 0);
  if (!ready) Serial.println("the arithmetic or the blades are not as they have to be");
}

void loop() {
  if (!ready || world.step(1e-3F) != Status::kOk) return;
  for (const auto& event : world.events()) {
    if (event.kind != EventKind::kBegin) continue;
    Serial.print("beat, N s: ");
    Serial.println(event.impulse);
  }
  delay(1);
}
