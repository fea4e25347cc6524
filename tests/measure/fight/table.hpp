// SPDX-License-Identifier: MIT
#pragma once
// The table of the fight: what is measured, and its bounds.

#include <cstdio>

#include "cases.hpp"

namespace fight {

/// Mean and extremes of some shares, in percent.
struct Spread {
  double mean = 0;
  double least = 0;
  double most = 0;
};

/// What the cases come to; shares in percent, by line of the attack.
struct Table {
  using ByLine = std::array<double, kLines>;
  std::array<ByLine, kLines> stopped{};  ///< by a parry: [attack][parry]
  ByLine entered{};                      ///< through the right one
  ByLine countered{};                    ///< the same: the defender scored first
  ByLine none{};                         ///< stopped by none
  ByLine late{};                         ///< by a late one
  ByLine riposte{};                      ///< lands on who stays
  ByLine chase{};                        ///< on who retreats
  ByLine step_back{};                    ///< falls short
  ByLine beat{};                         ///< lands after a beat
  ByLine miss{};                         ///< after a flick that misses
  double beats = 0;                      ///< flicks that hit hard
  double false_beats = 0;                ///< of those that should miss
  double blow = 0;                       ///< mean of the beats' hardest blows, N s
  double deepest = 0;                    ///< mm
  int in_weapon = 0;                     ///< trials with a blade in guard or hand
  int out_of_control = 0;                ///< touches
  long incomplete = 0;                   ///< steps
};

/// @param tallies  of the cases, one each
Table table_of(const std::vector<Case>& cases, const std::vector<Tally>& tallies);

Spread spread_of(const Table::ByLine& shares);
/// Of the right parries; of the twelve wrong ones.
Table::ByLine right_parries(const Table& table);
Spread wrong_parries(const Table& table);
/// What a beat adds, points, mean of the lines.
double beat_gain(const Table& table);

/// A figure and its bound.
struct Row {
  const char* name;
  double value;
  bool at_least;  ///< the bound is the least; else the most
  double bound;

  bool holds() const { return at_least ? value >= bound : value <= bound; }
};
/// The bounds of the table of the fight.
std::vector<Row> rows_of(const Table& table);

void print(const Table& table, std::FILE* out);

/// What the search makes less: shortfalls of the bounds, weighted.
double score_of(const Table& table);

}  // namespace fight
