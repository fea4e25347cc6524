// SPDX-License-Identifier: MIT
#pragma once
// What is in the storage of a batuta_duel.

#include "batuta/c/duel.h"
#include "batuta/haptics/stepped_bout.hpp"
#include "storage.hpp"

namespace batuta::fencing {

struct DuelForC {
  static constexpr std::uint32_t kMark = file_id("batuta_duel");

  std::uint32_t mark = kMark;
  bool is_played = false;  ///< the bout is that of a recording
  haptics::BoutSettings settings;
  haptics::SteppedBout bout;
};

/// The bout in storage; null: there is none, or a damaged recording has left it unfit to go on.
inline const DuelForC* bout_in(const batuta_duel* duel) {
  const auto* const own = batuta::detail::found_in<DuelForC>(duel);
  return own != nullptr && own->bout.duel().dt() != 0.0F ? own : nullptr;
}
/// The same, to be changed.
inline DuelForC* bout_in(batuta_duel* duel) {
  return const_cast<DuelForC*>(bout_in(static_cast<const batuta_duel*>(duel)));
}

/// A side as C names it. @returns whether there is such a side
constexpr bool is_side(std::int32_t side) {
  return side == BATUTA_LEFT || side == BATUTA_RIGHT;
}
static_assert(index_of(Side::kLeft) == BATUTA_LEFT && index_of(Side::kRight) == BATUTA_RIGHT,
              "batuta/c/duel.h says so");

/// us since the start of the bout, modulo 2^32, at the beginning of the step that comes.
inline Microseconds now_of(const Duel<>& duel) {
  return static_cast<Microseconds>(duel.time_us({duel.steps(), 0}));
}

/// Length of a step, us.
inline std::int32_t step_us_of(const Duel<>& duel) {
  return static_cast<std::int32_t>(duel.time_us({1, 0}));
}

}  // namespace batuta::fencing
