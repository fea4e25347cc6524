// SPDX-License-Identifier: MIT
// Bouts to five touches among the opponents that see, and against loops that know only their own
// clock. Usage: batuta-opponents BOUTS SEED [loops]; prints a line for each pairing, which both
// sides play half the time.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "batuta/fencing/opponent.hpp"

namespace {
using namespace batuta;
using namespace batuta::fencing;

constexpr std::int32_t kStepUs = 1000;
constexpr std::uint32_t kMostSteps = 120000;  // two minutes
constexpr int kTouches = 5;

/// A move of a loop: the stick goes there smoothly, the feet do as told.
struct LoopMove {
  int duration_ms;
  float x;
  float y;
  float feet;
};
struct Loop {
  const char* name;
  std::array<LoopMove, 6> moves;
};

/// The lines are those of the map (fencer.hpp); the feet bring each loop into measure and out of
/// it.
constexpr std::array<Loop, 5> kLoops = {{
    {"attack",
     {{{300, 0, 0, 0.6F},
       {120, 0.5F, 0.5F, 1},
       {250, 1, 1, 1},
       {300, 0, 0, -1},
       {300, 0, 0, 0},
       {200, 0, 0, 0}}}},
    {"parry",
     {{{200, -1, 0, 0.3F},
       {200, 0, 0, 0},
       {200, 1, 0, 0},
       {200, -1, -1, 0},
       {200, 1, -1, 0},
       {200, 0, 0, 0}}}},
    {"guard",
     {{{500, 0.05F, 0, 0.1F},
       {500, -0.05F, 0, 0},
       {500, 0, 0.05F, 0},
       {500, 0, 0, 0},
       {500, 0, 0, 0},
       {500, 0, 0, 0}}}},
    {"retreat",
     {{{300, 0, 0, 0.8F},
       {150, 0, -1, -1},
       {300, 0, -1, -1},
       {200, 0, 0, 0.5F},
       {150, 0.5F, 1, 1},
       {300, 0, 0, -0.5F}}}},
    {"beat and thrust",
     {{{300, 0, 0, 0.6F},
       {90, 0, 0.5F, 1},
       {200, -1, 1, 1},
       {100, -1, 1, 0},
       {300, 0, 0, -1},
       {300, 0, 0, 0}}}},
}};

/// A stick that somebody moves: an opponent that sees, or a loop.
class Player {
 public:
  Player(const std::string& name, std::uint32_t seed) {
    constexpr std::array<const char*, 3> kSkills = {"novice", "club", "master"};
    for (std::size_t i = 0; i < kSkills.size(); ++i) {
      if (name == kSkills[i]) {
        sees_ = true;
        (void)opponent_.configure(static_cast<Skill>(i), seed);
      }
    }
    for (const Loop& loop : kLoops) {
      if (name == loop.name) loop_ = &loop;
    }
    phase_ = static_cast<int>(seed % 1000);
  }

  InputSample sample(const Observation& sight, std::uint32_t step) {
    InputSample sample;
    sample.time = step * kStepUs;
    sample.sequence = step;
    if (sees_) {
      const StickPlace& place = opponent_.step(sight, kStepUs);
      sample.x = place.blade.x();
      sample.y = place.blade.y();
      sample.feet_y = place.feet;
    } else {
      play(static_cast<int>(step) + phase_, sample);
    }
    return sample;
  }
  Intent intent() const { return opponent_.intent(); }

 private:
  void play(int time, InputSample& sample) const {
    int length = 0;
    for (const LoopMove& move : loop_->moves) length += move.duration_ms;
    time %= length;
    const LoopMove* from = &loop_->moves.back();
    for (const LoopMove& move : loop_->moves) {
      if (time < move.duration_ms) {
        const float s = static_cast<float>(time) / static_cast<float>(move.duration_ms);
        const float share = s * s * (3 - 2 * s);
        sample.x = from->x + share * (move.x - from->x);
        sample.y = from->y + share * (move.y - from->y);
        sample.feet_y = move.feet;
        return;
      }
      time -= move.duration_ms;
      from = &move;
    }
  }

