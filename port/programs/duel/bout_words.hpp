// SPDX-License-Identifier: MIT
#pragma once
// What both logs and the picture say alike about a bout.

#include "programs/duel/duel_runner.hpp"

namespace batuta::host {

inline const char* name_of(fencing::Side side) {
  return side == fencing::Side::kLeft ? "left" : "right";
}

/// "left", "right", "double" or "draw"; "open" while it goes on.
inline const char* result_of(const DuelRunner& runner) {
  switch (runner.ending()) {
    case Ending::kTouch:
      return name_of(runner.duel().bout().touches[0].by);
    case Ending::kDouble:
      return "double";
    case Ending::kDraw:
      return "draw";
    case Ending::kNone:
      break;
  }
  return "open";
}

/// Of an event of the step that has just ended, s since the start.
inline double time_of(const DuelRunner& runner, const ContactEvent<float>& event) {
  return 1e-6 * static_cast<double>(runner.duel().time_us({runner.duel().steps() - 1, event.time}));
}

inline double time_of(const DuelRunner& runner, const fencing::Touch<float>& touch) {
  return 1e-6 * static_cast<double>(runner.duel().time_us(touch.when));
}

/// Blade meets blade with a blow; the smaller blows while the two then press on each other are not
/// beats.
inline bool is_beat(const ContactEvent<float>& event) {
  return event.kind == EventKind::kBegin && event.contact_kind == ContactKind::kColliding;
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

/// Hands over the touches that an observer has not seen yet.
class TouchCursor {
 public:
  template <class Call>
  void for_each_new(const DuelRunner& runner, const Call& call) {
    const auto& touches = runner.duel().bout().touches;
    for (; seen_ < touches.size(); ++seen_) call(touches[seen_]);  // Bound: 2
  }

 private:
  int seen_ = 0;
};

}  // namespace batuta::host
