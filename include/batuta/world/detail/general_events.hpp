// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld, fourth part: begin, persist and end of contacts, and who sleeps. Included by
// general_world.hpp.

#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

template <class SceneT>
Status GeneralWorld<SceneT>::remove(BodyId id) {
  const int index = actors_.index_of(id);
  const Status status = actors_.remove(id);
  if (status != Status::kOk) return status;
  const auto slot = static_cast<std::size_t>(index);
  if constexpr (SceneT::kMaxEvents > 0) {
    for (int i = this->touches() - 1; i >= 0; --i) {  // Bound: kMaxPairs
      const ProxyPair pair = this->touch(i);
      if (body_of(pair.first) != slot && body_of(pair.second) != slot) continue;
      wake_both(pair);
      this->end_touch(i);
    }
  }
  for (int part = 0; part < kParts; ++part) {  // Bound: kCapsulesPerBody
    this->forget(proxy_of(slot, part));
  }
  leave_out(slot);
  return Status::kOk;
}

template <class SceneT>
void GeneralWorld<SceneT>::record(const CandidateType& candidate, const Nearest<Scalar>& nearest,
                                  const Resolution<Scalar>& resolution) {
  if (resolution.impulse > Scalar(0)) ++report_.collisions;
  if (resolution.separated) ++report_.separations;
  if (candidate.outcome == Outcome::kTouching && !(nearest.contact.gap > Scalar(0))) {
    ++report_.overlaps_at_start;
    report_.deepest_overlap = max_of(report_.deepest_overlap, -nearest.contact.gap);
  }
  if constexpr (SceneT::kMaxEvents > 0) {
    ContactEvent<Scalar> event = event_of(candidate.pair, nearest);
    event.contact_kind = resolution.kind;
    event.time = now_;
    event.v_rel = resolution.v_rel;
    event.impulse = resolution.impulse;
    event.kind = EventKind::kPersist;
    if (!this->is_touching(candidate.pair)) {
      event.kind = EventKind::kBegin;
      if (!this->begin_touch(candidate.pair)) ++report_.contacts_untracked;
    }
    if (!this->push(event)) ++report_.events_dropped;
  }
}

template <class SceneT>
ContactEvent<Scalar_of<SceneT>> GeneralWorld<SceneT>::event_of(
    ProxyPair pair, const Nearest<Scalar>& nearest) const {
  ContactEvent<Scalar> event;
  event.body_A = static_cast<Slot>(body_of(pair.first));
  event.body_B = static_cast<Slot>(body_of(pair.second));
  event.part_A = static_cast<std::uint8_t>(part_at(pair.first));
  event.part_B = static_cast<std::uint8_t>(part_at(pair.second));
  event.contact = nearest.contact;
  event.place_A = nearest.place_A;
  event.place_B = nearest.place_B;
  return event;
}

/// Contacts that have opened by the end of the step end with it, also those that began in it.
template <class SceneT>
void GeneralWorld<SceneT>::end_touches() {
  for (int i = this->touches() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    const ProxyPair pair = this->touch(i);
    if constexpr (kParts > 1) {
      if (!has_part(pair.first) || !has_part(pair.second)) {  // the caller took it off
        wake_both(pair);
        this->end_touch(i);
        continue;
      }
    }
    if (sweep_.is_idle(pair.first) && sweep_.is_idle(pair.second)) continue;
    const Nearest<Scalar> now = nearest(pair);
    if (!(now.contact.gap > Scalar(2) * settings_.separation)) continue;
    ContactEvent<Scalar> event = event_of(pair, now);
    event.kind = EventKind::kEnd;
    event.contact_kind = ContactKind::kReceding;
    event.time = dt_;
    if (!this->push(event)) ++report_.events_dropped;
    wake_both(pair);
    this->end_touch(i);
  }
}

/// What lay on something lies on it no longer.
template <class SceneT>
void GeneralWorld<SceneT>::wake_both(ProxyPair pair) {
  this->rouse(body_of(pair.first));
  this->rouse(body_of(pair.second));
}

