// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld: the step, in the order in which things happen. Included by general_world.hpp.

#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

template <class SceneT>
Status GeneralWorld<SceneT>::step(Scalar dt) {
  if (!is_positive(dt)) return Status::kInvalidArgument;
  begin_step(dt);
  if constexpr (kSolves) solve_lasting();
  for (int i = 0; i < kMaxRounds && bodies_.now < bodies_.dt; ++i) {  // Bound: kMaxRounds
    run_round();
  }
  BATUTA_INVARIANT(!(bodies_.now < bodies_.dt));
  end_step();
  return Status::kOk;
}

template <class SceneT>
void GeneralWorld<SceneT>::begin_step(Scalar dt) {
  bodies_.report = {};
  bodies_.now = 0;
  bodies_.dt = dt;
  contacts_answered_ = cuts_made_ = 0;
  touches_.begin_step();
  pairs_.begin_step();
  this->clear_repeats();
  if constexpr (SceneT::kSleep) sleep_.begin_step(bodies_, groups_);
  begin_bodies();
  is_begin_ = bodies_.is_changed = true;
}

template <class SceneT>
void GeneralWorld<SceneT>::begin_bodies() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    auto& state = bodies_.states[slot];
    const bool was_present = state.present;
    const bool is_there = bodies_.actors.at_index(slot) != nullptr;
    state.present = false;
    if (is_there) state.stands = bodies_.begin(slot);
    state.changed = state.present;
    if (!state.present && (is_there || was_present)) pairs_.remove_boxes(slot);
  }
}

/// What touches and does not strike is solved with the velocities of the step's end; then courses
/// are planned from what came out.
template <class SceneT>
void GeneralWorld<SceneT>::solve_lasting() {
  const bool is_as_long = groups_.boxed_for == bodies_.dt;
  groups_.boxed_for = bodies_.dt;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    auto& state = bodies_.states[slot];
    if (!state.present) continue;
    state.changed = false;
    // Who stands exactly still and falls would lose the contact that carries it.
    const bool idle =
        state.stands && Kinematics::is_still(state.plan.motion) && !bodies_.falls(slot);
    if (idle && is_as_long && state.boxed && pairs_.boxes().is_idle(BodiesT::proxy_of(slot, 0)))
      continue;
    pairs_.put_wide_boxes(bodies_, slot, idle);
  }
  is_begin_ = bodies_.is_changed = false;
  if constexpr (SceneT::kSleep) wake_touched();
  pairs_.collect_all(bodies_);
  groups_.find_near(bodies_, pairs_);
  groups_.solve(bodies_);
  groups_.tell_begun(bodies_,
                     [this](ProxyPair pair, const Contact<Scalar>& contact, Scalar impulse) {
                       touches_.record_lasting(bodies_, pair, contact, impulse);
                     });
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    const auto& state = bodies_.states[slot];
    if (state.present && !state.changed) plan_solved(slot);
  }
}

/// Until nobody who sleeps is touched any more: who is woken falls, and may press on others.
template <class SceneT>
void GeneralWorld<SceneT>::wake_touched() {
  const auto begin = [this](std::size_t slot) {
    auto& state = bodies_.states[slot];
    state.stands = bodies_.begin(slot);
    state.changed = false;
    pairs_.put_wide_boxes(bodies_, slot, false);
  };
  bool is_any = false;                                                       // who sleeps
  for (const auto& state : bodies_.states) is_any = is_any || state.asleep;  // Bound: kMaxBodies
  for (int pass = 0; is_any && pass < SceneT::kMaxBodies; ++pass) {  // Bound: each wakes one
    is_any = sleep_.wake_touched(bodies_, groups_, pairs_, begin);
  }
}

/// From what contacts that last have left of its velocity. Whom its wide boxes do not hold is
/// planned anew.
template <class SceneT>
void GeneralWorld<SceneT>::plan_solved(std::size_t slot) {
  auto& state = bodies_.states[slot];
  bodies_.plan(slot);
  state.stands = Kinematics::is_still(state.plan.motion);
  if (state.stands) return;
  const bool idle = pairs_.boxes().is_idle(BodiesT::proxy_of(slot, 0));
  if (idle || !pairs_.holds_course(bodies_, slot)) state.changed = bodies_.is_changed = true;
}

/// To the next thing that happens: a contact, a search that ended without an answer, the end of a
/// separation's time, or the end of the step.
template <class SceneT>
void GeneralWorld<SceneT>::run_round() {
  pairs_.refresh(bodies_, is_begin_);
  is_begin_ = false;
  pairs_.search_all(bodies_, [this](ProxyPair pair) { return parts_along(pair); });
  const Scalar released = next_release();
  CandidateType candidate;
  Scalar time = 0;
  const auto has_had = [this](ProxyPair pair, Scalar at) {
    if constexpr (kSolves) return this->was_answered(pair, at);
    static_cast<void>(this);  // or clang warns of what this scene does not use
    return false;
  };
  if (pairs_.take_first(released, has_had, candidate, time)) {
    if (cut_courses(candidate, time)) return;
    if constexpr (kSolves) struck_.clear();
    resolve(candidate, time);
    if constexpr (kSolves) {
      if (SceneT::kMaxPairs > 1) answer_ties(candidate.pair);
      pass_on();
    }
  } else {
    release(released);
  }
}

