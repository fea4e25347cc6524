// SPDX-License-Identifier: MIT
#pragma once
// Everything that a duel tells after a step.

#include "batuta/fencing/duel.hpp"
#include "world_fields.hpp"

namespace batuta::digest {

inline void add(Answer& answer, const StickReport& report) {
  answer.add("stick_used", report.used);
  answer.add("stick_restarts", report.restarts);
  answer.add("stick_repeated", report.repeated);
  answer.add("stick_backward", report.backward);
  answer.add("stick_invalid", report.invalid);
  answer.add("stick_lost", report.lost);
  answer.add("stick_clamped", report.clamped);
  answer.add("stick_slowed", report.slowed);
  answer.add("stick_stale_steps", report.stale_steps);
}

inline void add(Answer& answer, const fencing::Touch<float>& touch) {
  answer.add("touch_by", touch.by);
  answer.add("touch_part", touch.part);
  answer.add("touch_step", touch.when.step);
  answer.add("touch_in_step", touch.when.in_step);
  add(answer, touch.contact);
  answer.add("touch_place", touch.place);
  answer.add("touch_certain", touch.certain);
}

inline void add(Answer& answer, const fencing::DuelReport& report) {
  answer.add("blows", report.blows);
  answer.add("rests", report.rests);
  answer.add("evaluations", static_cast<std::uint32_t>(report.evaluations));
  answer.add("touch_searches", report.touch_searches);
  answer.add("incomplete_steps", report.incomplete_steps);
  answer.add("budget_outs", report.budget_outs);
  answer.add("duel_searches_invalid", report.searches_invalid);
}

/// One fencer: stick, hand, blade, body.
inline void add(Answer& answer, const fencing::Duel<>& duel, fencing::Side side) {
  answer.add("stick", duel.stick(side).position());
  answer.add("stick_velocity", duel.stick(side).velocity());
  answer.add("stick_stale", duel.stick(side).is_stale());
  add(answer, duel.stick(side).report());
  add(answer, duel.hand(side).X_WH);
  answer.add("hand_jacobian", duel.hand(side).jacobian);
  answer.add("grip_phase", duel.grip(side).phase());
  answer.add("grip_control", duel.grip(side).control());
  add(answer, duel.grip(side).hand());
  add(answer, duel.blade_W(side));
  const auto slot = static_cast<std::uint16_t>(index_of(side));
  const auto* blade = duel.world().get(duel.world().id_at(slot));
  if (blade != nullptr) {
    add(answer, blade->body.X_WB);
    add(answer, blade->body.momentum);
  }
  for (const Capsule<float>& part : duel.body_W(side)) add(answer, part);  // Bound: kBodyParts
}

inline void add(Answer& answer, const fencing::Duel<>& duel) {
  answer.add("step", duel.steps());
  add(answer, duel, fencing::Side::kLeft);
  add(answer, duel, fencing::Side::kRight);
  add(answer, duel.world().report());
  for (const auto& event : duel.world().events()) add(answer, event);  // Bound: kMaxEvents
  answer.add("bout", duel.bout().state);
  for (const auto& touch : duel.bout().touches) add(answer, touch);  // Bound: 2
  add(answer, duel.report());
}

}  // namespace batuta::digest
