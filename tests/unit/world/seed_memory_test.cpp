// SPDX-License-Identifier: MIT
#include "batuta/world/detail/seed_memory.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace batuta {
using namespace detail;
namespace {

Vec3<float> normal_of(ProxyPair pair) {
  return {static_cast<float>(pair.first) + 1, static_cast<float>(pair.second), 0};
}

TEST(SeedMemory, Fresh_KnowsNothing) {
  const SeedMemory<float, 3> memory;
  EXPECT_EQ(memory.recall({0, 1}), (Vec3<float>(0, 0, 0)));
  EXPECT_EQ(memory.recall({1, 2}), (Vec3<float>(0, 0, 0)));
}

TEST(SeedMemory, RoomForAllPairs_EachHasItsOwnPlace) {
  constexpr std::uint16_t kBodies = 8;
  SeedMemory<float, kBodies*(kBodies - 1) / 2> memory;
  for (std::uint16_t b = 1; b < kBodies; ++b) {
    for (std::uint16_t a = 0; a < b; ++a) memory.remember({a, b}, normal_of({a, b}));
  }
  for (std::uint16_t b = 1; b < kBodies; ++b) {
    for (std::uint16_t a = 0; a < b; ++a) EXPECT_EQ(memory.recall({a, b}), normal_of({a, b}));
  }
}

TEST(SeedMemory, SharedPlace_NeverGivesTheNormalOfAnotherPair) {
  SeedMemory<float, 1> memory;
  memory.remember({0, 1}, normal_of({0, 1}));
  EXPECT_EQ(memory.recall({0, 1}), normal_of({0, 1}));
  EXPECT_EQ(memory.recall({0, 2}), (Vec3<float>(0, 0, 0)));
  memory.remember({0, 2}, normal_of({0, 2}));
  EXPECT_EQ(memory.recall({0, 1}), (Vec3<float>(0, 0, 0)));
}

// A scene whose search takes no seed pays nothing for it.
using SlidingScene = Scene<two_blades, Translation<float>>;
static_assert(sizeof(World<SlidingScene>) + sizeof(SeedMemory<float, 1>) ==
              sizeof(World<TwoBlades>));

}  // namespace
}  // namespace batuta
