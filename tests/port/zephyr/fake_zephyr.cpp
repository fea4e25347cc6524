// SPDX-License-Identifier: MIT
#include "fake_zephyr.hpp"

#include <zephyr/drivers/pwm.h>
#include <zephyr/kernel.h>

using batuta::zephyr::test::fake_zephyr;
using batuta::zephyr::test::FakeZephyr;

FakeZephyr& batuta::zephyr::test::fake_zephyr() {
  static FakeZephyr zephyr;
  return zephyr;
}

k_spinlock_key_t k_spin_lock(k_spinlock* lock) {
  ++fake_zephyr().locks;
  return {++lock->held};
}

void k_spin_unlock(k_spinlock* lock, k_spinlock_key_t key) {
  lock->held = key.key - 1;
  --fake_zephyr().locks;
}

std::int64_t k_uptime_ticks() {
  return static_cast<std::int64_t>(fake_zephyr().ticks);
}

std::uint64_t k_ticks_to_us_floor64(std::uint64_t ticks) {
  return ticks * 1000000 / fake_zephyr().ticks_per_second;
}

bool pwm_is_ready_dt(const pwm_dt_spec* spec) {
  return fake_zephyr().is_ready && spec->channel < spec->dev->channels;
}

int pwm_set_pulse_dt(const pwm_dt_spec* spec, std::uint32_t pulse) {
  FakeZephyr& zephyr = fake_zephyr();
  ++zephyr.written;
  if (pulse > spec->period) return -22;
  if (zephyr.refuses.at(spec->channel)) return -5;
  zephyr.pulses.at(spec->channel) = pulse;
  if (pulse > 0 && zephyr.pulses.at(spec->channel ^ 1U) > 0) ++zephyr.both_high;
  return 0;
}
