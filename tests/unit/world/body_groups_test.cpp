// SPDX-License-Identifier: MIT
// Groups of bodies, against labels that are painted over one by one; and the record of changes.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "batuta/world/detail/body_changes.hpp"
#include "batuta/world/detail/body_groups.hpp"
#include "batuta/world/scene.hpp"

namespace batuta {
namespace {

constexpr SceneOptions crowd_options() {
  SceneOptions scene;
  scene.max_bodies = 40;
  scene.max_pairs = 64;
  scene.max_contacts = 8;
  return scene;
}
using Crowd = Scene<crowd_options>;
constexpr std::size_t kBodies = 40;

/// Each body's group by the name of its lowest: joining paints all of one over.
struct Labels {
  Labels() : lowest(kBodies), held(kBodies, false) {
    for (std::size_t i = 0; i < kBodies; ++i) lowest[i] = i;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t p = lowest[a], q = lowest[b];
    for (std::size_t& label : lowest) {
      if (label == p || label == q) label = std::min(p, q);
    }
  }
  std::vector<std::size_t> lowest;
  std::vector<bool> held;
};

TEST(BodyGroups, AreNamedByTheirLowest_WhateverTheOrderOfJoining) {
  std::mt19937 random(1);
  detail::BodyGroups<Crowd> groups;
  for (int run = 0; run < 50; ++run) {
    Labels labels;
    groups.clear();
    for (int i = 0; i < run; ++i) {
      const std::size_t a = random() % kBodies, b = random() % kBodies;
      groups.join(a, b);
      labels.join(a, b);
      for (std::size_t k = 0; k < kBodies; ++k) ASSERT_EQ(groups.root_of(k), labels.lowest[k]);
    }
  }
}

TEST(BodyGroups, WhoIsHeld_HoldsTheGroup_AndNoOther) {
  std::mt19937 random(2);
  detail::BodyGroups<Crowd> groups;
  int held = 0, free = 0;
  for (int run = 0; run < 50; ++run) {
    Labels labels;
    groups.clear();
    for (int i = 0; i < 20; ++i) {
      const std::size_t a = random() % kBodies, b = random() % kBodies;
      groups.join(a, b);
      labels.join(a, b);
    }
    for (int i = 0; i < 5; ++i) {
      const std::size_t slot = random() % kBodies;
      groups.hold(slot);
      labels.held[labels.lowest[slot]] = true;
    }
    for (std::size_t k = 0; k < kBodies; ++k) {
      const bool is_held = labels.held[labels.lowest[k]];
      ASSERT_EQ(groups.is_held(groups.root_of(k)), is_held);
      ++(is_held ? held : free);
    }
  }
  EXPECT_GT(held, 100);
  EXPECT_GT(free, 100);
}

TEST(BodyChanges, MarkOnce_TellsWho) {
  detail::BodyChanges<Crowd> changes;
  changes.mark(7);
  changes.mark(3);
  changes.seen[2] = 1;
  changes.is_struck[2] = true;
  ASSERT_EQ(changes.dirty.size(), 2);
  EXPECT_EQ(changes.dirty[0], 7);
  EXPECT_EQ(changes.dirty[1], 3);
  for (std::size_t k = 0; k < kBodies; ++k) {
    EXPECT_EQ(changes.is_dirty[k], k == 3 || k == 7);
  }
  changes.clear();
  EXPECT_TRUE(changes.dirty.empty());
  for (std::size_t k = 0; k < kBodies; ++k) {
    EXPECT_FALSE(changes.is_dirty[k]);
    EXPECT_EQ(changes.changed[k], 0);
  }
  EXPECT_EQ(changes.seen[2], detail::BodyChanges<Crowd>::kNever);
  EXPECT_FALSE(changes.is_struck[2]);
}

}  // namespace
}  // namespace batuta
