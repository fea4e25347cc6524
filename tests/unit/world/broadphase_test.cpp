// SPDX-License-Identifier: MIT
#include "batuta/world/broadphase.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace batuta {
namespace {

Proxy<float> box_at(float x) {
  Proxy<float> proxy;
  proxy.swept_W = kdop_of<float, 6>(Capsule<float>::sphere({x, 0, 0}, 0.5F));
  proxy.present = true;
  return proxy;
}

using Pairs = std::vector<std::pair<int, int>>;

template <std::size_t N>
Pairs pairs_of(const std::array<Proxy<float>, N>& proxies) {
  Pairs pairs;
  for_each_pair(proxies, [&](BodyPair pair) { pairs.emplace_back(pair.first, pair.second); });
  return pairs;
}

TEST(Broadphase, OverlappingBoxes_InAscendingOrder) {
  const std::array<Proxy<float>, 4> row = {box_at(0), box_at(0.9F), box_at(1.8F), box_at(5)};
  EXPECT_EQ(pairs_of(row), (Pairs{{0, 1}, {1, 2}}));
}

TEST(Broadphase, EmptySlots_AreSkipped) {
  std::array<Proxy<float>, 3> row = {box_at(0), box_at(0), box_at(0)};
  row[1].present = false;
  EXPECT_EQ(pairs_of(row), (Pairs{{0, 2}}));
  row[0].present = false;
  EXPECT_TRUE(pairs_of(row).empty());
}

TEST(Broadphase, OneOwner_NeverMeets_ButZeroIsNobody) {
  std::array<Proxy<float>, 2> row = {box_at(0), box_at(0)};
  EXPECT_EQ(pairs_of(row).size(), 1U);
  row[0].owner = row[1].owner = 7;
  EXPECT_TRUE(pairs_of(row).empty());
  row[1].owner = 8;
  EXPECT_EQ(pairs_of(row).size(), 1U);
}

TEST(Broadphase, TwoWalls_NeverMeet) {
  std::array<Proxy<float>, 2> row = {box_at(0), box_at(0)};
  row[0].is_wall = true;
  EXPECT_EQ(pairs_of(row).size(), 1U);
  row[1].is_wall = true;
  EXPECT_TRUE(pairs_of(row).empty());
}

}  // namespace
}  // namespace batuta