/// Bodies in contact that have not left their place for a while. Where a contact could not be
/// followed, nobody would be told of its end: then nobody is put to sleep.
template <class SceneT>
void GeneralWorld<SceneT>::put_to_sleep() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!states_[slot].present || is_fixed(actor_at(slot).body)) continue;
    if (this->sleeps(slot)) {
      ++report_.asleep;
      states_[slot].stands = true;  // also where it was held, and planned anew for that
      continue;
    }
    Body<Scalar>& body = actor_at(slot).body;
    const bool is_struck = this->has_woken(slot) && !is_slow(slot);
    if (is_struck || has_left(slot)) {
      this->start_over(slot, body.X_WB);
    } else if (this->is_quiet_for_long(slot) && is_supported(slot) &&
               report_.contacts_untracked == 0 && states_[slot].plan.by_momentum) {
      this->fall_asleep(slot);
      body.momentum = {};
      // Where it is found if nobody disturbs it.
      states_[slot].plan.motion = Kinematics::standing(body, Scalar(0));
      states_[slot].stands = true;
    }
  }
}

/// Whether the body has gone further than it would at rest_speed, or than its gaps let it sway.
template <class SceneT>
bool GeneralWorld<SceneT>::has_left(std::size_t slot) const {
  const ActorType& actor = actor_at(slot);
  const Scalar window = static_cast<Scalar>(SceneT::kSleepSteps) * dt_;
  const Scalar limit = max_of(2 * settings_.separation, settings_.rest_speed * window);
  const auto is_far = [&](const Vec3<Scalar>& x_B) {
    const Vec3<Scalar> way = to_world(actor.body.X_WB, x_B) - to_world(this->anchor(slot), x_B);
    return way.squaredNorm() > limit * limit;
  };
  bool left = false;
  for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
    const Segment<Scalar>& axis = part_of(actor, i).axis;
    left = left || is_far(axis.a) || is_far(axis.b);
  }
  return left;
}

/// Whether no part of the body is faster than rest: a sleeper that was struck has not gone far yet.
template <class SceneT>
bool GeneralWorld<SceneT>::is_slow(std::size_t slot) const {
  const ActorType& actor = actor_at(slot);
  const Twist<Scalar> twist = twist_of(actor.body);
  const auto is_fast = [&](const Vec3<Scalar>& x_B) {
    const Vec3<Scalar> v_W = velocity_at(actor.body.X_WB, twist, to_world(actor.body.X_WB, x_B));
    return v_W.squaredNorm() > rest_speed_ * rest_speed_;
  };
  bool fast = false;
  for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
    const Segment<Scalar>& axis = part_of(actor, i).axis;
    fast = fast || is_fast(axis.a) || is_fast(axis.b);
  }
  return !fast;
}

template <class SceneT>
bool GeneralWorld<SceneT>::is_supported(std::size_t slot) const {
  for (int i = 0; i < this->touches(); ++i) {  // Bound: kMaxPairs
    const ProxyPair pair = this->touch(i);
    if (body_of(pair.first) == slot || body_of(pair.second) == slot) return true;
  }
  return false;
}

/// What a step sets up for itself is not part of what is saved, but for who stands where.
template <class SceneT>
template <class Archive>
void GeneralWorld<SceneT>::archive(Archive& ar) {
  archive_scene<SceneT>(ar);
  this->archive_seeds(ar);
  this->archive_events(ar);
  this->archive_sleep(ar);
  ar(settings_, actors_, report_);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    const BodyState& state = states_[slot];
    bool stands = state.stands && is_present(slot) &&
                  Kinematics::is_at_start(actor_at(slot).body, state.plan.motion);
    ar(stands);
    if (ar.reading()) take_stand(slot, stands);
  }
  if constexpr (SceneT::kMaxEvents > 0) {
    if (ar.reading()) check_touches(ar);
  }
}

/// What was read of a body's planned motion: whether it stood where it is. What sleeps flew by its
/// momentum; and who was disturbed before it was saved stands nowhere.
template <class SceneT>
void GeneralWorld<SceneT>::take_stand(std::size_t slot, bool stands) {
  BodyState& state = states_[slot];
  state.stands = stands;
  state.boxed = false;
  if constexpr (SceneT::kSleep) {
    state.plan.by_momentum = this->sleeps(slot);
    if (!stands) {
      state.plan.motion.X_WB.p_W.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
    }
  }
  if (stands && is_present(slot)) {
    state.plan.motion = Kinematics::standing(actor_at(slot).body, Scalar(0));
  }
}

/// What was read may name bodies that are not there.
template <class SceneT>
template <class Archive>
void GeneralWorld<SceneT>::check_touches(Archive& ar) {
  for (int i = this->touches() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    const ProxyPair pair = this->touch(i);
    const bool named = pair.first < kProxies && pair.second < kProxies;
    const bool good = named && has_part(pair.first) && has_part(pair.second);
    ar.require(good);
    if (!good) this->end_touch(i);
  }
}

}  // namespace batuta::detail
