// SPDX-License-Identifier: MIT
#pragma once
// What a duel does, whatever its search: duel.cpp and duel_stepping.cpp build one each, so that a
// program links one search only.

#include "batuta/fencing/duel.hpp"

namespace batuta {

inline constexpr std::int32_t kShortestStepUs = 100;
inline constexpr std::int32_t kLongestStepUs = 20000;
inline constexpr std::int32_t kLongestWindowUs = 10000000;
inline constexpr std::array<Side, 2> kSides = {Side::kLeft, Side::kRight};

template <class Scalar, class SearchT>
Status validate(const DuelSettings<Scalar, SearchT>& settings) {
  const bool times = settings.step_us >= kShortestStepUs && settings.step_us <= kLongestStepUs &&
                     settings.double_window_us >= 0 &&
                     settings.double_window_us <= kLongestWindowUs;
  const bool place =
      settings.salle.distance > Scalar(0) && settings.salle.distance <= kLargestReach<Scalar>;
  const bool good = times && place && validate(settings.stick) == Status::kOk &&
                    validate(settings.world) == Status::kOk &&
                    validate(settings.touch) == Status::kOk;
  return good ? Status::kOk : Status::kInvalidArgument;
}

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

template <class Scalar, class SearchT>
DuelSettings<Scalar, SearchT> duel_settings() {
  DuelSettings<Scalar, SearchT> settings;
  settings.world.rest_speed = Scalar(0.05F);
  settings.world.separation = Scalar(2e-4F);
  settings.world.min_separation_time = Scalar(1e-4F);
  settings.target = kAllParts & ~mask_of(BodyPart::kWeaponHand);  // the bell guard covers it
  if constexpr (!SearchT::kHasSlab) {
    settings.touch.epsilon = Scalar(0.001F);
    settings.touch.unit = EpsilonIn::kMetres;
  }
  return settings;
}

template <class Scalar, class SearchT>
Status Duel<Scalar, SearchT>::configure(const Settings& settings, const Fencer<Scalar>& left,
                                        const Fencer<Scalar>& right) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  const auto left_seat = seat_for(left, settings.salle.X_WF(Side::kLeft));
  const auto right_seat = seat_for(right, settings.salle.X_WF(Side::kRight));
  if (!left_seat.ok() || !right_seat.ok()) return Status::kInvalidArgument;

  // From here on nothing can be refused.
  settings_ = settings;
  (void)world_.configure(settings.world);
  for (Place& place : places_) (void)world_.remove(place.blade);  // Bound: 2
  take_place(at(Side::kLeft), left_seat.value, left.build);
  take_place(at(Side::kRight), right_seat.value, right.build);
  bout_ = {};
  report_ = {};
  steps_ = 0;
  dt_ = static_cast<Scalar>(settings.step_us) * kSecondsPerUs<Scalar>;
  return Status::kOk;
}

template <class Scalar, class SearchT>
Result<typename Duel<Scalar, SearchT>::Seat> Duel<Scalar, SearchT>::seat_for(
    const Fencer<Scalar>& fencer, const Pose<Scalar>& X_WF) {
  if (validate(fencer.build) != Status::kOk) return failure<Seat>(Status::kInvalidArgument);
  typename FencerGrid<Scalar>::Keys keys_WH;
  for (std::size_t i = 0; i < keys_WH.size(); ++i) {  // Bound: nine keys
    // A NaN goes on to set_keys().
    const bool far = fencer.keys_FH[i].p_W.cwiseAbs().maxCoeff() > kLargestReach<Scalar>;
    if (far) return failure<Seat>(Status::kInvalidArgument);
    keys_WH[i] = chained(X_WF, fencer.keys_FH[i]);
  }
  const auto weapon = weapon_body(fencer.weapon);
  Seat seat;
  if (!weapon.ok() || seat.grid.set_keys(keys_WH) != Status::kOk) {
    return failure<Seat>(Status::kInvalidArgument);
  }
  seat.weapon = weapon.value;
  seat.X_WF = X_WF;
  seat.hand = seat.grid.at(Vec2<Scalar>::Zero());  // where a stick starts
  if (arm(fencer, seat) != Status::kOk) return failure<Seat>(Status::kInvalidArgument);
  return success(seat);
}

