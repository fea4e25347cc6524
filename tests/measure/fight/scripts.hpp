// SPDX-License-Identifier: MIT
#pragma once
// What a stick does in a trial: moves that know their own clock and nothing else. Stick to the
// right = the fencer's own right. Times in s since the trial began.

#include <vector>

#include "batuta/port/input.hpp"
#include "jitter.hpp"
#include "keys.hpp"

namespace fight {

/// The stick goes somewhere smoothly: s^2 (3 - 2 s) of the way.
struct Move {
  double start = 0;
  double duration = 0;  ///< > 0
  Place to;

  double end() const { return start + duration; }
  double at_share(double share) const { return start + share * duration; }
};

/// From a time on the feet are told this, -1 ... 1.
struct FeetOrder {
  double start = 0;
  double order = 0;
};

/// A stick over time. A move that begins before the last one has ended takes it over smoothly.
struct Script {
  Place from;
  std::vector<Move> moves;      ///< in the order of their start
  std::vector<FeetOrder> feet;  ///< the same

  Place at(double time) const;
  double feet_at(double time) const;
  /// What a device says at the start of a step of 1 ms.
  batuta::InputSample sample(std::uint32_t step) const;
};

/// Where the stick goes.
Place attack_place(Line line);
Place parry_place(Line line);
inline constexpr Place kRetreatPlace = {0, -1};

/// How long moves take, s.
inline constexpr double kLungeTime = 0.30;
inline constexpr double kParryTime = 0.11;
inline constexpr double kStepBackTime = 0.15;
inline constexpr double kRecoverTime = 0.25;
inline constexpr double kRiposteTime = 0.25;
inline constexpr double kFlickTime = 0.07;
inline constexpr double kThrustTime = 0.25;

/// Shares of a lunge between which a parry begins.
struct Window {
  double from;
  double to;
};
inline constexpr Window kInTime = {0.30, 0.50};
inline constexpr Window kTooLate = {0.80, 0.85};

/// The stick about the centre.
Script on_guard(Jitter& jitter);
/// A lunge of kLungeTime, its beginning jittered.
Move lunge(Jitter& jitter, Line line, double start);
/// The parry against a line, begun during an attack: exactly in the window.
Move parry(Jitter& jitter, Line line, const Move& attack, const Window& window);
/// Back to where the map lets the feet retreat.
Move step_back(Jitter& jitter, double start);
/// The attacker of a lunge goes back in kRecoverTime.
Move recovery(Jitter& jitter, double start);
/// Into a line in kRiposteTime.
Move riposte(Jitter& jitter, Line line, double start);
/// A flick of the point in kFlickTime, from where it is.
Move flick(Jitter& jitter, const Place& to, double start);
/// Into a line in kThrustTime, straight after a flick.
Move thrust_after(Jitter& jitter, Line line, const Move& flick);

}  // namespace fight
