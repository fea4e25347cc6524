// SPDX-License-Identifier: MIT
#pragma once
// An opponent that sees: it decides by late sights alone, and acts through a stick like everybody,
// no faster than a hand. The same seed and the same sights give the same decisions. The policy, and
// what its numbers were chosen for: src/fencing/opponent.md.

#include "batuta/core/fixed_list.hpp"
#include "batuta/fencing/observation.hpp"

namespace batuta::fencing {

/// How well an opponent fences.
enum class Skill : std::uint8_t {
  kNovice,  ///< sees late, defends seldom, attacks by chance
  kClub,    ///< parries and ripostes, attacks where the blade is not
  kMaster,  ///< keeps its distance, learns the rival's lines, attacks in time
};

/// What an opponent's moves are for.
enum class Intent : std::uint8_t {
  kWait,     ///< in measure, out of reach
  kStep,     ///< with the feet
  kAttack,   ///< begun by oneself
  kBeat,     ///< the same, after a beat
  kParry,    ///< of an attack that is seen
  kRetreat,  ///< a step back from it
  kCounter,  ///< an attack into it
  kRiposte,  ///< after a parry
};

namespace detail {
struct Situation;
}  // namespace detail

/// Where an opponent holds its sticks: that of the blade, and that of the feet.
struct StickPlace {
  Vec2<float> blade = Vec2<float>::Zero();  ///< in [-1, 1]^2, as a Fencer's keys mean it
  float feet = 0;                           ///< -1 back ... 1 forward
};

/// The way to a place, starting and ending at rest.
struct StickMove {
  std::int32_t duration_us = 0;  ///< > 0
  StickPlace to;                 ///< the feet's stick goes there at once, as fast as a hand
};

/// A fencer that plays by itself.
/// Allocates: never. RAM: about 1.2 kB, a DelayedObservation the most of it.
class Opponent {
 public:
  /// Lines of attack (fencer.hpp).
  static constexpr std::size_t kLines = 4;
  /// Of one action, hesitation included.
  static constexpr int kMaxMoves = 6;
  /// The fastest that either stick goes, 1/s.
  static constexpr float kHandSpeed = 12;
  /// Between the fencers of its bouts on guard, m, each 2 m from the middle: who stands within a
  /// lunge has no time to see one.
  static constexpr float kOnGuard = 4;

  /// Forgets what it saw, and waits on guard.
  /// @param seed  any number: another one, other decisions
  /// @returns kOk | kInvalidArgument: none of the skills (nothing changed)
  Status configure(Skill skill, std::uint32_t seed);

  /// One step: a look, a decision where the look was due, and the stick a step further.
  /// @param now      what there is to be seen at the start of the step; it is acted on
  ///                 DelayedObservation::kDelayUs later. What is not finite is not looked at
  /// @param step_us  length of the step, us
  /// @pre step_us > 0
  /// @returns where the sticks are. Bound: kMaxMoves moves.
  const StickPlace& step(const Observation& now, std::int32_t step_us);

  /// What the moves of now are for.
  Intent intent() const { return intent_; }
  /// Where the sticks are.
  const StickPlace& place() const { return place_; }

 private:
  void stand_down();
  bool is_free() const;
  void decide();
  void look_on(const detail::Situation& now, bool comes);
  void defend(const detail::Situation& now);
  void choose(const detail::Situation& now, bool over);
  void choose_attack(const detail::Situation& now, bool over);
  void attack(const detail::Situation& now, int index, Intent intent);
  void press(const detail::Situation& now);
  bool is_near(const detail::Situation& now) const;
  bool may_take(const detail::Situation& now);
  void look_at_rush(const detail::Situation& now, bool comes);
  bool is_rushed() const;
  void meet(const detail::Situation& now);
  bool is_time_to_meet() const;
  void take(const detail::Situation& now);
  void keep_measure(const detail::Situation& now);
  int guessed_line();
  int line_to_attack();
  void begin(Intent intent);
  void then(std::int32_t duration_us, const StickPlace& to);
  void advance(std::int32_t step_us);
  float move_blade(std::int32_t step_us);
  int line_to_close(int seen);
  int usual_line() const;
  void parry(int line);
  StickPlace near(StickPlace place);
  float drawn();
  bool chance(float probability) { return drawn() < probability; }

  Skill skill_ = Skill::kNovice;
  std::uint32_t draw_ = 1;  ///< never 0
  DelayedObservation eye_;
  bool threatened_ = false;  ///< at the last look
  int opening_ = 0;          ///< looks for which an attack of the rival's is just over
  int came_ = 0;             ///< the line of that
  int held_ = 0;             ///< looks for which the rival's arm stands, and is out
  int yields_ = 0;           ///< looks in which he gave ground before an attack, less the others
  int rushed_ = 0;           ///< looks for which the rival's feet came fast, less those since
  int since_ = 0;            ///< looks since his arm came out
  int rhythm_ = 0;           ///< looks from one time to the next; 0: none
  std::array<std::uint16_t, kLines> habits_{};  ///< attacks seen, by line
  Intent intent_ = Intent::kWait;
  bool presses_ = false;                   ///< walks in to attack
  FixedList<StickMove, kMaxMoves> moves_;  ///< of the action, in their order
  int move_ = 0;                           ///< the one under way; moves_.size(): none
  std::int32_t spent_us_ = 0;              ///< of that move
  StickPlace from_;                        ///< where it began
  StickPlace place_;
};

}  // namespace batuta::fencing
