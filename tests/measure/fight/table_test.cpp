// SPDX-License-Identifier: MIT
// The table's arithmetic on made-up counts, trials, the picture, and the rows of the table with few
// tries.

#include "table.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "fencers.hpp"
#include "figure.hpp"

namespace {
using namespace fight;

constexpr double kExact = 1e-12;

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
  Outcome before_the_remise;
  before_the_remise.by[kDefender].touched = 0.64;
  before_the_remise.by[kAttacker].touched = 0.65;
  count(what, plan, before_the_remise, tally);
  EXPECT_EQ(tally.tries, 4);
  EXPECT_EQ(tally.ripostes, 3);
  EXPECT_EQ(tally.landed, 2);
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
  EXPECT_EQ(times(">beat<"), 1);
  EXPECT_GE(times("feet go back"), 2);
  EXPECT_EQ(times("feet advance"), 0);
  EXPECT_EQ(times("</svg>"), 1);
  std::ifstream shown(BATUTA_FIGHT_PICTURE);
  EXPECT_EQ(picture, std::string(std::istreambuf_iterator<char>(shown), {}))
      << "docs/fencing_map.svg is of another map: batuta-fight figure docs/fencing_map.svg";
}

/// The table of the fight with few tries, of the library's own map. With many: batuta-fight table.
/// Fewer would not do: the worst of the pairs stands at 40 %, and 40 tries are off by 8 %.
TEST(FightRows, OfTheLibrarysMapHold) {
  constexpr Trials kFew = {120, 1};
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