  bool sees_ = false;
  Opponent opponent_;
  const Loop* loop_ = &kLoops[2];
  int phase_ = 0;
};

struct Tally {
  int bouts = 0;
  int won = 0;                                  // by the first of the pairing
  int drawn = 0;                                // nobody is ahead
  int ended = 0;                                // within two minutes
  std::array<std::array<int, 8>, 2> touches{};  // by player, by intent
  int doubles = 0;
  double seconds = 0;
};

void play_bout(Player& first, Player& second, bool swapped, Tally& tally) {
  auto duel = std::make_unique<Duel<>>();
  DuelSettings<> settings = duel_settings();
  settings.touches = kTouches;
  settings.step_us = kStepUs;
  if (duel->configure(settings, first_fencer<float>(), second_fencer<float>()) != Status::kOk) {
    std::fprintf(stderr, "batuta-opponents: no duel\n");
    std::exit(2);
  }
  const std::array<Player*, 2> players = {swapped ? &second : &first, swapped ? &first : &second};
  std::uint32_t counted = 0;
  while (!duel->bout().is_over() && duel->steps() < kMostSteps) {  // Bound: kMostSteps
    std::array<InputSample, 2> samples;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      samples[index_of(side)] =
          players[index_of(side)]->sample(observation_of(*duel, side), duel->steps());
    }
    (void)duel->step(&samples[0], &samples[1]);
    const auto& bout = duel->bout();
    const bool just_over = bout.state != BoutState::kFencing && bout.state != BoutState::kLockout;
    if (!just_over || counted == bout.exchange) continue;
    counted = bout.exchange;
    if (bout.touches.size() == 2) ++tally.doubles;
    for (const auto& touch : bout.touches) {
      const std::size_t by = (index_of(touch.by) == 0) == !swapped ? 0 : 1;
      const Player& player = *players[index_of(touch.by)];
      ++tally.touches[by][static_cast<std::size_t>(player.intent())];
    }
  }
  ++tally.bouts;
  tally.seconds += duel->steps() * 1e-6 * kStepUs;
  if (duel->bout().is_over()) ++tally.ended;
  const auto& score = duel->bout().score;
  const int lead = (swapped ? -1 : 1) * (int{score[0]} - int{score[1]});
  if (lead > 0) ++tally.won;
  if (lead == 0) ++tally.drawn;
}

void play_pairing(const char* first, const char* second, int bouts, std::uint32_t seed) {
  Tally tally;
  for (int i = 0; i < bouts; ++i) {
    const auto own = seed + static_cast<std::uint32_t>(i) * 7919U;
    Player one(first, own);
    Player two(second, own ^ 0x5bd1e995U);
    play_bout(one, two, i % 2 == 1, tally);
  }
  const double n = tally.bouts / 100.0;
  std::printf(
      "%-16s over %-8s won %5.1f %%, drawn %4.1f %%, ended %5.1f %%, %5.1f s a bout, doubles %d; ",
      first, second, tally.won / n, tally.drawn / n, tally.ended / n, tally.seconds / tally.bouts,
      tally.doubles);
  constexpr std::array<const char*, 8> kWords = {"wait",  "step",    "attack",  "beat",
                                                 "parry", "retreat", "counter", "riposte"};
  for (const auto& touches : tally.touches) {
    for (std::size_t i = 0; i < touches.size(); ++i) {
      if (touches[i] > 0) std::printf("%s %d ", kWords[i], touches[i]);
    }
    std::printf("| ");
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  const int bouts = count > 1 ? std::atoi(words[1]) : 0;
  if (bouts <= 0 || count < 3) {
    std::fprintf(stderr, "usage: batuta-opponents BOUTS SEED [loops]\n");
    return 2;
  }
  const auto seed = static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10));
  play_pairing("club", "novice", bouts, seed);
  play_pairing("master", "club", bouts, seed);
  play_pairing("club", "club", bouts, seed);
  if (count < 4) return 0;
  for (const Loop& loop : kLoops) {
    play_pairing(loop.name, "club", bouts, seed);
    play_pairing(loop.name, "master", bouts, seed);
  }
  return 0;
}
