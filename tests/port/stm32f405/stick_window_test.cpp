// SPDX-License-Identifier: MIT
// Sums of conversions, and what is a stick.

#include "shared/drivers/stick_window.hpp"

#include <gtest/gtest.h>

#include <array>

namespace batuta::stm32f405 {
using namespace drivers;  // what boards share
namespace {

using Window = std::array<std::uint16_t, kWindowCounts>;

Window filled(std::uint16_t x, std::uint16_t y) {
  Window window{};
  for (std::size_t i = 0; i < window.size(); i += 2) {
    window[i] = x;
    window[i + 1] = y;
  }
  return window;
}

TEST(StickWindow, Sums_AreOfEachAxisAlone) {
  Window window{};
  std::int32_t x = 0;
  std::int32_t y = 0;
  for (std::size_t i = 0; i < window.size(); i += 2) {
    window[i] = static_cast<std::uint16_t>(100 + 7 * i);
    window[i + 1] = static_cast<std::uint16_t>(4000 - 11 * i);
    x += window[i];
    y += window[i + 1];
  }
  const StickReading sum = sum_window(window.data());
  EXPECT_EQ(sum.x, x);
  EXPECT_EQ(sum.y, y);
  EXPECT_TRUE(sum.plausible);
}

TEST(StickWindow, RangeOfAStick_HasItsEndsInside) {
  EXPECT_TRUE(sum_window(filled(kLowestCount, kHighestCount).data()).plausible);
  EXPECT_FALSE(sum_window(filled(kLowestCount - 1, 2000).data()).plausible);
  EXPECT_FALSE(sum_window(filled(2000, kHighestCount + 1).data()).plausible);
}

TEST(StickWindow, OneConversionOutside_SpoilsTheWindow) {
  for (std::size_t i = 0; i < kWindowCounts; ++i) {
    Window window = filled(2000, 2000);
    window[i] = 0;
    EXPECT_FALSE(sum_window(window.data()).plausible) << i;
  }
}

TEST(Connection, GoodReadingsInARow_Connect) {
  Connection connection;
  for (int i = 0; i < Connection::kReturnAfter; ++i) {
    EXPECT_FALSE(connection.connected());
    connection.note(true);
  }
  EXPECT_TRUE(connection.connected());
  EXPECT_EQ(connection.losses(), 0U);
}

TEST(Connection, OneBadReading_PartsUntilAllIsGoodAgain) {
  Connection connection;
  for (int i = 0; i < Connection::kReturnAfter; ++i) connection.note(true);
  connection.note(false);
  EXPECT_FALSE(connection.connected());
  EXPECT_EQ(connection.losses(), 1U);
  for (int i = 0; i < 10 * Connection::kReturnAfter; ++i) connection.note(i % 50 != 0);  // loose
  EXPECT_FALSE(connection.connected());
  EXPECT_EQ(connection.losses(), 1U);
}

}  // namespace
}  // namespace batuta::stm32f405
