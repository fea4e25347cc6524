// SPDX-License-Identifier: MIT
#pragma once
// The situations that the table of the fight is made of, and what comes of many tries in each.

#include "trial.hpp"

namespace fight {

enum class Situation {
  kParry,            ///< of a line, right or wrong, begun within kInTime of a lunge
  kNoParry,          ///< the lunge alone
  kLateParry,        ///< the right one, begun within kTooLate
  kRiposteStays,     ///< after the right parry; the attacker stays in his lunge
  kRiposteRetreats,  ///< the same; the attacker goes back
  kStepBack,         ///< begun 0.1 s into a lunge
  kBeat,             ///< flick that hits, thrust, right parry within kInTime of the thrust
  kMissedBeat,       ///< the same with a flick that misses
};
inline constexpr int kSituations = 8;

struct Case {
  Situation situation;
  Line line;    ///< of the attack
  Line answer;  ///< the line that is parried; of a riposte: where it goes
};

/// What the scripts choose.
struct Choices {
  std::array<Line, kLines> riposte_after;  ///< where the riposte goes after each parry
  Place beat;
  Place miss;
};
/// As measured: batuta-fight ripostes.
Choices choices();

/// Every case of the table.
std::vector<Case> all_cases(const Choices& choices);

/// What came of the tries in one case.
struct Tally {
  int tries = 0;
  int stopped = 0;         ///< the attack did not score
  int entered = 0;         ///< its point was inside the body at some time
  int countered = 0;       ///< the defender scored first
  int ripostes = 0;        ///< nobody had scored when the riposte began
  int landed = 0;          ///< of these: it scored first
  int beats = 0;           ///< flicks that hit with at least kHardBeat
  double beat = 0;         ///< sum of their hardest blows, N s
  int out_of_control = 0;  ///< touches
  int in_weapon = 0;       ///< trials with a blade in guard or hand deeper than kSeenDepth
  double deepest = 0;      ///< m
  long incomplete = 0;     ///< steps
};
inline constexpr double kHardBeat = 0.1;  // N s
/// The world keeps touching weapons apart by this, m: what is not deeper has touched.
inline constexpr double kSeenDepth = 2e-4;

/// One try of a case.
Plan plan_for(const Case& what, const Choices& choices, std::uint64_t seed);
void count(const Case& what, const Plan& plan, const Outcome& outcome, Tally& tally);

/// Plays all cases, in two threads; the answer does not depend on them.
struct Trials {
  int tries;  ///< of each case
  std::uint64_t seed;
};
std::vector<Tally> play_all(const Pair& fencers, const std::vector<Case>& cases,
                            const Choices& choices, const Trials& trials);

}  // namespace fight
