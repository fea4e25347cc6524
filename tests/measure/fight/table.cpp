// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <numeric>

namespace fight {
namespace {

double percent(int part, int whole) {
  return whole > 0 ? 100.0 * part / whole : 0;
}

std::size_t at(Line line) {
  return static_cast<std::size_t>(line);
}

void add_parry(const Case& what, const Tally& tally, Table& table) {
  table.stopped[at(what.line)][at(what.answer)] = percent(tally.stopped, tally.tries);
  if (what.line != what.answer) return;
  table.entered[at(what.line)] = percent(tally.entered, tally.tries);
  table.countered[at(what.line)] = percent(tally.countered, tally.tries);
}

void add_thrust(const Case& what, const Tally& tally, Table& table) {
  const bool hits = what.situation == Situation::kBeat;
  const double landed = percent(tally.tries - tally.stopped, tally.tries);
  (hits ? table.beat : table.miss)[at(what.line)] = landed;
  (hits ? table.beats : table.false_beats) += percent(tally.beats, tally.tries) / kLines;
  if (hits && tally.tries > 0) table.blow += tally.beat / tally.tries / kLines;
}

void add(const Case& what, const Tally& tally, Table& table) {
  const double stopped = percent(tally.stopped, tally.tries);
  const double landed = percent(tally.landed, tally.ripostes);
  switch (what.situation) {
    case Situation::kParry:
      return add_parry(what, tally, table);
    case Situation::kNoParry:
      table.none[at(what.line)] = stopped;
      return;
    case Situation::kLateParry:
      table.late[at(what.line)] = stopped;
      return;
    case Situation::kRiposteStays:
      table.riposte[at(what.line)] = landed;
      return;
    case Situation::kRiposteRetreats:
      table.chase[at(what.line)] = landed;
      return;
    case Situation::kStepBack:
      table.step_back[at(what.line)] = stopped;
      return;
    case Situation::kBeat:
    case Situation::kMissedBeat:
      return add_thrust(what, tally, table);
  }
}

template <class Numbers>
Spread spread(const Numbers& numbers) {
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  const double total = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  return {total / static_cast<double>(numbers.size()), *least, *most};
}

std::vector<double> wrong_ones(const Table& table) {
  std::vector<double> wrong;
  for (std::size_t line = 0; line < kLines; ++line) {
    for (std::size_t parry = 0; parry < kLines; ++parry) {
      if (parry != line) wrong.push_back(table.stopped[line][parry]);
    }
  }
  return wrong;
}

void print_lines(std::FILE* out, const char* name, const Table::ByLine& shares) {
  std::fprintf(out, "  %-34s", name);
  for (const double share : shares) std::fprintf(out, " %6.1f", share);
  std::fprintf(out, "  mean %5.1f\n", spread_of(shares).mean);
}

}  // namespace

Table table_of(const std::vector<Case>& cases, const std::vector<Tally>& tallies) {
  Table table;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Tally& tally = tallies[i];
    add(cases[i], tally, table);
    table.deepest = std::max(table.deepest, 1000 * tally.deepest);
    table.in_weapon += tally.in_weapon;
    table.out_of_control += tally.out_of_control;
    table.incomplete += tally.incomplete;
  }
  return table;
}

Spread spread_of(const Table::ByLine& shares) {
  return spread(shares);
}

Table::ByLine right_parries(const Table& table) {
  Table::ByLine right{};
  for (std::size_t i = 0; i < kLines; ++i) right[i] = table.stopped[i][i];
  return right;
}

Spread wrong_parries(const Table& table) {
  return spread(wrong_ones(table));
}

double beat_gain(const Table& table) {
  return spread_of(table.beat).mean - spread_of(table.miss).mean;
}