/// The blade in the hand.
template <class Scalar, class SearchT>
Status Duel<Scalar, SearchT>::arm(const Fencer<Scalar>& fencer, Seat& seat) {
  const Pose<Scalar> X_WB = chained(seat.hand.X_WH, seat.weapon.X_HB);
  const auto body = make_body(X_WB, seat.weapon.mass, seat.weapon.moments);
  if (!body.ok()) return body.status;
  seat.blade.body = body.value;
  seat.blade.capsule_B = seat.weapon.blade_B;
  seat.blade.restitution = fencer.weapon.restitution;
  seat.blade.driver.grip.place(X_WB);
  return seat.blade.driver.grip.configure(fencer.grip);
}

/// @pre both blades of the earlier bout are out of the world
template <class Scalar, class SearchT>
void Duel<Scalar, SearchT>::take_place(Place& place, const Seat& seat,
                                       const FencerBuild<Scalar>& build) {
  place.grid = seat.grid;
  place.build = build;
  place.weapon = seat.weapon;
  place.X_WF = seat.X_WF;
  place.hand = seat.hand;
  (void)place.stick.configure(settings_.stick);
  place.target.place(pose_body(build, seat.X_WF, seat.hand.X_WH));
  const auto blade = world_.add(seat.blade);
  BATUTA_INVARIANT(blade.ok());
  place.blade = blade.value;
}

template <class Scalar, class SearchT>
Status Duel<Scalar, SearchT>::step(const InputSample* left, const InputSample* right) {
  if (!(dt_ > Scalar(0))) return Status::kInvalidArgument;
  if (bout_.is_over()) return Status::kUnavailable;
  move_hand(Side::kLeft, left);
  move_hand(Side::kRight, right);
  const Status status = world_.step(dt_);
  if (status != Status::kOk) return status;
  add_up();
  look_for_touches();
  ++steps_;
  close_window();
  return Status::kOk;
}

template <class Scalar, class SearchT>
void Duel<Scalar, SearchT>::move_hand(Side side, const InputSample* sample) {
  Place& place = at(side);
  if (sample != nullptr) (void)place.stick.accept(*sample);
  place.stick.advance(dt_);
  place.hand = place.grid.at(place.stick.position());
  place.target.move_to(pose_body(place.build, place.X_WF, place.hand.X_WH), dt_);

  auto& actor = *world_.get(place.blade);
  place.start_WB = actor.body.X_WB;
  actor.driver.corners.clear();
  actor.driver.grip.command(chained(place.hand.X_WH, place.weapon.X_HB), dt_);
}

template <class Scalar, class SearchT>
void Duel<Scalar, SearchT>::add_up() {
  const StepReport<Scalar>& step = world_.report();
  report_.blows += step.collisions;
  report_.rests += step.separations;
  report_.evaluations += step.evaluations;
  report_.budget_outs += step.searches_cut;
  report_.searches_invalid += step.searches_invalid;
  if (!step.complete()) ++report_.incomplete_steps;
}

/// Both blades are looked at before either touch is judged; the earlier one is noted first, the
/// left one of two at once.
template <class Scalar, class SearchT>
void Duel<Scalar, SearchT>::look_for_touches() {
  std::array<TouchSearch<Scalar>, 2> searches;
  for (const Side side : kSides) searches[index_of(side)] = touch_by(side);  // Bound: 2
  const bool right_first =
      searches[1].found && (!searches[0].found || searches[1].t_free < searches[0].t_free);
  const Side first = right_first ? Side::kRight : Side::kLeft;
  note(first, searches[index_of(first)]);
  note(other(first), searches[index_of(other(first))]);
}

/// The first touch of a blade on its way through the step: from its start over the corners where
/// contacts were answered to its end.
template <class Scalar, class SearchT>
TouchSearch<Scalar> Duel<Scalar, SearchT>::touch_by(Side side) {
  const Place& place = at(side);
  const auto& actor = *world_.get(place.blade);
  const auto& corners = actor.driver.corners;
  TouchSearch<Scalar> first;
  bool complete = true;
  Scalar known_until = dt_;
  Waypoint<Scalar> start{Scalar(0), place.start_WB};
  for (int k = 0; k <= corners.size() && !first.found; ++k) {  // Bound: kMaxContacts + 1 pieces
    const Waypoint<Scalar> end =
        k < corners.size() ? corners[k] : Waypoint<Scalar>{dt_, actor.body.X_WB};
    const Piece<Scalar> piece = piece_between(start, end);
    first = at(other(side))
                .target.template find_touch<SearchT>({actor.capsule_B, piece.motion}, piece.from,
                                                     settings_.touch, settings_.target);
    report_.evaluations += first.evaluations;
    report_.touch_searches += first.searches;
    report_.budget_outs += first.budget_outs;
    report_.searches_invalid += first.searches_invalid;
    if (!first.complete && complete) known_until = first.known_until;
    complete = complete && first.complete;
    start = end;
  }
  first.complete = complete;
  first.known_until = known_until;
  return first;
}

