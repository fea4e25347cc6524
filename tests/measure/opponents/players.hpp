// SPDX-License-Identifier: MIT
#pragma once
// Who plays a bout: an opponent that sees, or a loop that knows only its own clock.

#include <array>
#include <string>
#include <vector>

#include "batuta/fencing/opponent.hpp"

namespace bouts {

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

/// The loops by their names: attack, parry, guard, retreat, beat and thrust, point held out, rush,
/// point walked in.
std::vector<std::string> names_of_loops();

/// A stick that somebody moves.
class Player {
 public:
  /// @param name  novice, club, master, or that of a loop  @param seed  of its decisions, or its
  /// phase
  Player(const std::string& name, std::uint32_t seed);

  /// Where its sticks are. @pre the steps of a duel, in order
  batuta::InputSample sample(const batuta::fencing::Observation& seen, std::uint32_t step);
  /// What its moves are for: kWait, for a loop.
  batuta::fencing::Intent intent() const { return opponent_.intent(); }

 private:
  void play(int time_ms, batuta::InputSample& sample) const;

  bool sees_ = false;
  batuta::fencing::Opponent opponent_;
  const Loop* loop_ = nullptr;
  int phase_ms_ = 0;
};

/// Length of a step, us.
inline constexpr std::int32_t kStepUs = 1000;

}  // namespace bouts