std::vector<Row> rows_of(const Table& table) {
  const Spread right = spread_of(right_parries(table));
  const Spread wrong = wrong_parries(table);
  const Spread riposte = spread_of(table.riposte);
  return {{"right parry stops, mean %", right.mean, true, 95},
          {"right parry stops, each line %", right.least, true, 90},
          {"the point enters at all, mean %", spread_of(table.entered).mean, false, 15},
          {"wrong parry stops, mean %", wrong.mean, false, 20},
          {"wrong parry stops, any pair %", wrong.most, false, 50},
          {"no parry stops, mean %", spread_of(table.none).mean, false, 3},
          {"late parry stops, mean %", spread_of(table.late).mean, false, 20},
          {"riposte on who stays, mean %", riposte.mean, true, 60},
          {"riposte on who stays, each line %", riposte.least, true, 45},
          {"riposte on who retreats, mean %", spread_of(table.chase).mean, false, 30},
          {"step back, each line %", spread_of(table.step_back).least, true, 95},
          {"beat over a flick that misses, points", beat_gain(table), true, 30},
          {"trials with a blade in guard or hand", double(table.in_weapon), false, 0},
          {"touches out of control", double(table.out_of_control), false, 0}};
}

void print(const Table& table, std::FILE* out) {
  for (const Row& row : rows_of(table)) {
    std::fprintf(out, "%-40s %7.2f  %s %4.0f  %s\n", row.name, row.value,
                 row.at_least ? ">=" : "<=", row.bound, row.holds() ? "" : "MISSED");
  }
  std::fprintf(out, "  %-34s", "%, by line of the attack");
  for (const char* name : kLineNames) std::fprintf(out, " %s |", name);
  std::fprintf(out, "\n");
  for (std::size_t parry = 0; parry < kLines; ++parry) {
    Table::ByLine by{};
    for (std::size_t line = 0; line < kLines; ++line) by[line] = table.stopped[line][parry];
    print_lines(out, (std::string("stopped by ") + kParryNames[parry]).c_str(), by);
  }
  print_lines(out, "the point enters through the right", table.entered);
  print_lines(out, "the defender scores by parrying", table.countered);
  print_lines(out, "stopped by none", table.none);
  print_lines(out, "stopped by a late parry", table.late);
  print_lines(out, "riposte lands on who stays", table.riposte);
  print_lines(out, "riposte lands on who retreats", table.chase);
  print_lines(out, "falls short of a step back", table.step_back);
  print_lines(out, "thrust lands after a beat", table.beat);
  print_lines(out, "thrust lands after a miss", table.miss);
  std::fprintf(out,
               "  flicks that hit hard: %.0f %% of the beats (%.2f N s), %.0f %% of the misses\n",
               table.beats, table.blow, table.false_beats);
  std::fprintf(out, "  deepest blade in guard or hand %.3f mm; steps not complete: %ld\n",
               table.deepest, table.incomplete);
}

double score_of(const Table& table) {
  // A figure that holds by this many points counts as safe.
  constexpr double kMargin = 5;
  const auto below = [](double value, double goal) {
    return std::max(goal + kMargin - value, 0.0);
  };
  const auto above = [](double value, double goal) {
    return std::max(value - goal + kMargin, 0.0);
  };
  double score = 0;
  for (const double share : right_parries(table)) {
    score += 1.0 * below(share, 90) + 0.5 * below(share, 95);
  }
  score += 2.0 * below(spread_of(right_parries(table)).mean, 95);
  score += 1.0 * above(spread_of(table.entered).mean, 15);
  for (const double share : wrong_ones(table)) score += 0.5 * above(share, 45);
  score += 2.0 * above(wrong_parries(table).mean, 20);
  for (const double share : table.none) score += 1.0 * above(share, 3);
  score += 1.0 * above(spread_of(table.late).mean, 20);
  for (const double share : table.riposte) score += 0.5 * below(share, 45);
  score += 1.0 * below(spread_of(table.riposte).mean, 60);
  score += 1.0 * above(spread_of(table.chase).mean, 30);
  for (const double share : table.step_back) score += 1.0 * below(share, 95);
  score += 2.0 * below(beat_gain(table), 30);
  return score;
}

}  // namespace fight
