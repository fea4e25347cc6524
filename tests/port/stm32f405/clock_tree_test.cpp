// SPDX-License-Identifier: MIT
// The clocks' arithmetic against the reference manual's tables and worked numbers.

#include "platforms/stm32f405/drivers/clock_tree.hpp"

#include <gtest/gtest.h>

#include "platforms/stm32f405/board.hpp"

namespace batuta::stm32f405 {
namespace {

TEST(ClockTree, Board_HasTheFrequenciesOfTheIssue) {
  EXPECT_EQ(kClocks.sysclk_hz(), 168000000U);
  EXPECT_EQ(kClocks.pclk1_hz(), 42000000U);
  EXPECT_EQ(kClocks.pclk2_hz(), 84000000U);
  EXPECT_EQ(kClocks.timers1_hz(), 84000000U);
  EXPECT_EQ(kClocks.timers2_hz(), 168000000U);
  EXPECT_EQ(kClocks.usb_hz(), 48000000U);
}

TEST(ClockTree, Registers_HoldTheFieldsAtTheirPlaces) {
  // PLLQ 7 at 24, source HSE at 22, PLLP code 0 at 16, PLLN 168 at 6, PLLM 4 at 0.
  EXPECT_EQ(pllcfgr_of(kClocks), 0x07402A04U);
  // PPRE2 100 (two) at 13, PPRE1 101 (four) at 10.
  EXPECT_EQ(cfgr_dividers_of(kClocks), 0x9400U);
  ClockTree slow = kClocks;
  slow.pll_p = 8;
  EXPECT_EQ(pllcfgr_of(slow) & 0x30000U, 0x30000U);
}

TEST(ClockTree, WaitStates_AreThoseOfTheTable) {
  struct Row {
    std::uint32_t highest_mhz, wait_states;
  };
  for (const Row row : {Row{30, 0}, {60, 1}, {90, 2}, {120, 3}, {150, 4}, {168, 5}}) {
    EXPECT_EQ(flash_wait_states(row.highest_mhz * 1000000U), row.wait_states);
  }
  EXPECT_EQ(flash_wait_states(30000001U), 1U);
  EXPECT_EQ(flash_wait_states(150000001U), 5U);
}

TEST(ClockTree, EachLimit_IsSeen) {
  const auto with = [](std::uint32_t ClockTree::*field, std::uint32_t value) {
    ClockTree tree = kClocks;
    tree.*field = value;
    return tree;
  };
  EXPECT_TRUE(is_valid(kClocks));
  EXPECT_FALSE(is_valid(with(&ClockTree::hse_hz, 3000000)));   // below what a crystal may have
  EXPECT_FALSE(is_valid(with(&ClockTree::hse_hz, 30000000)));  // above
  EXPECT_FALSE(is_valid(with(&ClockTree::hse_hz, 8000001)));   // not exact
  EXPECT_FALSE(is_valid(with(&ClockTree::pll_m, 3)));          // not exact, and above 2 MHz
  EXPECT_FALSE(is_valid(with(&ClockTree::pll_m, 16)));         // 0.5 MHz into the PLL
  EXPECT_FALSE(is_valid(with(&ClockTree::pll_n, 170)));        // 170 MHz
  EXPECT_FALSE(is_valid(with(&ClockTree::pll_n, 433)));
  EXPECT_FALSE(is_valid(with(&ClockTree::pll_p, 3)));  // no such divider
  EXPECT_FALSE(is_valid(with(&ClockTree::pll_q, 6)));  // 56 MHz for USB
  EXPECT_FALSE(is_valid(with(&ClockTree::apb1, 2)));   // 84 MHz on APB1
  EXPECT_FALSE(is_valid(with(&ClockTree::apb1, 3)));
  EXPECT_FALSE(is_valid(with(&ClockTree::apb2, 1)));  // 168 MHz on APB2
}

TEST(ClockTree, OtherCrystals_HaveATree) {
  for (const std::uint32_t mhz : {8U, 12U, 16U, 24U}) {
    EXPECT_TRUE(is_valid({mhz * 1000000U, mhz / 2, 168, 2, 7, 4, 2})) << mhz;
  }
  EXPECT_TRUE(is_valid({25000000, 25, 336, 2, 7, 4, 2}));
}

TEST(ClockTree, BaudRate_IsTheNearestDivider) {
  EXPECT_EQ(brr_of(84000000, 3000000), 28U);
  EXPECT_EQ(baud_error_ppm(84000000, 3000000), 0);
  EXPECT_EQ(brr_of(84000000, 115200), 729U);  // 45.5625 * 16
  EXPECT_NEAR(static_cast<double>(baud_error_ppm(84000000, 115200)), 228.6, 1.0);
  EXPECT_EQ(brr_of(16000000, 115200), 139U);  // 8.6875 * 16
}

}  // namespace
}  // namespace batuta::stm32f405
