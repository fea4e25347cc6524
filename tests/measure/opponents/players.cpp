// SPDX-License-Identifier: MIT
#include "players.hpp"

#include <cstdio>
#include <cstdlib>

namespace bouts {
namespace {

using namespace batuta;
using namespace batuta::fencing;

/// The lines are those of the map (fencer.hpp); the feet bring each loop into measure and out of
/// it.
constexpr std::array<Loop, 8> kLoops = {{
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
    {"point held out",
     {{{200, 0, 1, 0},
       {200, 0, 1, 0},
       {200, 0, 1, 0},
       {200, 0, 1, 0},
       {200, 0, 1, 0},
       {200, 0, 1, 0}}}},
    {"rush",
     {{{140, -1, 1, 1},
       {140, 0, 0, 1},
       {140, -1, 1, 1},
       {140, 0, 0, 1},
       {140, -1, 1, 1},
       {140, 0, 0, 1}}}},
    {"point walked in",
     {{{200, 0, 1, 1},
       {200, 0, 1, 1},
       {200, 0, 1, 1},
       {200, 0, 1, 1},
       {200, 0, 1, 1},
       {200, 0, 1, 1}}}},
}};

constexpr std::array<const char*, 3> kSkills = {"novice", "club", "master"};

}  // namespace

std::vector<std::string> names_of_loops() {
  std::vector<std::string> names;
  for (const Loop& loop : kLoops) names.emplace_back(loop.name);
  return names;
}

Player::Player(const std::string& name, std::uint32_t seed) {
  for (std::size_t i = 0; i < kSkills.size(); ++i) {
    if (name != kSkills[i]) continue;
    sees_ = opponent_.configure(static_cast<Skill>(i), seed) == Status::kOk;
  }
  for (const Loop& loop : kLoops) {
    if (name == loop.name) loop_ = &loop;
  }
  if (!sees_ && loop_ == nullptr) {
    std::fprintf(stderr, "batuta-opponents: nobody is called %s\n", name.c_str());
    std::exit(2);
  }
  phase_ms_ = static_cast<int>(seed % 1000);
}

InputSample Player::sample(const Observation& seen, std::uint32_t step) {
  InputSample sample;
  sample.time = step * kStepUs;
  sample.sequence = step;
  if (sees_) {
    const StickPlace& place = opponent_.step(seen, kStepUs);
    sample.x = place.blade.x();
    sample.y = place.blade.y();
    sample.feet_y = place.feet;
  } else {
    play(static_cast<int>(step) + phase_ms_, sample);
  }
  return sample;
}

void Player::play(int time_ms, InputSample& sample) const {
  int length = 0;
  for (const LoopMove& move : loop_->moves) length += move.duration_ms;
  time_ms %= length;
  const LoopMove* from = &loop_->moves.back();
  for (const LoopMove& move : loop_->moves) {
    if (time_ms < move.duration_ms) {
      const float s = static_cast<float>(time_ms) / static_cast<float>(move.duration_ms);
      const float share = s * s * (3 - 2 * s);
      sample.x = from->x + share * (move.x - from->x);
      sample.y = from->y + share * (move.y - from->y);
      sample.feet_y = move.feet;
      return;
    }
    time_ms -= move.duration_ms;
    from = &move;
  }
}

}  // namespace bouts
