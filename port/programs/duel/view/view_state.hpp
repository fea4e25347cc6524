// SPDX-License-Identifier: MIT
#pragma once
// What the window has to know of a bout, as of its last step. Of fixed size: it is copied from
// thread to thread.

#include "programs/duel/bout_drawing.hpp"
#include "programs/duel/bout_words.hpp"

namespace batuta::host {

struct ViewState {
  /// Tips and beats of so many steps come along, so that the window misses none for as long as it
  /// draws more often than that.
  static constexpr std::uint32_t kRecent = 128;

  /// One fencer's hand: the stick, and the force on it.
  struct Hand {
    Vec2<float> stick = Vec2<float>::Zero();  ///< each in [-1, 1]
    Vec2<float> force = Vec2<float>::Zero();  ///< share of the device's range, each in [-1, 1]
  };

  std::uint32_t bout = 0;   ///< since the program began; 0: none yet
  std::uint32_t steps = 0;  ///< since the bout began
  bool over = false;
  Postures postures;
  std::array<Hand, 2> hands;
  std::array<std::array<TracePoint, kRecent>, 2> tips{};  ///< after step i at i modulo kRecent
  std::uint32_t beat_count = 0;                           ///< since the bout began
  std::array<Beat, kRecent> beats{};                      ///< beat i at i modulo kRecent
  FixedList<TouchMark, BoutStory::kMaxTouches> touches;   ///< of all exchanges
  std::array<int, 2> score{};                             ///< by index_of(side)
  bool halt = false;                                      ///< nobody scores now
  bool corps_a_corps = false;                             ///< and nobody was touched
  bool annulled = false;                                  ///< the last two touches
};

/// Keeps the state up, step by step. Allocates nothing.
class ViewFeed {
 public:
  /// Another bout. Its steps start to be counted where the duel's stand.
  void begin(const DuelRunner::DuelType& duel, const haptics::StickForces& forces);
  void add_step(const DuelRunner::DuelType& duel, const haptics::StickForces& forces);
  void end() { state_.over = true; }

  const ViewState& state() const { return state_; }

 private:
  void take(const DuelRunner::DuelType& duel, const haptics::StickForces& forces);

  ViewState state_;
  TouchCursor touches_;
};

}  // namespace batuta::host
