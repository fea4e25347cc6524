// SPDX-License-Identifier: MIT
#pragma once
// What both logs and the picture say alike about a bout.

#include "programs/duel/bout_story.hpp"

namespace batuta::host {

inline const char* name_of(fencing::Side side) {
  return side == fencing::Side::kLeft ? "left" : "right";
}

/// "left", "right", "double" or "draw"; "open" while it goes on.
inline const char* result_of(const DuelRunner& runner) {
  switch (runner.ending()) {
    case Ending::kWon: {
      const auto [left, right] = score_of(runner.duel().bout());
      return name_of(left > right ? fencing::Side::kLeft : fencing::Side::kRight);
    }
    case Ending::kDouble:
      return "double";
    case Ending::kDraw:
      return "draw";
    case Ending::kNone:
      break;
  }
  return "open";
}

/// Of the end of the last step, s since the start.
inline double time_of(const DuelRunner::DuelType& duel) {
  return 1e-6 * static_cast<double>(duel.time_us({duel.steps(), 0}));
}

/// Of an event of the step that has just ended, s since the start.
inline double time_of(const DuelRunner::DuelType& duel, const ContactEvent<float>& event) {
  return 1e-6 * static_cast<double>(duel.time_us({duel.steps() - 1, event.time}));
}
inline double time_of(const DuelRunner& runner, const ContactEvent<float>& event) {
  return time_of(runner.duel(), event);
}

inline double time_of(const DuelRunner::DuelType& duel, const fencing::Touch<float>& touch) {
  return 1e-6 * static_cast<double>(duel.time_us(touch.when));
}
inline double time_of(const DuelRunner& runner, const fencing::Touch<float>& touch) {
  return time_of(runner.duel(), touch);
}

/// Blade meets blade with a blow; the smaller blows while the two then press on each other are not
/// beats.
inline bool is_beat(const ContactEvent<float>& event) {
  return event.kind == EventKind::kBegin && event.contact_kind == ContactKind::kColliding;
}

/// What a picture remembers of a beat of the step that has just ended. @pre is_beat(event)
inline Beat beat_of(const DuelRunner::DuelType& duel, const ContactEvent<float>& event) {
  return {time_of(duel, event), event.impulse, event.contact.point_W};
}

/// The same of a touch.
inline TouchMark mark_of(const DuelRunner::DuelType& duel, const fencing::Touch<float>& touch) {
  return {duel.bout().exchange, time_of(duel, touch), touch.by, touch.part, touch.contact.point_W};
}

/// Samples that did not move the fencer's stick, of all that its device delivered.
inline std::uint32_t rejected(const DuelRunner& runner, fencing::Side side) {
  const StickReport& stick = runner.duel().stick(side).report();
  return stick.repeated + stick.backward + stick.invalid +
         runner.tally().devices[index_of(side)].refused;
}

inline double mean_step_ns(const DuelRunner& runner) {
  const std::uint32_t steps = runner.duel().steps();
  return steps == 0 ? 0 : static_cast<double>(runner.tally().host_ns) / steps;
}

/// Hands over the touches and halts that an observer has not seen yet.
class TouchCursor {
 public:
  template <class Call>
  void for_each_new(const DuelRunner::DuelType& duel, const Call& call) {
    const auto& bout = duel.bout();
    if (bout.exchange != exchange_) seen_ = 0;
    exchange_ = bout.exchange;
    for (; seen_ < bout.touches.size(); ++seen_) call(bout.touches[seen_]);  // Bound: 2
  }
  /// Whether both have come on guard again since it was asked last, for another exchange.
  bool is_next(const DuelRunner::DuelType& duel) {
    const bool next = duel.bout().exchange != guard_;
    guard_ = duel.bout().exchange;
    return next;
  }
  /// Whether a halt has begun since it was asked last.
  bool is_halt(const DuelRunner::DuelType& duel) {
    const auto& bout = duel.bout();
    if (bout.state != fencing::BoutState::kHalt || bout.exchange == halt_) return false;
    halt_ = bout.exchange;
    return true;
  }

 private:
  int seen_ = 0;
  std::uint32_t exchange_ = 1;  ///< of which so many are seen
  std::uint32_t guard_ = 1;
  std::uint32_t halt_ = 0;
};

}  // namespace batuta::host
