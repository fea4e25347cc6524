// SPDX-License-Identifier: MIT
#include "batuta/haptics/detail/encoder_grid.hpp"

#include <gtest/gtest.h>

#include "draws.hpp"
#include "shared/simulated/encoder.hpp"

namespace batuta {
namespace {

constexpr int kBlock = 100;

/// Slow at first, as a stroke is.
double way(test::Draws& draws, int i) {
  const double share = static_cast<double>(i % kBlock) / kBlock;
  return draws.between(-0.05, 0.05) * share * share;
}

TEST(EncoderGrid, Step_IsTheDivisorOfAllWays) {
  for (const double step : {1e-5, 3.0517578125e-5, 1e-3, 1.0 / 300, 0.05}) {
    test::Draws draws(53, 0, 0);
    detail::EncoderGrid grid;
    double place = 0;
    for (int i = 0; i < 2000; ++i) {
      place += way(draws, i);
      grid.take(static_cast<float>(port_simulated::encoded(std::sin(place), step)));
      if (i % kBlock == kBlock - 1) grid.end_block();
    }
    EXPECT_TRUE(grid.is_sure());
    EXPECT_NEAR(static_cast<double>(grid.step()), step, static_cast<double>(grid.error())) << step;
    EXPECT_LT(static_cast<double>(grid.error()), 1e-3 * step) << step;
  }
}

TEST(EncoderGrid, NoGrid_IsToldAsFinerThanCanBeTold) {
  test::Draws draws(54, 0, 0);
  detail::EncoderGrid grid;
  double place = 0;
  for (int i = 0; i < 2000; ++i) {
    place += way(draws, i);
    grid.take(static_cast<float>(std::sin(place)));
    if (i % kBlock == kBlock - 1) grid.end_block();
  }
  EXPECT_TRUE(grid.is_sure());
  EXPECT_EQ(grid.step(), 0.0F);
  EXPECT_LT(grid.error(), 1e-5F);
}

// One sample off the grid spoils its block; one in every block leaves nothing to tell.
TEST(EncoderGrid, StraySample_SpoilsItsBlockAlone) {
  constexpr double kStep = 1e-3;
  for (const int every : {5000, 100}) {
    test::Draws draws(55, 0, 0);
    detail::EncoderGrid grid;
    double place = 0;
    for (int i = 0; i < 2000; ++i) {
      place += draws.between(-0.02, 0.02);
      const double stray = i % every == 50 ? draws.between(0.1, 0.4) * kStep : 0;
      grid.take(static_cast<float>(port_simulated::encoded(std::sin(place), kStep) + stray));
      if (i % kBlock == kBlock - 1) grid.end_block();
    }
    EXPECT_TRUE(grid.is_known());
    if (every < 2000) {
      EXPECT_FALSE(grid.is_sure() && grid.step() > 0.0F);
      continue;
    }
    EXPECT_TRUE(grid.is_sure());
    EXPECT_NEAR(static_cast<double>(grid.step()), kStep, static_cast<double>(grid.error()));
  }
}

}  // namespace
}  // namespace batuta
