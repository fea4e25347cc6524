/* SPDX-License-Identifier: MIT */
/* Of Zephyr's kernel what the port uses, as its documentation declares it (3.7, 4.x); fake_zephyr.cpp is behind it. */
#pragma once
#include <stdint.h>

struct k_spinlock {
  int held;
};
struct k_spinlock_key_t {
  int key;
};

k_spinlock_key_t k_spin_lock(struct k_spinlock* lock);
void k_spin_unlock(struct k_spinlock* lock, k_spinlock_key_t key);

int64_t k_uptime_ticks(void);
uint64_t k_ticks_to_us_floor64(uint64_t ticks);