/// Where a body would be met on the chord of its turn, and its energy there is not that of its
/// flight, its course is made to end there: it is then met near that end, or near the start of the
/// next course. A group parts there. At most kCutsPerContact kMaxContacts in a step. Nor is a
/// course cut that began before now: who came to now on the chord would be off its flight where the
/// new course began. What is left is met as it is, where it does not win by that (resolve()).
/// @returns whether a course was cut: then nothing else has happened
template <class SceneT>
bool GeneralWorld<SceneT>::cut_courses([[maybe_unused]] const CandidateType& candidate,
                                       [[maybe_unused]] Scalar time) {
  if constexpr (kCuts<SceneT>) {
    if (!candidate.is_contact() || !(bodies_.now < time)) return false;
    const bool is_cut = cut_course(BodiesT::body_of(candidate.pair.first), time);
    return cut_course(BodiesT::body_of(candidate.pair.second), time) || is_cut;
  }
  return false;
}

/// The same of one body. @pre now < time
template <class SceneT>
bool GeneralWorld<SceneT>::cut_course(std::size_t slot, Scalar time) {
  const bool is_off_course =
      bodies_.states[slot].start < bodies_.now || !(time < bodies_.goes_until(slot));
  if (is_off_course || cuts_made_ >= kCutsPerContact * SceneT::kMaxContacts) return false;
  if (!(std::abs(off_flight(bodies_, slot, time)) > kOffFlight<Scalar>)) return false;
  if (bodies_.states[slot].group == BodiesT::kAlone) {
    end_course(bodies_, slot, time);
    bodies_.states[slot].changed = bodies_.is_changed = true;
  } else if constexpr (kPartsGroups<SceneT>) {
    bodies_.shorten_group(slot, time);
  }
  ++cuts_made_;
  return true;
}

/// The normal of a pair whose contact is solved for the rest of the step, out of the first: the
/// search then speaks of contact only where the two would be in each other. Zero: it is not.
template <class SceneT>
Vec3<typename GeneralWorld<SceneT>::Scalar> GeneralWorld<SceneT>::parts_along(
    ProxyPair pair) const {
  if constexpr (kSolves) {
    const int i = groups_.contacts.find(pair);
    if (i >= 0 && groups_.contacts[i].is_solved) return -groups_.contacts[i].points[0].normal_W;
  }
  return Vec3<Scalar>::Zero();
}

/// The first time at which a group parts or a course ends, or the end of the step.
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::next_release() const {
  Scalar time = bodies_.dt;
  if constexpr (kSeparates) {
    for (const auto& state : bodies_.states) {  // Bound: kMaxBodies
      if (state.present && state.group != BodiesT::kAlone) time = min_of(time, state.held_until);
    }
  }
  if constexpr (kBends<SceneT>) {
    for (const auto& state : bodies_.states) {  // Bound: kMaxBodies
      if (state.present) time = min_of(time, state.plan_end);
    }
  }
  return time;
}

/// Whose course was cut short, and ends now.
template <class SceneT>
void GeneralWorld<SceneT>::end_courses(Scalar time) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!bodies_.states[slot].present || time < bodies_.plan_end(slot)) continue;
    bodies_.advance_to_now(slot);
    end_course(bodies_, slot, bodies_.dt);
    // Also who was answered at the end of its course: it was planned for no time.
    bodies_.states[slot].changed = bodies_.is_changed = true;
  }
}

template <class SceneT>
void GeneralWorld<SceneT>::release(Scalar time) {
  bodies_.now = time;
  if (!(time < bodies_.dt)) return;
  if constexpr (kBends<SceneT>) end_courses(time);
  if constexpr (kSeparates) {
    for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
      const auto& state = bodies_.states[slot];
      const bool is_held = state.present && state.group != BodiesT::kAlone;
      if (is_held && !(time < state.held_until)) bodies_.part_group(slot);
    }
  }
}

/// Whether neither of the two has gone anywhere in this step, nor was it changed before it.
template <class SceneT>
bool GeneralWorld<SceneT>::rests([[maybe_unused]] ProxyPair pair) const {
  if constexpr (SceneT::kSleep) {
    return sleep_.rests(bodies_, BodiesT::body_of(pair.first)) &&
           sleep_.rests(bodies_, BodiesT::body_of(pair.second));
  }
  return false;
}

template <class SceneT>
void GeneralWorld<SceneT>::end_step() {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (bodies_.states[slot].present) bodies_.finish(slot);
  }
  if constexpr (kSolves) {
    give_back_moments(bodies_, groups_);
    touches_.end_step(
        bodies_, [this](ProxyPair pair) { return rest_gap(bodies_, pair); },
        [this](ProxyPair pair) { return groups_.presses(pair) || rests(pair); },
        [this](ProxyPair pair) { groups_.tell_again(pair); });
    groups_.end_step();
  } else if constexpr (SceneT::kMaxEvents > 0) {
    touches_.end_step(
        bodies_, [this](ProxyPair) { return bodies_.settings.separation; },
        [](ProxyPair) { return false; }, [](ProxyPair) {});
  }
  if constexpr (SceneT::kSleep) sleep_.end_step(bodies_, groups_);
}

