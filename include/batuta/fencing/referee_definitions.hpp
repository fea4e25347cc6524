// SPDX-License-Identifier: MIT
#pragma once
// What a referee does, whatever the scene; see duel_definitions.hpp.

#include "batuta/fencing/referee.hpp"

namespace batuta {

namespace detail {

constexpr int touches_in(BoutState state) {
  if (state == BoutState::kFencing) return 0;
  return state == BoutState::kDouble ? 2 : 1;
}

/// One piece of a blade's way in a step.
template <class Scalar>
struct Piece {
  Scalar from = 0;
  Motion<Scalar> motion;
};

template <class Scalar>
Piece<Scalar> piece_between(const Waypoint<Scalar>& start, const Waypoint<Scalar>& end) {
  const Scalar duration = end.time - start.time;
  if (!(duration > Scalar(0))) return {start.time, still(end.X_WB, Scalar(0))};
  return {start.time, motion_between(start.X_WB, end.X_WB, duration)};
}

/// Whether a second touch comes early enough to count.
template <class Scalar, class SettingsT>
bool within_window(const SettingsT& settings, const Moment<Scalar>& first,
                   const Moment<Scalar>& second) {
  return time_us(second, settings.step_us) - time_us(first, settings.step_us) <=
         static_cast<std::uint64_t>(settings.double_window_us);
}

}  // namespace detail