template <class Scalar, class SearchT>
void Duel<Scalar, SearchT>::note(Side by, const TouchSearch<Scalar>& search) {
  if (!search.found) return;
  if (bout_.touches.size() > 0 && bout_.touches[0].by == by) return;
  Touch<Scalar> touch;
  touch.by = by;
  touch.part = search.part;
  touch.when = {steps_, search.t_free};
  touch.contact = search.contact;
  touch.place = search.place;
  touch.certain = search.certain();
  if (bout_.touches.size() > 0 && !within_window(bout_.touches[0].when, touch.when)) return;
  bout_.touches.push(touch);
  bout_.state = bout_.touches.size() == 2 ? BoutState::kDouble : BoutState::kLockout;
}

template <class Scalar, class SearchT>
bool Duel<Scalar, SearchT>::within_window(const Moment<Scalar>& first,
                                          const Moment<Scalar>& second) const {
  return time_us(second) - time_us(first) <= static_cast<std::uint64_t>(settings_.double_window_us);
}

/// The other's chance is over when the next step begins behind the window.
template <class Scalar, class SearchT>
void Duel<Scalar, SearchT>::close_window() {
  if (bout_.state != BoutState::kLockout) return;
  if (!within_window(bout_.touches[0].when, {steps_, Scalar(0)})) bout_.state = BoutState::kTouched;
}

template <class Scalar, class SearchT>
std::uint64_t Duel<Scalar, SearchT>::time_us(const Moment<Scalar>& moment) const {
  // 32 bits are plenty for a step; to 64, a target without double converts by way of double.
  const auto in_step =
      static_cast<std::uint32_t>(moment.in_step / kSecondsPerUs<Scalar> + Scalar(0.5F));
  return std::uint64_t{moment.step} * static_cast<std::uint64_t>(settings_.step_us) + in_step;
}

/// What was read is a state that steps can go on from: as far as an index, a conversion or a
/// precondition depends on it.
template <class Scalar, class SearchT>
bool Duel<Scalar, SearchT>::is_sound() const {
  bool good = validate(settings_) == Status::kOk &&
              dt_ == static_cast<Scalar>(settings_.step_us) * kSecondsPerUs<Scalar>;
  for (const Place& place : places_) {  // Bound: 2
    const auto* blade = world_.get(place.blade);
    good = good && blade != nullptr && is_valid(blade->capsule_B) &&
           validate(place.build) == Status::kOk &&
           place.stick.position().cwiseAbs().maxCoeff() <= Scalar(1);
  }
  for (const Touch<Scalar>& touch : bout_.touches) {  // Bound: 2
    good = good && touch.when.in_step >= Scalar(0) && touch.when.in_step <= dt_;
  }
  const bool both = at(Side::kLeft).blade != at(Side::kRight).blade;
  return good && both && world_.size() == 2 && bout_.touches.size() == touches_in(bout_.state);
}

template <class Scalar, class SearchT>
const Actor<DuelScene<Scalar, SearchT>>& Duel<Scalar, SearchT>::blade_of(Side side) const {
  const auto* blade = world_.get(at(side).blade);
  BATUTA_ASSERT(blade != nullptr);
  return *blade;
}

template <class Scalar, class SearchT>
const Grip<Scalar>& Duel<Scalar, SearchT>::grip(Side side) const {
  return blade_of(side).driver.grip;
}

template <class Scalar, class SearchT>
Capsule<Scalar> Duel<Scalar, SearchT>::blade_W(Side side) const {
  const auto& blade = blade_of(side);
  return to_world(blade.body.X_WB, blade.capsule_B);
}

}  // namespace batuta
