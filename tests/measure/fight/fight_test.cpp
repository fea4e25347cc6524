// SPDX-License-Identifier: MIT
// The parts of batuta-fight against exact truth: what a table says is worth what its tool is.

#include <gtest/gtest.h>

#include <cmath>

#include <sstream>

#include "fencers.hpp"
#include "figure.hpp"
#include "search.hpp"
#include "table.hpp"

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
  ASSERT_TRUE(knobs.save(path));
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
}

Case parry_case(int line, int answer) {
  return {Situation::kParry, static_cast<Line>(line), static_cast<Line>(answer)};
}

Tally stopped(int count) {
  Tally tally;
  tally.tries = 10;
  tally.stopped = count;
  return tally;
}

TEST(FightTable, MeansAndExtremesOfMadeUpCounts) {
  std::vector<Case> cases;
  std::vector<Tally> tallies;
  for (int line = 0; line < kLines; ++line) {
    for (int answer = 0; answer < kLines; ++answer) {
      cases.push_back(parry_case(line, answer));
      tallies.push_back(stopped(line == answer ? 10 - line : line));
      tallies.back().entered = line == answer ? line : 10;
    }
  }
  tallies[3].deepest = 0.002;
  tallies[3].in_weapon = 1;
  tallies[5].out_of_control = 2;
  tallies[6].incomplete = 7;
  const Table table = table_of(cases, tallies);
  EXPECT_NEAR(spread_of(right_parries(table)).mean, 85, kExact);  // 100 90 80 70
  EXPECT_NEAR(spread_of(right_parries(table)).least, 70, kExact);
  EXPECT_NEAR(spread_of(table.entered).mean, 15, kExact);
  EXPECT_NEAR(wrong_parries(table).mean, 15, kExact);  // 0 10 20 30, three times each
  EXPECT_NEAR(wrong_parries(table).most, 30, kExact);
  EXPECT_NEAR(table.deepest, 2, kExact);
  EXPECT_EQ(table.in_weapon, 1);
  EXPECT_EQ(table.out_of_control, 2);
  EXPECT_EQ(table.incomplete, 7);
}

TEST(FightTable, RipostesCountOfTheParriesThatHeld) {
  Tally tally;
  tally.tries = 10;
  tally.ripostes = 8;
  tally.landed = 6;
  const Case what = {Situation::kRiposteStays, Line::kLowOutside, Line::kHighInside};
  EXPECT_NEAR(table_of({what}, {tally}).riposte[2], 75, kExact);
}

TEST(FightTable, BeatsCountInPoints) {
  std::vector<Case> cases;
  std::vector<Tally> tallies;
  for (int line = 0; line < kLines; ++line) {
    cases.push_back({Situation::kBeat, static_cast<Line>(line), static_cast<Line>(line)});
    tallies.push_back(stopped(4));
    tallies.back().beats = 5;
    cases.push_back({Situation::kMissedBeat, static_cast<Line>(line), static_cast<Line>(line)});
    tallies.push_back(stopped(9));
  }
  const Table table = table_of(cases, tallies);
  EXPECT_NEAR(beat_gain(table), 50, kExact);
  EXPECT_NEAR(table.beats, 50, kExact);
  EXPECT_NEAR(table.false_beats, 0, kExact);
}

TEST(FightTable, CountsWhatATrialBrought) {
  const Case what = {Situation::kRiposteStays, Line::kHighInside, Line::kHighInside};
  Plan plan;
  plan.scripts[kDefender].moves = {{0.2, 0.1, {}}, {0.5, 0.25, {}}};
  Tally tally;
  Outcome landed;
  landed.by[kDefender].touched = 0.6;
  count(what, plan, landed, tally);
  Outcome too_early;  // by the parry itself: no riposte
  too_early.by[kDefender].touched = 0.4;
  count(what, plan, too_early, tally);
  Outcome remise;
  remise.by[kDefender].touched = 0.7;
  remise.by[kAttacker].touched = 0.65;
  count(what, plan, remise, tally);
  EXPECT_EQ(tally.tries, 3);
  EXPECT_EQ(tally.ripostes, 2);
  EXPECT_EQ(tally.landed, 1);
  EXPECT_EQ(tally.stopped, 2);
}

TEST(FightTable, HasEveryCaseOnce) {
  const Choices chosen = choices();
  const auto cases = all_cases(chosen);
  EXPECT_EQ(cases.size(), 16U + 4 * 7);
  int right = 0;
  for (const Case& each : cases) {
    if (each.situation == Situation::kParry && each.line == each.answer) ++right;
    if (each.situation == Situation::kRiposteStays) {
      EXPECT_EQ(each.answer, chosen.riposte_after[static_cast<std::size_t>(each.line)]);
    }
  }
  EXPECT_EQ(right, kLines);
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

/// The least that a picture of the map must have; what it looks like is looked at by people.
TEST(FightFigure, DrawsEveryKeyAndNamesWhatThereIs) {
  std::ostringstream out;
  draw_map(batuta::fencing::first_fencer<float>(), out);
  const std::string picture = out.str();
  const auto times = [&picture](const std::string& words) {
    int count = 0;
    for (auto at = picture.find(words); at != std::string::npos; at = picture.find(words, at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(times("the point"), kColumns * kRows);
  for (const char* name : kParryNames) EXPECT_EQ(times(name), 1) << name;
  for (const char* name : kLineNames) EXPECT_EQ(times(name), 1) << name;
  EXPECT_EQ(times(">retreat<"), 1);
  EXPECT_EQ(times(">guard<"), 1);
  EXPECT_GE(times("feet go back"), 2);
  EXPECT_EQ(times("feet advance"), 0);
  EXPECT_EQ(times("</svg>"), 1);
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

/// The table of the fight with few tries, of the library's own map. With many: batuta-fight table.
TEST(FightRows, OfTheLibrarysMapHold) {
  constexpr Trials kFew = {40, 1};
  const Choices chosen = choices();
  const auto cases = all_cases(chosen);
  const Table table = table_of(cases, play_all(pair_with(nullptr), cases, chosen, kFew));
  for (const Row& row : rows_of(table)) {
    EXPECT_TRUE(row.holds()) << row.name << ": " << row.value << ", bound " << row.bound;
  }
}

TEST(FightTrial, PlaysTheSameTwiceInAnyNumberOfThreads) {
  const Choices chosen = choices();
  const auto cases = all_cases(chosen);
  const auto fencer = batuta::fencing::first_fencer<float>();
  const Pair pair = {fencer, fencer};
  const auto all = play_all(pair, cases, chosen, {1, 7});
  Arena arena(pair);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Plan plan = plan_for(cases[i], chosen, seed_of(7, i, 0));
    Tally alone;
    count(cases[i], plan, arena.play(plan), alone);
    EXPECT_EQ(alone.stopped, all[i].stopped);
    EXPECT_EQ(alone.landed, all[i].landed);
    EXPECT_EQ(alone.deepest, all[i].deepest);
  }
}

}  // namespace
