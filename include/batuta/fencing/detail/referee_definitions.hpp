// SPDX-License-Identifier: MIT
#pragma once
// What a referee does, whatever the scene; see duel_definitions.hpp.

#include "batuta/fencing/detail/referee.hpp"

namespace batuta::fencing {

namespace detail {

/// Whether a halt may come without a touch.
template <class SceneT>
bool knows_corps_a_corps([[maybe_unused]] const DuelSettings<SceneT>& settings) {
  if constexpr (PlayedScene<SceneT>::kFeet) return settings.strip.corps_a_corps_us > 0;
  return false;
}

/// Whether an exchange in this state may have brought so many touches.
/// @param least_of_halt  touches that a halt needs
constexpr bool has_touches(BoutState state, int touches, int least_of_halt) {
  if (state == BoutState::kFencing) return touches == 0;
  if (state == BoutState::kHalt) return touches >= least_of_halt;
  return touches == (state == BoutState::kDouble ? 2 : 1);
}

/// @pre both are valid
template <class Scalar>
Scalar gap_between(const Capsule<Scalar>& A, const Capsule<Scalar>& B) {
  return closest_points(A.axis, B.axis).distance - (A.radius + B.radius);
}

/// One piece of a blade's way in a step.
template <class Scalar>
Motion<Scalar> piece_between(const Waypoint<Scalar>& start, const Waypoint<Scalar>& end) {
  const Scalar duration = end.time - start.time;
  if (!(duration > Scalar(0))) return still(end.X_WB, Scalar(0));
  return motion_between(start.X_WB, end.X_WB, duration);
}

}  // namespace detail

template <class SceneT>
void Referee<SceneT>::begin() {
  bout_ = {};
  for (RefereeSide& place : places_) {  // Bound: 2
    place.hand_W.setZero();
    place.control = 1;
  }
  close_all();
}

/// What the points are in when both come on guard, they have not touched; from the rest they are
/// away, which reopen() finds in the first step.
template <class SceneT>
void Referee<SceneT>::close_all() {
  for (RefereeSide& place : places_) place.closed = kAllParts;  // Bound: 2
}

template <class SceneT>
void Referee<SceneT>::take_place(Side side, const FencerBuild<Scalar>& build) {
  at(side).build = build;
}

template <class SceneT>
void Referee<SceneT>::stand(Side side, const Stance<Scalar>& stance, const Pose<Scalar>& X_WB) {
  RefereeSide& place = at(side);
  place.start_WB = X_WB;
  place.target.place(place.build, stance);
}

template <class SceneT>
void Referee<SceneT>::resume() {
  bout_.state = BoutState::kFencing;
  bout_.touches.clear();
  bout_.annulled = false;
  close_all();
  ++bout_.exchange;
}

template <class SceneT>
void Referee<SceneT>::follow(Side side, const Stance<Scalar>& stance, const Blade& blade,
                             Scalar dt) {
  RefereeSide& place = at(side);
  place.target.move_to(place.build, stance, dt);
  place.hand_W = stance.X_WH.p_W;
  place.control = blade.controller.control();
}

template <class SceneT>
void Referee<SceneT>::judge(const std::array<const Blade*, 2>& blades,
                            const std::array<Steel<Scalar>, 2>& steel, const Settings& settings,
                            const Moment<Scalar>& now, DuelReport& report) {
  if (bout_.state == BoutState::kHalt) {
    --bout_.halt_steps;  // not the last one: is_halt_over() came first
    return;
  }
  const auto touch = [&](Side side) {
    const std::size_t i = index_of(side);
    return touch_by(side, *blades[i], steel[i].came, settings, now.in_step, report);
  };
  const std::array<TouchSearch<Scalar>, 2> searches = {touch(Side::kLeft), touch(Side::kRight)};
  const bool right_first =
      searches[1].found && (!searches[0].found || searches[1].t_free < searches[0].t_free);
  const Side first = right_first ? Side::kRight : Side::kLeft;
  note(first, searches[index_of(first)], settings, now.step);
  note(other(first), searches[index_of(other(first))], settings, now.step);
  if (is_exchange_over(settings, now.step + 1)) end_exchange(settings);
}

/// The first touch of a blade's point on its way through the step: from its start over the corners
/// where contacts were answered to its end.
template <class SceneT>
TouchSearch<typename SceneT::Scalar> Referee<SceneT>::touch_by(Side side, const Blade& blade,
                                                               const Twist<Scalar>& came,
                                                               const Settings& settings, Scalar dt,
                                                               DuelReport& report) {
  const auto& corners = blade.controller.corners;
  PointWay way;
  way.point.capsule_B = detail::point_of(part_of(blade, 0), settings.point_length);
  way.start_W = to_world(at(side).start_WB, way.point.capsule_B);
  reopen(side, way.start_W);
  way.came = came;
  way.hand = {at(side).control, blade.controller.first_blow, slip_of(side, blade)};
  TouchSearch<Scalar> first;
  bool complete = true;
  Scalar known_until = dt;
  const Waypoint<Scalar> begin{Scalar(0), at(side).start_WB};
  const Waypoint<Scalar> last{dt, blade.body.X_WB};
  const Waypoint<Scalar>* start = &begin;
  for (int k = 0; k <= corners.size() && !first.found; ++k) {  // Bound: kMostCorners + 1 pieces
    const Waypoint<Scalar>& end = k < corners.size() ? corners[k] : last;
    const bool is_whole = !blade.controller.is_cut || k + 1 < corners.size();
    if (!is_whole && complete) {
      complete = false;
      known_until = start->time;
    }
    way.point.motion = detail::piece_between(*start, end);
    way.from = start->time;
    touch_in(side, way, settings, report, first);
    if (!first.complete && complete) known_until = first.known_until;
    complete = complete && first.complete;
    start = &end;
  }
  first.complete = complete;
  first.known_until = known_until;
  const Scalar share = detail::share_of_point(part_of(blade, 0), settings.point_length);
  first.place = Scalar(1) - share * (Scalar(1) - first.place);  // of the whole blade
  return first;
}

/// From the grip to where the hand wants it, m.
template <class SceneT>
typename SceneT::Scalar Referee<SceneT>::slip_of([[maybe_unused]] Side side,
                                                 [[maybe_unused]] const Blade& blade) const {
  if constexpr (SceneT::kGrip) {
    const Vec3<Scalar> grip_W = to_world(blade.body.X_WB, blade.controller.carrier.hand_B());
    return (grip_W - at(side).hand_W).norm();
  } else {
    return Scalar(0);
  }
}

/// The larger of what the point does in this step and did in the one before (touch.md, "How fast").
/// Kept apart: what it needs is not there while the search runs.
template <class SceneT>
[[gnu::noinline]] typename SceneT::Scalar Referee<SceneT>::touch_speed(
    const PointWay& way, const MovingCapsule<Scalar>& part, const TouchSearch<Scalar>& found) {
  const Scalar now = detail::entry_speed(way.point, part, found, way.from);
  MovingCapsule<Scalar> before = way.point;
  before.motion.twist = way.came;
  return max_of(now, detail::entry_speed(before, part, found, way.from));
}

/// The first entry of the point in a piece of its way that is a touch. A part that it enters
/// otherwise is closed. @param[out] search  the touch, if it is found
template <class SceneT>
void Referee<SceneT>::touch_in(Side side, const PointWay& way, const Settings& settings,
                               DuelReport& report, TouchSearch<Scalar>& search) {
  Target<Scalar>& target = at(other(side)).target;
  for (int entry = 0; entry <= kBodyParts; ++entry) {  // Bound: kBodyParts + 1
    search = target.template find_touch<Search>(way.point, way.from, settings.touch,
                                                settings.target & ~at(side).closed);
    report.evaluations += search.evaluations;
    report.touch_searches += search.searches;
    report.budget_outs += search.budget_outs;
    report.searches_invalid += search.searches_invalid;
    if (!search.found) return;
    const Scalar speed = touch_speed(way, target.part(search.part), search);
    if (was_outside(side, way.start_W, search.part) &&
        detail::counts<SceneT>(settings, way.hand, search.t_free, speed)) {
      return;
    }
    at(side).closed |= mask_of(search.part);
    search.found = false;
  }
}

/// Whether point and part were apart when the step began: a search that ended without an answer may
/// have let the point in unseen.
/// @param point_W  where it was then
template <class SceneT>
bool Referee<SceneT>::was_outside(Side side, const Capsule<Scalar>& point_W, BodyPart part) const {
  return detail::gap_between(point_W, at(other(side)).target.start_of(part)) > Scalar(0);
}

/// Parts that the point had left when the step began can be touched again.
/// @param point_W  where it was then
template <class SceneT>
void Referee<SceneT>::reopen(Side side, const Capsule<Scalar>& point_W) {
  PartMask& closed = at(side).closed;
  const Target<Scalar>& target = at(other(side)).target;
  for (int i = 0; closed != 0 && i < kBodyParts; ++i) {  // Bound: kBodyParts
    const auto part = static_cast<BodyPart>(i);
    if ((closed & mask_of(part)) == 0) continue;
    const Scalar gap = detail::gap_between(point_W, target.start_of(part));
    if (gap > detail::kPointIsOut<Scalar>) closed &= ~mask_of(part);
  }
}

template <class SceneT>
void Referee<SceneT>::note(Side by, const TouchSearch<Scalar>& search, const Settings& settings,
                           std::uint32_t step) {
  if (!search.found) return;
  if (bout_.touches.size() > 0 && bout_.touches[0].by == by) return;
  Touch<Scalar> touch;
  touch.by = by;
  touch.part = search.part;
  touch.when = {step, search.t_free};
  touch.contact = search.contact;
  touch.place = search.place;
  touch.certain = search.certain();
  if (bout_.touches.size() > 0 && !is_within_window(settings, touch.when)) return;
  bout_.touches.push(touch);
  bout_.state = BoutState::kLockout;
}

/// Whether a second touch at this time counts. Steps are counted in 32 bits: the times of both are
/// those since the step of the first. @pre there is a first one
template <class SceneT>
bool Referee<SceneT>::is_within_window(const Settings& settings,
                                       const Moment<Scalar>& second) const {
  const Moment<Scalar>& first = bout_.touches[0].when;
  const std::uint64_t first_us = time_us(Moment<Scalar>{0, first.in_step}, settings.step_us);
  const std::uint64_t second_us =
      time_us(Moment<Scalar>{second.step - first.step, second.in_step}, settings.step_us);
  return second_us - first_us <= static_cast<std::uint64_t>(settings.double_window_us);
}

/// The other's chance is over when he has taken it, or when the next step begins behind the window.
template <class SceneT>
bool Referee<SceneT>::is_exchange_over(const Settings& settings, std::uint32_t next_step) const {
  if (bout_.state != BoutState::kLockout) return false;
  return bout_.touches.size() == 2 || !is_within_window(settings, {next_step, Scalar(0)});
}

/// Counts the touches, unless both would win by them. @pre one or two touches
template <class SceneT>
void Referee<SceneT>::end_exchange(const Settings& settings) {
  const bool both = bout_.touches.size() == 2;
  auto& [left, right] = bout_.score;
  const int missing = settings.touches - 1;
  bout_.annulled = both && missing > 0 && left == missing && right == missing;
  for (const Touch<Scalar>& touch : bout_.touches) {  // Bound: 2
    if (!bout_.annulled) ++bout_.score[index_of(touch.by)];
  }
  if (left >= settings.touches || right >= settings.touches) {
    bout_.state = both ? BoutState::kDouble : BoutState::kTouched;
  } else {
    call_halt(settings);
  }
}

template <class SceneT>
void Referee<SceneT>::call_halt(const Settings& settings) {
  bout_.state = BoutState::kHalt;
  bout_.halt_steps = detail::whole_steps(settings.halt_us, settings.step_us);
}

template <class SceneT>
bool Referee<SceneT>::is_sound(const Settings& settings, Scalar dt) const {
  const int least_of_halt = detail::knows_corps_a_corps(settings) ? 0 : 1;
  bool good = detail::has_touches(bout_.state, bout_.touches.size(), least_of_halt) &&
              (!bout_.annulled || bout_.touches.size() == 2) &&
              bout_.halt_steps <= detail::whole_steps(settings.halt_us, settings.step_us);
  for (const int score : bout_.score) {  // Bound: 2
    good = good && score <= settings.touches && (bout_.is_over() || score < settings.touches);
  }
  for (const RefereeSide& place : places_) {  // Bound: 2
    good = good && validate(place.build) == Status::kOk;
  }
  for (const Touch<Scalar>& touch : bout_.touches) {  // Bound: 2
    good = good && touch.when.in_step >= Scalar(0) && touch.when.in_step <= dt;
  }
  return good;
}

}  // namespace batuta::fencing
