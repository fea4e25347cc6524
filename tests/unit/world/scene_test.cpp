// SPDX-License-Identifier: MIT
#include "batuta/world/scene.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace batuta {
namespace {

TEST(Scene, DefaultSettings_AreValid) {
  EXPECT_EQ(validate(WorldSettings<float>{}), Status::kOk);
  EXPECT_EQ(validate(WorldSettings<double>{}), Status::kOk);
}

TEST(Scene, EachOptionOutOfRange_IsRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) {
    WorldSettings<double> settings;
    settings.search.epsilon = bad;
    EXPECT_EQ(validate(settings), Status::kInvalidArgument);
    settings = {};
    settings.rest_speed = bad;
    EXPECT_EQ(validate(settings), Status::kInvalidArgument);
    settings = {};
    settings.separation = bad;
    EXPECT_EQ(validate(settings), Status::kInvalidArgument);
    settings = {};
    settings.min_separation_time = bad;
    EXPECT_EQ(validate(settings), Status::kInvalidArgument);
  }
  WorldSettings<double> settings;
  settings.search.max_steps = 0;
  EXPECT_EQ(validate(settings), Status::kInvalidArgument);
  settings = {};
  settings.search.halvings = -1;
  EXPECT_EQ(validate(settings), Status::kInvalidArgument);
  settings.search.halvings = kMaxHalvings + 1;
  EXPECT_EQ(validate(settings), Status::kInvalidArgument);
}

TEST(Scene, PairRestitution_IsThatOfTheBouncierBody) {
  EXPECT_EQ(pair_restitution(0.25, 0.5), 0.5);
  EXPECT_EQ(pair_restitution(0.5, 0.25), 0.5);
}

}  // namespace
}  // namespace batuta
