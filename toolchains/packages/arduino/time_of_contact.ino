// SPDX-License-Identifier: MIT
// When do two moving capsules first touch? Without a world.
#include <batuta.h>

using namespace batuta;

// Where the library ends that was used wrongly: switch your actuators off here.
extern "C" void batuta_trap(std::uint32_t, std::uint32_t) {
  for (;;) {
  }
}

MovingCapsule<float> rod(float x, float speed) {
  MovingCapsule<float> moving;
  moving.capsule_B = {{{0, -0.5F, 0}, {0, 0.5F, 0}}, 0.01F};  // 1 m, 1 cm radius
  moving.motion.X_WB.p_W = {x, 0, 0};
  moving.motion.twist.v_W = {speed, 0, 0};
  moving.motion.twist.w_W = {0, 0, 1};
  moving.motion.duration = 1;
  return moving;
}

void setup() {
  Serial.begin(115200);
  const auto pair = make_moving_pair(rod(0, 1), rod(1, 0));
  if (!pair.ok()) return;
  const auto found = search_advancement(pair.value, AdvancementOptions<float>{});
  Serial.print("free until, s: ");
  Serial.println(found.t_free, 6);
}

void loop() {}
