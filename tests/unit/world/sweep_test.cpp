// SPDX-License-Identifier: MIT
#include "batuta/world/detail/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace batuta {
using namespace detail;
namespace {

using Box = Aabb<float>;
using Pairs = std::vector<std::pair<int, int>>;
constexpr float kLowest = std::numeric_limits<float>::lowest();
constexpr float kMax = std::numeric_limits<float>::max();

Box box_of(float x, float y, float half) {
  Box box;
  box.low = {x - half, y - half, -half};
  box.high = {x + half, y + half, half};
  return box;
}

Box unbounded() {
  Box box;
  box.low = {kLowest, kLowest, kLowest};
  box.high = {kMax, kMax, kMax};
  return box;
}

/// The definition: intervals on all three axes have a point in common.
bool meet(const Box& P, const Box& Q) {
  bool meets = true;
  for (std::size_t i = 0; i < 3; ++i) {
    meets = meets && std::max(P.low[i], Q.low[i]) <= std::min(P.high[i], Q.high[i]);
  }
  return meets;
}

/// A list under test and what it should hold.
template <int N, int kAxis = 0>
class Checked {
 public:
  void set(int slot, const Box& box, bool idle) {
    list_.set(static_cast<std::uint16_t>(slot), box, idle);
    boxes_[at(slot)] = box;
    idle_[at(slot)] = idle;
    present_[at(slot)] = true;
  }
  void remove(int slot) {
    list_.remove(static_cast<std::uint16_t>(slot));
    present_[at(slot)] = false;
  }
  void sort() { list_.sort(); }

  Pairs pairs() const {
    Pairs pairs;
    list_.for_each_pair([&](ProxyPair pair) { pairs.emplace_back(pair.first, pair.second); });
    return pairs;
  }
  /// @returns the number of pairs
  int expect_true_pairs() const {
    Pairs found = pairs();
    std::sort(found.begin(), found.end());
    Pairs truth;
    for (int i = 0; i < N; ++i) {
      for (int k = i + 1; k < N; ++k) {
        if (overlap(i, k) && !(idle_[at(i)] && idle_[at(k)])) truth.emplace_back(i, k);
      }
    }
    EXPECT_EQ(found, truth);
    return static_cast<int>(truth.size());
  }
  void expect_true_partners() const {
    for (int i = 0; i < N; ++i) {
      ASSERT_EQ(list_.contains(static_cast<std::uint16_t>(i)), present_[at(i)]);
      if (!present_[at(i)]) continue;
      ASSERT_EQ(list_.is_idle(static_cast<std::uint16_t>(i)), idle_[at(i)]);
      ASSERT_EQ(list_.box(static_cast<std::uint16_t>(i)).low, boxes_[at(i)].low);
      std::multiset<int> found;
      list_.for_each_partner(static_cast<std::uint16_t>(i), [&](int k) { found.insert(k); });
      std::multiset<int> truth;
      for (int k = 0; k < N; ++k) {
        if (k != i && overlap(i, k)) truth.insert(k);
      }
      ASSERT_EQ(found, truth) << "slot " << i;
    }
  }

 private:
  static std::size_t at(int slot) { return static_cast<std::size_t>(slot); }
  bool overlap(int i, int k) const {
    return present_[at(i)] && present_[at(k)] && meet(boxes_[at(i)], boxes_[at(k)]);
  }

  SweepList<float, N, kAxis> list_;
  std::array<Box, static_cast<std::size_t>(N)> boxes_;
  std::array<bool, static_cast<std::size_t>(N)> idle_{};
  std::array<bool, static_cast<std::size_t>(N)> present_{};
};

/// Whole numbers: boxes touch, coincide and have the same low ends often.
class Draw {
 public:
  int below(int n) { return static_cast<int>(source_() % static_cast<unsigned>(n)); }
  Box box(int room) {
    if (below(40) == 0) return unbounded();
    const float half = below(10) == 0 ? static_cast<float>(below(room)) : 1.0F;
    return box_of(static_cast<float>(below(room)), static_cast<float>(below(4)), half);
  }

