// SPDX-License-Identifier: MIT
// The order of the clocks' start, and where it ends when a part does not come up. The registers are
// memory: what "becomes ready" is ready from the beginning, or never.

#include "platforms/stm32f405/drivers/clock_start.hpp"

#include <gtest/gtest.h>

#include "platforms/stm32f405/board.hpp"

namespace batuta::stm32f405 {
namespace {

class ClockStartTest : public ::testing::Test {
 protected:
  ClockStartTest() {
    rcc_.cr = Rcc::kCrHsirdy | Rcc::kCrHserdy | Rcc::kCrPllrdy;
    rcc_.cfgr = Rcc::kCfgrSwsPll;
  }
  ClockStart start() { return start_clocks({rcc_, pwr_, flash_}, kClocks, 100); }
  bool switched() const { return (rcc_.cfgr & Rcc::kCfgrSwMask) == Rcc::kCfgrSwPll; }
  bool pll_on() const { return (rcc_.cr & Rcc::kCrPllon) != 0; }

  Rcc rcc_{};
  Pwr pwr_{};
  FlashInterface flash_{};
};

TEST_F(ClockStartTest, EverythingReady_RunsOnThePll) {
  EXPECT_EQ(start(), ClockStart::kRunning);
  EXPECT_TRUE(switched());
  EXPECT_EQ(flash_.acr, 0x705U);  // 5 wait states, prefetch, both caches
  EXPECT_EQ(rcc_.pllcfgr, pllcfgr_of(kClocks));
  EXPECT_EQ(rcc_.cfgr & kCfgrDividersMask, cfgr_dividers_of(kClocks));
  EXPECT_NE(rcc_.cr & Rcc::kCrCsson, 0U);
  EXPECT_NE(pwr_.cr & Pwr::kCrVos, 0U);
}

TEST_F(ClockStartTest, NoCrystal_StaysOnTheInternalOscillator) {
  rcc_.cr = Rcc::kCrHsirdy;
  EXPECT_EQ(start(), ClockStart::kNoCrystal);
  EXPECT_FALSE(switched());
  EXPECT_FALSE(pll_on());
}

TEST_F(ClockStartTest, NoPll_IsNotSwitchedTo) {
  rcc_.cr = Rcc::kCrHsirdy | Rcc::kCrHserdy;
  EXPECT_EQ(start(), ClockStart::kNoPll);
  EXPECT_TRUE(pll_on());
  EXPECT_FALSE(switched());
  EXPECT_EQ(flash_.acr & FlashInterface::kAcrLatencyMask, 5U);  // before the PLL, not after it
}

TEST_F(ClockStartTest, NoSwitch_IsNotWatchedNorTakenForRunning) {
  rcc_.cfgr = 0;
  EXPECT_EQ(start(), ClockStart::kNoSwitch);
  EXPECT_EQ(rcc_.cr & Rcc::kCrCsson, 0U);
}

TEST_F(ClockStartTest, NoClockControl_IsToldAndNothingIsTouched) {
  rcc_.cr = 0;
  EXPECT_EQ(start(), ClockStart::kAbsent);
  EXPECT_EQ(rcc_.cr, 0U);
  EXPECT_EQ(flash_.acr, 0U);
}

}  // namespace
}  // namespace batuta::stm32f405
