// SPDX-License-Identifier: MIT
// Who feeds the watchdog, and how long it waits.

#include "platforms/stm32f405/drivers/watchdog.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace batuta::stm32f405 {
namespace {

TEST(WatchdogPolicy, TicksWithALivingGuard_Feed) {
  WatchdogPolicy policy;
  for (std::uint32_t tick = 1; tick < 1000; ++tick) EXPECT_TRUE(policy.on_tick(tick));
  EXPECT_EQ(policy.starved(), 0U);
}

TEST(WatchdogPolicy, DeadGuard_Starves) {
  WatchdogPolicy policy;
  EXPECT_TRUE(policy.on_tick(5));
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(policy.on_tick(5));
  EXPECT_EQ(policy.starved(), 20U);
  EXPECT_TRUE(policy.on_tick(6));
}

TEST(Watchdog, Started_WaitsNominallyTenMilliseconds) {
  Iwdg registers{};
  Watchdog watchdog(registers);
  watchdog.start();
  EXPECT_EQ(registers.pr, 0U);  // divided by 4
  const double nominal_s = 4.0 * (registers.rlr + 1) / 32000;
  EXPECT_NEAR(nominal_s, 0.010, 1e-9);
  EXPECT_EQ(registers.kr, Iwdg::kKrFeed);
  EXPECT_LE(registers.rlr, Iwdg::kRlrMax);
}

TEST(Watchdog, RegistersThatNeverAnswer_DoNotHangTheStart) {
  Iwdg registers{};
  registers.sr = Iwdg::kSrBusy;
  Watchdog(registers).start();
  EXPECT_EQ(registers.kr, Iwdg::kKrFeed);
}

TEST(Watchdog, OnlyATickWithALivingGuardFeeds) {
  Iwdg registers{};
  Watchdog watchdog(registers);
  registers.kr = 0;
  watchdog.on_tick(0);  // the guard has not run
  EXPECT_EQ(registers.kr, 0U);
  watchdog.on_tick(1);
  EXPECT_EQ(registers.kr, Iwdg::kKrFeed);
}

}  // namespace
}  // namespace batuta::stm32f405
