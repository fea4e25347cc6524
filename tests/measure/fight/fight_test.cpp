// SPDX-License-Identifier: MIT
// The parts of batuta-fight against exact truth: what a table says is worth what its tool is.

#include <gtest/gtest.h>

#include <cmath>

#include "search.hpp"

namespace {
using namespace fight;

constexpr double kExact = 1e-12;

Knobs committed() {
  Knobs knobs;
  EXPECT_EQ(knobs.load(BATUTA_FIGHT_KEYS), "");
  return knobs;
}

Triple doubles(const std::array<float, 3>& x) {
  return {double{x[0]}, double{x[1]}, double{x[2]}};
}

TEST(FightScript, MovesSmoothlyBetweenItsPlaces) {
  Script script;
  script.from = {0.2, -0.4};
  script.moves = {{0.1, 0.4, {1, 0.6}}};
  // s^2 (3 - 2 s) at 0, 1/4, 1/2, 3/4, 1: 0, 5/32, 1/2, 27/32, 1.
  constexpr std::array<double, 5> kShares = {0, 5.0 / 32, 0.5, 27.0 / 32, 1};
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    const Place place = script.at(0.1 + 0.1 * static_cast<double>(i));
    EXPECT_NEAR(place.x, 0.2 + 0.8 * kShares[i], kExact);
    EXPECT_NEAR(place.y, -0.4 + 1.0 * kShares[i], kExact);
  }
  EXPECT_EQ(script.at(0.05).x, 0.2);
  EXPECT_EQ(script.at(9).x, 1);
}

TEST(FightScript, LaterMoveTakesOverWithoutJump) {
  Script script;
  script.moves = {{0, 0.2, {1, 0}}, {0.1, 0.2, {0, 1}}};
  EXPECT_NEAR(script.at(0.1).x, 0.5, kExact);
  EXPECT_NEAR(script.at(0.1).y, 0, kExact);
  // Half way of the second: half of what the first has then come to.
  EXPECT_NEAR(script.at(0.2).x, 0.5, kExact);
  EXPECT_NEAR(script.at(0.2).y, 0.5, kExact);
  EXPECT_NEAR(script.at(0.3).y, 1, kExact);
}

TEST(FightScript, SaysOfAStepWhatADeviceWould) {
  Script script;
  script.moves = {{0, 0.001, {1.5, -2}}};
  script.feet = {{0.010, -1}, {0.020, 0.5}};
  const auto sample = script.sample(15);
  EXPECT_EQ(sample.time, 15000);
  EXPECT_EQ(sample.sequence, 15U);
  EXPECT_EQ(sample.x, 1.0F);
  EXPECT_EQ(sample.y, -1.0F);
  EXPECT_EQ(sample.feet_y, -1.0F);
  EXPECT_EQ(script.sample(9).feet_y, 0.0F);
  EXPECT_EQ(script.sample(20).feet_y, 0.5F);
}

TEST(FightJitter, Splitmix64IsThePublishedOne) {
  Random random(1234567);  // the vectors of the reference implementation
  EXPECT_EQ(random.next(), 6457827717110365317U);
  EXPECT_EQ(random.next(), 3203168211198807973U);
  EXPECT_EQ(random.next(), 9817491932198370423U);
}

/// Extremes of what is drawn.
struct Range {
  double least = 1e9;
  double most = -1e9;

  void add(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
  /// All within [from, to], and to within 2 % of either end.
  void expect(double from, double to) const {
    const double slack = 0.02 * (to - from);
    EXPECT_GE(least, from);
    EXPECT_LE(least, from + slack);
    EXPECT_LE(most, to);
    EXPECT_GE(most, to - slack);
  }
};

TEST(FightJitter, FillsItsRanges) {
  Range distance, start, x, y, duration;
  int heads = 0;
  constexpr int kDraws = 2000;
  Jitter jitter(1);
  for (int i = 0; i < kDraws; ++i) {
    distance.add(jitter.distance(2.25));
    start.add(jitter.start(0.1));
    const Place place = jitter.place({-1, 0.5});
    x.add(place.x);
    y.add(place.y);
    duration.add(jitter.duration(0.3));
    heads += jitter.coin() ? 1 : 0;
  }
  distance.expect(2.21, 2.29);
  start.expect(0.085, 0.115);
  x.expect(-1.03, -0.97);
  y.expect(0.47, 0.53);
  duration.expect(0.27, 0.33);
  EXPECT_NEAR(heads, kDraws / 2, 4 * std::sqrt(kDraws) / 2);  // four standard deviations
}

TEST(FightJitter, ParryBeginsWithinItsWindow) {
  Range shares;
  Jitter jitter(2);
  for (int i = 0; i < 2000; ++i) {
    const Move attack = lunge(jitter, Line::kLowInside, kStart);
    const Move answer = parry(jitter, Line::kLowInside, attack, kInTime);
    shares.add((answer.start - attack.start) / attack.duration);
    EXPECT_NEAR(answer.to.x, -1, kPlaceJitter);
    EXPECT_NEAR(answer.to.y, -1, kPlaceJitter);
  }
  shares.expect(0.3, 0.5);
}

TEST(FightKeys, TurnBringsXOntoTheAim) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Triple aim = {random.between(-0.5, 1), random.between(-1, 1), random.between(-1, 1)};
    const double length = std::sqrt(aim[0] * aim[0] + aim[1] * aim[1] + aim[2] * aim[2]);
    const Triple turn = turn_onto(aim);
    // Rodrigues with x, whose dot product with the axis is 0: cos x + sin (axis * x).
    const double angle = std::hypot(turn[1], turn[2]);
    const Triple got = {std::cos(angle), std::sin(angle) * turn[2] / angle,
                        -std::sin(angle) * turn[1] / angle};
    const Triple said = aim_of(turn);
    EXPECT_EQ(turn[0], 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(got[axis], aim[axis] / length, kExact);
      EXPECT_NEAR(said[axis], aim[axis] / length, kExact);
    }
  }
  EXPECT_EQ(turn_onto({1, 0, 0}), (Triple{0, 0, 0}));
  EXPECT_EQ(aim_of({0, 0, 0}), (Triple{1, 0, 0}));
}

