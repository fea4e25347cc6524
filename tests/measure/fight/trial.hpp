// SPDX-License-Identifier: MIT
#pragma once
// One trial: two sticks that know only their own clock play a duel, and what came of it is seen
// from outside. Role 0 attacks, role 1 defends.

#include <memory>

#include "batuta/fencing/duel.hpp"
#include "scripts.hpp"

namespace fight {

enum Role : std::size_t { kAttacker, kDefender };

/// Who fences.
using Pair = std::array<batuta::fencing::Fencer<float>, 2>;

/// When the first attack of a trial begins, s: both have been on guard for a while.
inline constexpr double kStart = 0.1;

struct Plan {
  std::array<Script, 2> scripts;
  double distance = kGuardDistance;  ///< m
  bool swapped = false;              ///< the attacker stands on the right
  double length = 0;                 ///< s
  double blow_until = 0;             ///< blows before this are counted as the beat, s
};

/// A plan with both on guard; the jitter decides distance and sides.
Plan plan_of(Jitter& jitter);

/// What a blade did.
struct Deeds {
  double touched = -1;          ///< when it scored a touch, s; -1: never
  bool out_of_control = false;  ///< it scored with control() below kLeastControl
  double entered = -1;          ///< when its point was inside the other's body first, s; -1: never
};

/// What came of a trial.
struct Outcome {
  std::array<Deeds, 2> by;       ///< by role
  double beat = 0;               ///< hardest blow before Plan::blow_until, N s
  double deepest = 0;            ///< of a blade in the other's guard or hand, m
  std::uint32_t incomplete = 0;  ///< steps whose report was not complete

  /// Whether this role scored, and the other did not before.
  bool scores_first(Role role) const;
};

/// Of a touch that is one.
inline constexpr float kLeastControl = 0.8F;
/// How much of the blade is its point, m.
inline constexpr float kPointLength = 0.02F;

/// Plays trials, one after the other.
class Arena {
 public:
  /// @param fencers  by role
  explicit Arena(const Pair& fencers);
  Outcome play(const Plan& plan);

 private:
  void begin(const Plan& plan);
  void note_touches(const Plan& plan, int before, const std::array<float, 2>& control,
                    Outcome& outcome) const;
  void look(const Plan& plan, Outcome& outcome) const;
  bool is_point_inside(batuta::fencing::Side side) const;
  double depth_in_weapon(const Plan& plan, batuta::fencing::Side side) const;

  Pair fencers_;
  std::unique_ptr<batuta::fencing::Duel<>> duel_;
};

}  // namespace fight
