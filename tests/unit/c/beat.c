/* SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "batuta/c/duel.h"

/* Two steel blades of 0.9 m and 5 mm radius: capsule, pose and twist. The first moves at 4 m/s. */
static const float kA[BATUTA_MOVING_NUMBERS] = {0, 0, -0.45F, 0, 0, 0.45F, 0.005F, /* capsule */
                                                0, 0, 1,      1, 0, 0,     0,      /* pose */
                                                4, 0, 0,      0, 0, 0};            /* twist */
static const float kB[BATUTA_MOVING_NUMBERS] = {0, 0, -0.45F, 0, 0, 0.45F, 0.005F, 0.2F, 0, 1.3F,
                                                1, 0, 0,      0, 0, 0,     0,      0,    0, 0};
static const batuta_material kSteel = {7850, 0.6F, 0};
static const float kNoGravity[3] = {0, 0, 0};

static batuta_world world; /* static: 43 kB */
static batuta_duel duel;

static int tell_query(void) {
  float A[BATUTA_CAPSULE_NUMBERS] = {0, 0, 0.55F, 0, 0, 1.45F, 0.005F};
  float B[BATUTA_CAPSULE_NUMBERS] = {0.2F, 0, 0.85F, 0.2F, 0, 1.75F, 0.005F};
  batuta_search_f search = {0.1F, 1e-6F, 30};
  batuta_closest_f closest;
  batuta_contact_f contact;
  if (batuta_closest_points_f(A, B, &closest) != BATUTA_OK) return 1;
  printf("gap %.3f m\n", (double)closest.gap);
  if (batuta_time_of_contact_f(kA, kB, &search, &contact) != BATUTA_OK) return 1;
  if (contact.outcome != BATUTA_CONTACT) return 1;
  printf("contact at %.1f ms\n", 1e3 * (double)contact.t_hit);
  return 0;
}

static int tell_beat(void) {
  int32_t number;
  int millisecond;
  batuta_event event;
  if (batuta_world_init(&world, sizeof world) != BATUTA_OK) return 1;
  if (batuta_world_set_gravity(&world, kNoGravity) != BATUTA_OK) return 1;
  if (batuta_world_add(&world, kA, &kSteel, &number) != BATUTA_OK) return 1;
  if (batuta_world_add(&world, kB, &kSteel, &number) != BATUTA_OK) return 1;
  for (millisecond = 1; millisecond <= 100; ++millisecond) {
    if (batuta_world_step(&world, 1e-3F) != BATUTA_OK || !batuta_world_complete(&world)) return 1;
    if (batuta_world_event(&world, 0, &event) != BATUTA_OK) continue; /* nothing happened */
    printf("beat at %d ms, %.2f N s\n", millisecond, (double)event.impulse);
    return 0;
  }
  return 1;
}

static int tell_duel(void) {
  static const batuta_stick kForward = {0, 1, 0, 0};
  batuta_duel_state state;
  int step;
  if (batuta_duel_init(&duel, sizeof duel, 1000, 5) != BATUTA_OK) return 1;
  for (step = 0; step < 100; ++step) {
    if (batuta_duel_step(&duel, step % 10 == 0 ? &kForward : NULL, NULL) != BATUTA_OK) return 1;
  }
  if (batuta_duel_get_state(&duel, &state) != BATUTA_OK) return 1;
  printf("steps of the duel: %u, gap of its blades %.2f m\n", (unsigned)state.steps,
         (double)state.gap);
  return 0;
}

int main(void) {
  return tell_query() || tell_beat() || tell_duel();
}
