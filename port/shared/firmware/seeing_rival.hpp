// SPDX-License-Identifier: MIT
#pragma once
// An opponent of the library that sees (batuta/fencing/opponent.hpp), in place of a stick.

#include "batuta/fencing/duel.hpp"
#include "batuta/fencing/opponent.hpp"
#include "batuta/port/input.hpp"
#include "shared/firmware/rival.hpp"

namespace batuta::firmware {

/// Allocates: never. RAM: an Opponent and a few bytes.
class SeeingRival {
 public:
  static constexpr bool kPlays = true;
  struct Settings {
    fencing::Skill skill = fencing::Skill::kClub;
    std::uint32_t seed = 1;  ///< any number: another one, another fencer
  };

  /// @returns kOk | kInvalidArgument: none of the skills
  static Status validate(const Settings& settings) {
    return settings.skill <= fencing::Skill::kMaster ? Status::kOk : Status::kInvalidArgument;
  }

  /// Who it is; it waits on guard. @returns kOk | kInvalidArgument: none of the skills (nothing
  ///   changed)
  Status configure(const Settings& settings);
  /// A new bout: forgets what it saw, and what it drew.
  void rewind() { (void)configure(settings_); }

  /// Once a step, before it: sees what there is, and moves its stick.
  /// @param duel  as it is at the start of the step; @pre configured
  /// @param side  whose eyes and stick
  /// @param step_us  length of the step, us, > 0
  /// @returns the sample of this step, its time that of the bout: a tick that comes late changes
  ///   no bit. Bound: one observation_of() and one Opponent::step().
  InputSample play(const fencing::Duel<>& duel, fencing::Side side, std::int32_t step_us);

 private:
  Settings settings_;
  fencing::Opponent opponent_;
  std::uint32_t sequence_ = 0;
};

}  // namespace batuta::firmware