TEST(FightKeys, LieWhereTheKnobsSay) {
  const Knobs knobs = committed();
  const Keys keys = keys_from(knobs);
  const auto key = [&keys](int column, int row) {
    return keys[static_cast<std::size_t>(column + kColumns * row)];
  };
  constexpr double kRounding = 0.51e-4;
  EXPECT_NEAR(double{key(4, 2).hand_F[1]}, knobs.at("guard.hand.y"), kRounding);
  EXPECT_NEAR(double{key(0, 2).hand_F[2]}, knobs.at("quarte.hand.z"), kRounding);
  EXPECT_NEAR(double{key(8, 0).hand_F[0]}, knobs.at("octave.hand.x"), kRounding);
  EXPECT_EQ(double{key(4, 0).feet}, knobs.at("retreat.feet"));
  EXPECT_EQ(double{key(4, 1).feet}, knobs.at("retreat.half_feet"));
  // What is asked of the feet elsewhere is none, between the keys as well.
  const batuta::fencing::FencerMap<float> map{keys.data(), kColumns, kRows};
  for (int i = 0; i <= 40; ++i) {
    const float x = -1 + 0.05F * static_cast<float>(i);
    for (const float y : {0.0F, 0.3F, 0.6F, 1.0F}) {
      EXPECT_EQ(batuta::fencing::feet_at<float>(map, {x, y}), 0) << x << ", " << y;
    }
  }
  EXPECT_EQ(batuta::fencing::feet_at<float>(map, {0, -1}), -1);
  EXPECT_EQ(batuta::fencing::feet_at<float>(map, {0, -0.5F}), -1);
  // The parry's blade points along (1, y, z).
  const Triple aim = aim_of(doubles(key(0, 2).turn_F));
  EXPECT_NEAR(aim[1] / aim[0], knobs.at("quarte.aim.y"), 1e-3);
  EXPECT_NEAR(aim[2] / aim[0], knobs.at("quarte.aim.z"), 1e-3);
}

TEST(FightKeys, LungesPointAtTheirSpots) {
  const Knobs knobs = committed();
  const Keys keys = keys_from(knobs);
  constexpr std::array<const char*, 4> kNames = {"high_inside", "low_inside", "low_outside",
                                                 "high_outside"};
  constexpr std::array<std::size_t, 4> kPlaces = {0, 2, 6, 8};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const MapKey& key = keys[4 * kColumns + kPlaces[i]];
    const std::string spot = std::string(kNames[i]) + ".spot";
    const Triple aim = aim_of(doubles(key.turn_F));
    const double reach = (2.25 - knobs.at(spot + ".x") - double{key.hand_F[0]}) / aim[0];
    EXPECT_NEAR(double{key.hand_F[1]} + reach * aim[1], -knobs.at(spot + ".y"), 2e-4) << kNames[i];
    EXPECT_NEAR(double{key.hand_F[2]} + reach * aim[2], knobs.at(spot + ".z"), 2e-4) << kNames[i];
  }
}

TEST(FightKnobs, AreReadAndRefused) {
  const Knobs knobs = committed();
  const std::string path = testing::TempDir() + "/knobs.txt";
  ASSERT_EQ(knobs.save(path), "");
  Knobs again;
  ASSERT_EQ(again.load(path), "");
  std::string all;
  for (std::size_t i = 0; i < fight::knobs().size(); ++i) {
    EXPECT_EQ(again[i], knobs[i]);
    all += fight::knobs()[i].name + "=1\n";
  }
  EXPECT_EQ(again.parse(all), "");
  EXPECT_NE(again.parse(all + "guard.hand.x=1\n"), "");
  EXPECT_NE(again.parse(all + "nobody=1\n"), "");
  EXPECT_NE(again.parse("guard.hand.x=1\n"), "");
  EXPECT_NE(again.parse(all.replace(all.find("=1"), 2, "=x")), "");
  EXPECT_EQ(again[0], 1) << "what was refused changes nothing";
  EXPECT_NE(again.load("/nowhere"), "");
  EXPECT_NE(knobs.save(testing::TempDir() + "/nowhere/knobs.txt"), "");
}

TEST(FightSearch, MovesFewKnobsAndOnlyThoseItMay) {
  const Knobs start = committed();
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Knobs next = moved(start, random);
    int changed = 0;
    for (std::size_t k = 0; k < knobs().size(); ++k) {
      if (next[k] == start[k]) continue;
      ++changed;
      EXPECT_GT(knobs()[k].step, 0);
      EXPECT_LE(std::abs(next[k] - start[k]), 3 * 3 * knobs()[k].step);
    }
    EXPECT_GE(changed, 1);
    EXPECT_LE(changed, 3);
  }
}

/// What the tool measures with its file of knobs is what the library fences with.
TEST(FightKeys, AreThoseOfTheLibrary) {
  const Keys keys = keys_from(committed());
  const auto& map = batuta::fencing::library_map<float>();
  ASSERT_EQ(map.columns, kColumns);
  ASSERT_EQ(map.rows, kRows);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(keys[i].hand_F, map.keys[i].hand_F) << i;
    EXPECT_EQ(keys[i].turn_F, map.keys[i].turn_F) << i;
    EXPECT_EQ(keys[i].feet, map.keys[i].feet) << i;
  }
}

}  // namespace
