// SPDX-License-Identifier: MIT
#include "cases.hpp"

#include <algorithm>
#include <thread>

namespace fight {
namespace {

constexpr int kThreads = 2;
constexpr double kAfterwards = 0.15;        // s: an attack that has not scored by then is stopped
constexpr double kIntoLunge = 0.1;          // s
constexpr double kRiposteDelay = 0.05;      // s, from the end of the lunge
constexpr double kRecoveryDelay = 0.08;     // s, the same
constexpr double kRiposteAfterwards = 0.3;  // s
constexpr double kBlowTail = 0.03;          // s: a flick hits at its end

void plan_riposte(const Case& what, const Move& attack, Jitter& jitter, Plan& plan) {
  auto& defence = plan.scripts[kDefender].moves;
  defence.push_back(parry(jitter, what.line, attack, kInTime));
  defence.push_back(riposte(jitter, what.answer, attack.end() + kRiposteDelay));
  if (what.situation == Situation::kRiposteRetreats) {
    const Move back = recovery(jitter, attack.end() + kRecoveryDelay);
    plan.scripts[kAttacker].moves.push_back(back);
    plan.scripts[kAttacker].feet = {{back.start, -1}};
  }
  plan.length = defence.back().end() + kRiposteAfterwards;
}

void plan_lunge(const Case& what, Jitter& jitter, Plan& plan) {
  const Move attack = lunge(jitter, what.line, kStart);
  plan.scripts[kAttacker].moves.push_back(attack);
  plan.length = attack.end() + kAfterwards;
  auto& defence = plan.scripts[kDefender].moves;
  switch (what.situation) {
    case Situation::kParry:
      defence.push_back(parry(jitter, what.answer, attack, kInTime));
      break;
    case Situation::kLateParry:
      defence.push_back(parry(jitter, what.line, attack, kTooLate));
      break;
    case Situation::kStepBack:
      defence.push_back(step_back(jitter, attack.start + kIntoLunge));
      break;
    case Situation::kRiposteStays:
    case Situation::kRiposteRetreats:
      plan_riposte(what, attack, jitter, plan);
      break;
    default:
      break;
  }
}

void plan_thrust(const Case& what, const Choices& choices, Jitter& jitter, Plan& plan) {
  const bool hits = what.situation == Situation::kBeat;
  const Move first = flick(jitter, hits ? choices.beat : choices.miss, kStart);
  const Move thrust = thrust_after(jitter, what.line, first);
  plan.scripts[kAttacker].moves = {first, thrust};
  plan.scripts[kDefender].moves = {parry(jitter, what.line, thrust, kInTime)};
  plan.blow_until = first.end() + kBlowTail;
  plan.length = thrust.end() + kAfterwards;
}

bool is_riposte(Situation situation) {
  return situation == Situation::kRiposteStays || situation == Situation::kRiposteRetreats;
}

}  // namespace

Choices choices() {
  return {{Line::kHighOutside, Line::kLowOutside, Line::kLowInside, Line::kHighInside},
          {0, 0.5},
          {0.25, 0}};
}

std::vector<Case> all_cases(const Choices& choices) {
  std::vector<Case> all;
  for (int situation = 0; situation < kSituations; ++situation) {
    for (int i = 0; i < kLines; ++i) {
      const Case one = {static_cast<Situation>(situation), static_cast<Line>(i),
                        static_cast<Line>(i)};
      all.push_back(one);
      if (is_riposte(one.situation)) {
        all.back().answer = choices.riposte_after[static_cast<std::size_t>(i)];
      }
      for (int other = 0; one.situation == Situation::kParry && other < kLines; ++other) {
        if (other != i) all.push_back({one.situation, one.line, static_cast<Line>(other)});
      }
    }
  }
  return all;
}

Plan plan_for(const Case& what, const Choices& choices, std::uint64_t seed) {
  Jitter jitter(seed);
  Plan plan = plan_of(jitter);
  if (what.situation == Situation::kBeat || what.situation == Situation::kMissedBeat) {
    plan_thrust(what, choices, jitter, plan);
  } else {
    plan_lunge(what, jitter, plan);
  }
  return plan;
}

void count(const Case& what, const Plan& plan, const Outcome& outcome, Tally& tally) {
  const Deeds& attack = outcome.by[kAttacker];
  const Deeds& defence = outcome.by[kDefender];
  ++tally.tries;
  if (attack.touched < 0) ++tally.stopped;
  if (attack.entered >= 0) ++tally.entered;
  if (outcome.scores_first(kDefender)) ++tally.countered;
  if (is_riposte(what.situation)) {
    const double begins = plan.scripts[kDefender].moves.back().start;
    const bool is_open = (attack.touched < 0 || attack.touched >= begins) &&
                         (defence.touched < 0 || defence.touched >= begins);
    if (is_open) ++tally.ripostes;
    if (is_open && outcome.scores_first(kDefender)) ++tally.landed;
  }
  if (outcome.beat >= kHardBeat) ++tally.beats;
  tally.beat += outcome.beat;
  tally.out_of_control += int{attack.out_of_control} + int{defence.out_of_control};
  if (outcome.deepest > kSeenDepth) ++tally.in_weapon;
  tally.deepest = std::max(tally.deepest, outcome.deepest);
  tally.incomplete += outcome.incomplete;
}

std::vector<Tally> play_all(const Pair& fencers, const std::vector<Case>& cases,
                            const Choices& choices, const Trials& trials) {
  std::vector<Tally> tallies(cases.size());
  const auto play_share = [&](std::size_t first) {
    Arena arena(fencers);
    for (std::size_t i = first; i < cases.size(); i += kThreads) {
      Tally own;  // threads keep their hands off each other's cache lines
      for (int trial = 0; trial < trials.tries; ++trial) {
        const std::uint64_t seed = seed_of(trials.seed, i, static_cast<std::uint64_t>(trial));
        const Plan plan = plan_for(cases[i], choices, seed);
        count(cases[i], plan, arena.play(plan), own);
      }
      tallies[i] = own;
    }
  };
  std::thread second(play_share, 1);
  play_share(0);
  second.join();
  return tallies;
}

}  // namespace fight
