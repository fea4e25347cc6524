// SPDX-License-Identifier: MIT
#pragma once
// World, second half: what happens at a contact, and the begin, persist and end of contacts.
// Included by world.hpp.

#include "batuta/geometry/direction.hpp"
#include "batuta/world/world.hpp"

namespace batuta {

template <class SceneT>
Status World<SceneT>::remove(BodyId id) {
  const auto slot = static_cast<std::uint16_t>(id.index1 - 1);
  const Status status = actors_.remove(id);
  if (status != Status::kOk) return status;
  for (int i = touching_.size() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    if (touching_[i].first == slot || touching_[i].second == slot) touching_.remove_swapping(i);
  }
  this->forget(slot);
  return Status::kOk;
}

template <class SceneT>
void World<SceneT>::answer(const Hit& hit) {
  switch (hit.search.outcome) {
    case Outcome::kContact:
    case Outcome::kTouching:
      if (contacts_answered_ < SceneT::kMaxContacts) return answer_contact_of(hit);
      ++report_.contacts_dropped;
      break;
    case Outcome::kBudget:
      ++report_.searches_cut;
      break;
    case Outcome::kFree:  // never a hit
    case Outcome::kInvalid:
      ++report_.searches_invalid;
      break;
  }
  hold_pair(hit.pair, dt_);
}

template <class SceneT>
void World<SceneT>::answer_contact_of(const Hit& hit) {
  ++contacts_answered_;
  const std::size_t a = hit.pair.first;
  const std::size_t b = hit.pair.second;
  const Contact<Scalar> contact = contact_from(hit.search.witness, hit.origin_W);
  if (is_immovable(hit.pair)) return block(hit, contact);

  const std::array<Momentum<Scalar>, 2> before = {actor_at(a).body.momentum,
                                                  actor_at(b).body.momentum};
  const auto answer = answer_contact(party(a, b, contact.normal_BA_W),
                                     party(b, a, -contact.normal_BA_W), contact, options_for(hit));
  if (!answer.ok()) {
    actor_at(a).body.momentum = before[0];
    actor_at(b).body.momentum = before[1];
    ++report_.answers_invalid;
    hold_pair(hit.pair, dt_);
    return;
  }
  if (answer.value.separated) hold_pair(hit.pair, now_ + answer.value.separation.duration);
  tell_driver(a, answer.value, answer.value.separation.shift_A_W);
  tell_driver(b, answer.value, answer.value.separation.shift_B_W);
  record(hit, contact, answer.value);
}

/// Neither body can be pushed: where one is moved into the other, both stop.
template <class SceneT>
bool World<SceneT>::is_immovable(BodyPair pair) const {
  return is_fixed(actor_at(pair.first).body) && is_fixed(actor_at(pair.second).body);
}

template <class SceneT>
void World<SceneT>::block(const Hit& hit, const Contact<Scalar>& contact) {
  EncounterAnswer<Scalar> answer;
  answer.v_rel = hit.search.gap_rate;
  answer.kind = classify(answer.v_rel, settings_.rest_speed);
  ++report_.blocked;
  hold_pair(hit.pair, dt_);
  record(hit, contact, answer);
}

template <class SceneT>
EncounterOptions<typename World<SceneT>::Scalar> World<SceneT>::options_for(const Hit& hit) const {
  EncounterOptions<Scalar> options;
  options.restitution =
      pair_restitution(actor_at(hit.pair.first).restitution, actor_at(hit.pair.second).restitution);
  options.rest_speed = settings_.rest_speed;
  options.separation = settings_.separation;
  options.min_separation_time = settings_.min_separation_time;
  options.margin = margin_of(hit);
  return options;
}

/// The gap from which the next search lets parting bodies go (src/world/encounter.md).
template <class SceneT>
typename World<SceneT>::Scalar World<SceneT>::margin_of(const Hit& hit) const {
  constexpr Scalar kContactGaps = 2;
  constexpr Scalar kUlps = 64;
  const Scalar size = length(actor_at(hit.pair.first).body.X_WB.p_W) +
                      length(actor_at(hit.pair.second).body.X_WB.p_W) + hit.scale;
  return kContactGaps * hit.contact_gap + kUlps * kRoundOff<Scalar> * size;
}

/// A body at a contact. One that its driver moves gets the momentum that goes with the driver's
/// twist, so that the impulse is added to what the body really has.
/// @param away_W  unit, out of the other body: where a separation shifts this one
template <class SceneT>
Party<typename World<SceneT>::Scalar> World<SceneT>::party(std::size_t slot, std::size_t other,
                                                           const Vec3<Scalar>& away_W) {
  Body<Scalar>& body = actor_at(slot).body;
  const Course<Scalar>& course = tracks_[slot].course;
  if (!course.by_momentum) body.momentum = momentum_of(body, course.motion.twist);
  return {&body, course.by_momentum ? twist_of(body) : course.motion.twist,
          room_of(slot, other, away_W)};
}

/// Half the way to the nearest neighbour: both may be pushed towards each other in the same round.
/// A neighbour that the shift does not lead towards stays as far away as it is: the plane between
/// the two goes on separating them.
/// @param away_W  direction of the shift
template <class SceneT>
typename World<SceneT>::Scalar World<SceneT>::room_of(std::size_t slot, std::size_t other,
                                                      const Vec3<Scalar>& away_W) {
  Scalar room = std::numeric_limits<Scalar>::max();
  for (std::size_t k = 0; k < kSlots; ++k) {  // Bound: kMaxBodies
    const bool same_owner =
        actor_at(slot).owner != 0 && is_present(k) && actor_at(k).owner == actor_at(slot).owner;
    if (k == slot || k == other || !is_present(k) || same_owner) continue;
    const CapsuleGap<Scalar> gap = capsule_gap(shape_W(slot), shape_W(k));
    const bool leads_away = gap.gap > Scalar(0) && !(gap.axes.normal_AB.dot(away_W) > Scalar(0));
    if (!leads_away) room = min_of(room, gap.gap / Scalar(2));
  }
  return max_of(room, Scalar(0));
}

template <class SceneT>
void World<SceneT>::tell_driver(std::size_t slot, const EncounterAnswer<Scalar>& answer,
                                const Vec3<Scalar>& shift_W) {
  ActorType& actor = actor_at(slot);
  actor.driver.on_contact(actor.body, Feedback<Scalar>{now_, answer.impulse, shift_W});
}

template <class SceneT>
void World<SceneT>::record(const Hit& hit, const Contact<Scalar>& contact,
                           const EncounterAnswer<Scalar>& answer) {
  if (answer.impulse > Scalar(0)) ++report_.collisions;
  if (answer.separated) ++report_.separations;
  if (hit.search.outcome == Outcome::kTouching && !(contact.gap > Scalar(0))) {
    ++report_.overlaps_at_start;
    report_.deepest_overlap = max_of(report_.deepest_overlap, -contact.gap);
  }
  ContactEvent<Scalar> event;
  event.contact_kind = answer.kind;
  event.body_A = hit.pair.first;
  event.body_B = hit.pair.second;
  event.time = now_;
  event.contact = contact;
  event.v_rel = answer.v_rel;
  event.impulse = answer.impulse;
  event.place_A = hit.search.witness.axes.s;
  event.place_B = hit.search.witness.axes.u;
  event.kind = follow(event);
  push(event);
}

/// Notes that the pair is in contact; whether it was already.
template <class SceneT>
EventKind World<SceneT>::follow(const ContactEvent<Scalar>& event) {
  for (const BodyPair pair : touching_) {  // Bound: kMaxPairs
    if (pair.first == event.body_A && pair.second == event.body_B) return EventKind::kPersist;
  }
  if (!touching_.push({event.body_A, event.body_B})) ++report_.contacts_untracked;
  return EventKind::kBegin;
}

template <class SceneT>
void World<SceneT>::push(const ContactEvent<Scalar>& event) {
  if (!events_.push(event)) ++report_.events_dropped;
}

/// Whether the pair has parted by more than 2 D, and its gap.
template <class SceneT>
bool World<SceneT>::has_opened(BodyPair pair, CapsuleGap<Scalar>& gap) {
  gap = capsule_gap(shape_W(pair.first), shape_W(pair.second));
  return gap.gap > Scalar(2) * settings_.separation;
}

/// Contacts that have opened by the end of the step end with it, also those that began in it.
template <class SceneT>
void World<SceneT>::end_touches() {
  CapsuleGap<Scalar> gap;
  for (int i = touching_.size() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    if (!has_opened(touching_[i], gap)) continue;
    ContactEvent<Scalar> event;
    event.kind = EventKind::kEnd;
    event.contact_kind = ContactKind::kReceding;
    event.body_A = touching_[i].first;
    event.body_B = touching_[i].second;
    event.time = dt_;
    event.contact = contact_from(gap, Vec3<Scalar>::Zero().eval());
    event.place_A = gap.axes.s;
    event.place_B = gap.axes.u;
    push(event);
    touching_.remove_swapping(i);
  }
}

}  // namespace batuta
