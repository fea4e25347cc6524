// SPDX-License-Identifier: MIT
#pragma once
// Everything that a duel tells after a step.

#include "batuta/fencing/duel.hpp"
#include "fields.hpp"

namespace batuta::digest {

inline void add(Answer& answer, const StepReport<float>& report) {
  answer.add("step_evaluations", report.evaluations);
  answer.add("pairs", report.pairs);
  answer.add("collisions", report.collisions);
  answer.add("separations", report.separations);
  answer.add("blocked", report.blocked);
  answer.add("overlaps_at_start", report.overlaps_at_start);
  answer.add("deepest_overlap", report.deepest_overlap);
  answer.add("pairs_dropped", report.pairs_dropped);
  answer.add("contacts_dropped", report.contacts_dropped);
  answer.add("searches_cut", report.searches_cut);
  answer.add("searches_invalid", report.searches_invalid);
  answer.add("answers_invalid", report.answers_invalid);
  answer.add("courses_invalid", report.courses_invalid);
  answer.add("events_dropped", report.events_dropped);
  answer.add("contacts_untracked", report.contacts_untracked);
  answer.add("time_held", report.time_held);
}

inline void add(Answer& answer, const ContactEvent<float>& event) {
  answer.add("event", event.kind);
  answer.add("event_contact_kind", event.contact_kind);
  answer.add("event_body_A", std::uint32_t{event.body_A});
  answer.add("event_body_B", std::uint32_t{event.body_B});
  answer.add("event_time", event.time);
  add(answer, event.contact);
  answer.add("event_v_rel", event.v_rel);
  answer.add("event_impulse", event.impulse);
  answer.add("event_place_A", event.place_A);
  answer.add("event_place_B", event.place_B);
}

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

inline void add(Answer& answer, const Touch<float>& touch) {
  answer.add("touch_by", touch.by);
  answer.add("touch_part", touch.part);
  answer.add("touch_step", touch.when.step);
  answer.add("touch_in_step", touch.when.in_step);
  add(answer, touch.contact);
  answer.add("touch_place", touch.place);
  answer.add("touch_certain", touch.certain);
}

inline void add(Answer& answer, const DuelReport& report) {
  answer.add("blows", report.blows);
  answer.add("rests", report.rests);
  answer.add("evaluations", static_cast<std::uint32_t>(report.evaluations));
  answer.add("touch_searches", report.touch_searches);
  answer.add("incomplete_steps", report.incomplete_steps);
  answer.add("budget_outs", report.budget_outs);
  answer.add("duel_searches_invalid", report.searches_invalid);
}

/// One fencer: stick, hand, blade, body.
inline void add(Answer& answer, const Duel<float>& duel, Side side) {
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

inline void add(Answer& answer, const Duel<float>& duel) {
  answer.add("step", duel.steps());
  add(answer, duel, Side::kLeft);
  add(answer, duel, Side::kRight);
  add(answer, duel.world().report());
  for (const auto& event : duel.world().events()) add(answer, event);  // Bound: kMaxEvents
  answer.add("bout", duel.bout().state);
  for (const auto& touch : duel.bout().touches) add(answer, touch);  // Bound: 2
  add(answer, duel.report());
}

}  // namespace batuta::digest
