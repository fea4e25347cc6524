// SPDX-License-Identifier: MIT
#pragma once
// What a world tells after a step, word by word.

#include "batuta/world/world.hpp"
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
  answer.add("resolutions_invalid", report.resolutions_invalid);
  answer.add("plans_invalid", report.plans_invalid);
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

}  // namespace batuta::digest