 private:
  std::mt19937 source_{20061107};
};

/// Steps in which some boxes move, come, go, fall asleep and wake; within a step some move again.
template <int N, int kAxis = 0>
int live(int room, int steps) {
  Draw draw;
  Checked<N, kAxis> list;
  int pairs = 0;
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    for (int i = draw.below(N + 1); i > 0; --i) {
      const int slot = draw.below(N);
      draw.below(5) == 0 ? list.remove(slot) : list.set(slot, draw.box(room), draw.below(3) == 0);
    }
    list.expect_true_partners();
    list.sort();
    pairs += list.expect_true_pairs();
    list.expect_true_partners();
  }
  return pairs;
}

TEST(Sweep, LivingScene_FindsWhatEachWithEachFinds) {
  EXPECT_GT(live<2>(4, 2000), 100);
  EXPECT_GT(live<8>(8, 1000), 1000);
  EXPECT_GT(live<9>(8, 1000), 1000);
  EXPECT_GT(live<16>(16, 500), 1000);
  EXPECT_GT(live<17>(16, 500), 1000);
  EXPECT_GT(live<100>(200, 100), 1000);
  EXPECT_GT((live<40, 1>(40, 200)), 1000);
  EXPECT_GT((live<40, 2>(40, 200)), 1000);
}

/// Fills a list with the boxes and checks it.
template <class BoxAt>
int pairs_among(const BoxAt& box_at) {
  constexpr int kN = 64;
  Checked<kN> list;
  for (int i = 0; i < kN; ++i) list.set(i, box_at(i), i % 5 == 0);
  list.expect_true_partners();
  list.sort();
  list.expect_true_partners();
  return list.expect_true_pairs();
}

TEST(Sweep, AnyArrangement_FindsWhatEachWithEachFinds) {
  const auto x = [](int i) { return static_cast<float>(i); };
  EXPECT_EQ(pairs_among([&](int i) { return box_of(x(i), 0, 0.25F); }), 0);
  EXPECT_GT(pairs_among([&](int i) { return box_of(x(i), 0, 1); }), 60);
  EXPECT_GT(pairs_among([&](int i) { return box_of(x(63 - i), 0, 1); }), 60);
  EXPECT_GT(pairs_among([&](int) { return box_of(3, 3, 1); }), 1900);
  EXPECT_GT(pairs_among([&](int i) { return box_of(0, 0, x(i)); }), 1900);
  EXPECT_GT(pairs_among([&](int) { return unbounded(); }), 1900);
  EXPECT_GT(pairs_among([&](int i) { return i % 7 ? box_of(x(i), 0, 0.25F) : unbounded(); }), 100);
}

TEST(Sweep, Order_DependsOnTheBoxesAlone) {
  constexpr int kN = 40;
  const auto x = [](int i) { return static_cast<float>(i % 4); };
  Checked<kN> fresh;
  Checked<kN> with_a_past;
  for (int i = 0; i < kN; ++i) {
    fresh.set(i, box_of(x(i), 0, 1), i % 3 == 0);
    with_a_past.set(i, box_of(static_cast<float>(-i), 0, 1), true);
  }
  with_a_past.sort();
  for (int i = 0; i < kN; ++i) with_a_past.set(i, box_of(x(i), 0, 1), i % 3 == 0);
  fresh.sort();
  with_a_past.sort();
  EXPECT_EQ(fresh.pairs(), with_a_past.pairs());
  EXPECT_FALSE(fresh.pairs().empty());
}

TEST(Sweep, EmptyList_HasNoPairs) {
  Checked<2> two;
  Checked<32> many;
  many.sort();
  two.remove(1);
  many.remove(31);
  EXPECT_TRUE(two.pairs().empty());
  EXPECT_TRUE(many.pairs().empty());
}

TEST(Sweep, SharedFaces_Count) {
  Checked<kFewBoxes + 1> list;
  list.set(0, box_of(0, 0, 1), false);
  list.set(1, box_of(2, 0, 1), false);
  list.set(2, box_of(4.001F, 0, 1), false);
  list.sort();
  EXPECT_EQ(list.pairs(), (Pairs{{0, 1}}));
}

}  // namespace
}  // namespace batuta
