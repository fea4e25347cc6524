// SPDX-License-Identifier: MIT
#pragma once
// Bouts to five touches between two players, each on either side half the time, and what came of
// them, seen from outside.

#include "players.hpp"

namespace bouts {

/// A blade this deep in a guard or a hand is inside, m: what one sees.
inline constexpr double kSeenDepth = 0.0002;
/// A blade this deep in a body is in it, m: a millimetre more than it may press.
inline constexpr double kPressed = 0.003;
/// A bout that is not over then is not counted as ended, s.
inline constexpr double kLongest = 120;
/// Intents there are.
inline constexpr std::size_t kIntents = 8;

/// What came of the bouts of a pairing; [0] is its first player.
struct Tally {
  int bouts = 0;
  int won = 0;                                         ///< by the first
  int drawn = 0;                                       ///< nobody is ahead
  int ended = 0;                                       ///< within kLongest
  std::array<std::array<int, kIntents>, 2> touches{};  ///< by player, by intent
  int doubles = 0;                                     ///< exchanges with two touches
  int corps_a_corps = 0;                               ///< halts without a touch
  double seconds = 0;
  int in_weapon = 0;    ///< bouts with a blade inside a guard or hand
  double deepest = 0;   ///< of a blade in one, m
  double in_trunk = 0;  ///< deepest of a blade in a trunk or head, m
  double in_limb = 0;   ///< in an arm or leg, m
  int steps = 0;
  int steps_in_body = 0;   ///< of these with a blade in a body deeper than kPressed
  int out_of_control = 0;  ///< touches by a hand without its weapon

  double share(int count) const { return 100.0 * count / bouts; }
  /// Of all touches those of this intent, %.
  double kind(batuta::fencing::Intent intent) const;
  void add(const Tally& other);
};

/// @param bouts  > 0  @param seed  of the first; the others follow from it
Tally play_pairing(const std::string& first, const std::string& second, int bouts,
                   std::uint32_t seed);

}  // namespace bouts