template <class SceneT>
Status GeneralWorld<SceneT>::configure(const WorldSettings<SceneT>& settings) {
  const Status status = validate(settings);
  if (status != Status::kOk) return status;
  if constexpr (SceneT::kSleep && SceneT::kGravity) {
    if (!is_same(settings.gravity_W, bodies_.settings.gravity_W)) sleep_.disturb_all(bodies_);
  }
  if constexpr (kSolves) groups_.boxed_for = 0;
  bodies_.settings = settings;
  return status;
}

template <class SceneT>
Result<typename GeneralWorld<SceneT>::BodyId> GeneralWorld<SceneT>::add(const ActorType& actor) {
  if (!may_come(actor)) return failure<BodyId>(Status::kInvalidArgument);
  const auto id = bodies_.actors.make(actor);
  if (!id.ok()) return id;
  ActorType& made = bodies_.actors.at(id.value.index1 - 1U);  // it lives
  Kinematics::prepare(made, made.body);
  if constexpr (SceneT::kSleep) {
    sleep_.add(bodies_, static_cast<std::size_t>(bodies_.actors.index_of(id.value)));
  }
  return id;
}

template <class SceneT>
Status GeneralWorld<SceneT>::remove(BodyId id) {
  const int index = bodies_.actors.index_of(id);
  const Status status = bodies_.actors.remove(id);
  if (status != Status::kOk) return status;
  const auto slot = static_cast<std::size_t>(index);
  bodies_.states[slot] = {};  // first: its neighbours wake all that sleep, and it is gone
  if constexpr (SceneT::kSleep) {
    sleep_.disturb_neighbours(bodies_, groups_, slot);
  }
  if constexpr (kSolves) groups_.remove(slot);
  touches_.remove(slot);
  for (int part = 0; part < BodiesT::kParts; ++part) {  // Bound: kCapsulesPerBody
    pairs_.forget(BodiesT::proxy_of(slot, part));
  }
  pairs_.remove_boxes(slot);
  return status;
}

template <class SceneT>
void GeneralWorld<SceneT>::restore(const GeneralWorld& saved) {
  if (&saved == this) return;
  pairs_.copy(saved.pairs_);
  touches_.copy(saved.touches_);
  if constexpr (kSolves) groups_.copy(saved.groups_);
  if constexpr (SceneT::kSleep) sleep_.copy(saved.sleep_);
  bodies_.settings = saved.bodies_.settings;
  bodies_.actors.restore(saved.bodies_.actors);
  bodies_.report = saved.bodies_.report;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    auto& state = bodies_.states[slot];
    state.plan = saved.bodies_.states[slot].plan;
    state.stands = saved.bodies_.states[slot].stands;
    state.asleep = saved.bodies_.states[slot].asleep;
    state.boxed = false;
  }
}

/// What a step sets up for itself is not part of what is saved, but for who stands where; of the
/// world that was there nothing is left.
template <class SceneT>
template <class Archive>
void GeneralWorld<SceneT>::archive(Archive& ar) {
  archive_scene<SceneT>(ar);
  pairs_.archive(ar);
  if constexpr (SceneT::kSleep) sleep_.archive(ar);
  ar(bodies_.settings, bodies_.actors, bodies_.report);
  touches_.archive(ar, bodies_);
  if constexpr (kSolves) groups_.archive(ar, bodies_);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    const auto& state = bodies_.states[slot];
    const bool is_present = bodies_.actors.at_index(slot) != nullptr;
    bool stands = state.stands && is_present &&
                  Kinematics::is_at_start(bodies_.actor(slot).body, state.plan.motion);
    bool asleep = state.asleep && is_present;
    ar(stands);
    if constexpr (SceneT::kSleep) ar(asleep);
    if (ar.reading()) {
      pairs_.remove_boxes(slot);
      take_stand(slot, stands, asleep);
    }
  }
}

/// What was read of a body's planned motion: whether it stood where it is. What sleeps flew by its
/// momentum; and who was disturbed before it was saved stands nowhere.
template <class SceneT>
void GeneralWorld<SceneT>::take_stand(std::size_t slot, bool stands, bool asleep) {
  auto& state = bodies_.states[slot];
  const bool is_present = bodies_.actors.at_index(slot) != nullptr;
  state = {};
  state.stands = stands;
  if constexpr (SceneT::kSleep) {
    state.asleep = asleep && is_present;
    state.plan.by_momentum = state.asleep;
    if (!stands) state.plan.motion.X_WB.p_W.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
  }
  if (stands && is_present) {
    state.plan.motion = Kinematics::standing(bodies_.actor(slot).body, Scalar(0));
  }
}

}  // namespace batuta::detail
