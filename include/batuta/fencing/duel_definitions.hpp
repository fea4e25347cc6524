// SPDX-License-Identifier: MIT
#pragma once
// What a duel does, whatever its search and its scene. The library holds the duels of DuelScene:
// src/fencing/duel.cpp and duel_stepping.cpp build those of one search each, so that a program
// links one search only. For a scene of one's own, include this header in one source and name there
//   template DuelSettings<Drill> batuta::fencing::duel_settings();
//   template class batuta::fencing::Duel<Drill>;
// or include it wherever such a duel is used.

#include "batuta/fencing/detail/duel_setup.hpp"
#include "batuta/fencing/detail/referee_definitions.hpp"

namespace batuta::fencing {

namespace detail {

/// Least DuelSettings::step_us.
inline constexpr std::int32_t kShortestStepUs = 100;
/// Largest DuelSettings::step_us.
inline constexpr std::int32_t kLongestStepUs = 20000;
/// Largest TouchSettings::double_window_us.
inline constexpr std::int32_t kLongestWindowUs = 10000000;
/// Largest TouchSettings::halt_us.
inline constexpr std::int32_t kLongestHaltUs = 10000000;
/// Largest Strip::corps_a_corps_us.
inline constexpr std::int32_t kLongestCorpsACorpsUs = 10000000;

/// @returns kOk | kInvalidArgument: out of range
template <class SceneT>
Status validate(const TouchSettings<SceneT>& settings) {
  using Scalar = typename SceneT::Scalar;
  const bool good = settings.touches >= 1 && settings.touches <= kMostTouches &&
                    settings.halt_us >= 0 && settings.halt_us <= kLongestHaltUs &&
                    settings.double_window_us >= 0 &&
                    settings.double_window_us <= kLongestWindowUs && settings.point_length > 0 &&
                    settings.point_length <= kLargestReach<Scalar> && settings.least_speed >= 0 &&
                    settings.least_speed <= kLargestReach<Scalar> && settings.least_control >= 0 &&
                    settings.least_control <= 1 && settings.largest_slip >= 0 &&
                    settings.largest_slip <= kLargestReach<Scalar>;
  return good ? validate(settings.touch) : Status::kInvalidArgument;
}

/// @returns kOk | kInvalidArgument: out of range
template <class Scalar>
Status validate(const Strip<Scalar>& strip) {
  const Vec3<Scalar> lengths(strip.length, strip.end_room, strip.least_distance);
  const bool good = is_finite(lengths) && lengths.minCoeff() >= Scalar(0) &&
                    lengths.maxCoeff() <= kLargestReach<Scalar> && strip.corps_a_corps_us >= 0 &&
                    strip.corps_a_corps_us <= kLongestCorpsACorpsUs;
  return good ? Status::kOk : Status::kInvalidArgument;
}

}  // namespace detail

/// @returns kOk | kInvalidArgument: a setting out of its range (DuelSettings, TouchSettings,
/// FootworkSettings), or a distance of the fencers that is not positive or too large
template <class SceneT>
Status validate(const DuelSettings<SceneT>& settings) {
  using Played = PlayedScene<SceneT>;
  using Scalar = typename Played::Scalar;
  bool good = settings.step_us >= detail::kShortestStepUs &&
              settings.step_us <= detail::kLongestStepUs && settings.salle.distance > Scalar(0) &&
              settings.salle.distance <= kLargestReach<Scalar> &&
              validate(settings.stick) == Status::kOk && validate(settings.world) == Status::kOk;
  if constexpr (batuta::detail::kKnowsRest<Played>) {
    good = good && settings.world.rest_speed <= kLargestReach<Scalar> &&
           settings.world.separation <= kLargestReach<Scalar> &&
           settings.world.min_separation_time <= kLargestReach<Scalar>;
  }
  if constexpr (Played::kTargets) {
    good = good &&
           detail::validate(static_cast<const TouchSettings<Played>&>(settings)) == Status::kOk;
  }
  if constexpr (Played::kFeet) {
    good = good && validate(settings.feet) == Status::kOk &&
           detail::validate(settings.strip) == Status::kOk;
  }
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class SceneT>
DuelSettings<SceneT> duel_settings() {
  using Played = PlayedScene<SceneT>;
  using Scalar = typename Played::Scalar;
  DuelSettings<SceneT> settings;
  if constexpr (batuta::detail::kKnowsRest<Played>) {
    settings.world.rest_speed = Scalar(0.05F);
    settings.world.separation = Scalar(2e-4F);
    settings.world.min_separation_time = Scalar(1e-4F);
  }
  if constexpr (Played::kTargets) {
    settings.target = kAllParts & ~mask_of(BodyPart::kWeaponHand);  // the bell guard covers it
  }
  if constexpr (Played::kTargets && !Played::Search::kHasContactTolerance) {
    settings.touch.epsilon = Scalar(0.001F);
    settings.touch.unit = EpsilonIn::kMetres;
  }
  return settings;
}

template <class SceneT>
Status Duel<SceneT>::step(const InputSample* left, const InputSample* right) {
  if (!(dt_ > Scalar(0))) return Status::kInvalidArgument;
  if (bout().is_over()) return Status::kUnavailable;
  if constexpr (Played::kTargets) {
    if (bout().is_halt_over()) resume_after_halt();
    if (!(dt_ > Scalar(0))) return Status::kInvalidArgument;
  }
  lead(left, right);
  const Status status = move_blades();
  if (status != Status::kOk) return status;
  ++steps_;
  return Status::kOk;
}

/// Sticks, feet and hands go where they are asked to.
template <class SceneT>
void Duel<SceneT>::lead(const InputSample* left, const InputSample* right) {
  move_stick(Side::kLeft, left);
  move_stick(Side::kRight, right);
  const MapPlace<Scalar> asked_left = asked_of(Side::kLeft);
  const MapPlace<Scalar> asked_right = asked_of(Side::kRight);
  walk(asked_left.feet, asked_right.feet);
  move_hand(Side::kLeft, asked_left);
  move_hand(Side::kRight, asked_right);
}

/// The world's step, in which each blade stops at the other's body, and who touched whom in it.
template <class SceneT>
Status Duel<SceneT>::move_blades() {
  if constexpr (Played::kTargets) {
    std::array<Steel<Scalar>, 2> steel;
    for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
      auto& blade = *world_.steer(at(side).blade);
      steel[index_of(side)] = scoring_.steel_for(side, blade, dt_);
      blade.controller.steel = &steel[index_of(side)];
    }
    const Status status = world_.step(dt_);
    std::array<const Actor<SceneType>*, 2> blades{};
    for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
      auto& blade = *world_.steer(at(side).blade);
      blade.controller.steel = nullptr;
      blades[index_of(side)] = &blade;
    }
    if (status != Status::kOk) return status;
    add_up();
    if (world_.report().time_held > Scalar(0)) carry_blades();
    scoring_.judge(blades, steel, settings_, {steps_, dt_}, scoring_.report);
    halt_corps_a_corps();
    return status;
  } else {
    const Status status = world_.step(dt_);
    if (status == Status::kOk) add_up();
    return status;
  }
}

/// Two who have stood body to body for long, and whom nobody has touched, are sent on guard.
template <class SceneT>
void Duel<SceneT>::halt_corps_a_corps() {
  if constexpr (Played::kTargets && Played::kFeet) {
    if (bout().state != BoutState::kFencing) return;
    if (scoring_.count_body_to_body(settings_)) scoring_.call_halt(settings_);
  }
}

template <class SceneT>
void Duel<SceneT>::move_stick(Side side, const InputSample* sample) {
  StickTracker<Scalar>& stick = at(side).stick;
  if (sample != nullptr) (void)stick.accept(*sample);
  stick.advance(dt_, is_beaten(side) ? StickFollow::kBack : StickFollow::kAll);
}

/// Whether a blow has cost a fencer's hand its line: then he follows nothing but what draws him
/// back.
template <class SceneT>
bool Duel<SceneT>::is_beaten([[maybe_unused]] Side side) const {
  if constexpr (Played::kGrip) return grip(side).phase() == GripPhase::kBeaten;
  return false;
}

/// What the map makes of a stick.
template <class SceneT>
MapPlace<typename Duel<SceneT>::Scalar> Duel<SceneT>::asked_of(Side side) const {
  return place_on(at(side).map, at(side).stick.position());
}

/// What a device asks of the feet, -1 ... 1: by its second pair of axes, and by where the map has
/// the first.
template <class SceneT>
typename Duel<SceneT>::Scalar Duel<SceneT>::feet_order(Side side, Scalar asked) const {
  const Scalar order = at(side).stick.feet().y() + asked;
  return clamp(order, Scalar(-1), is_beaten(side) ? Scalar(0) : Scalar(1));
}

/// @param left, right  what the map asks of their feet
template <class SceneT>
void Duel<SceneT>::walk([[maybe_unused]] Scalar left, [[maybe_unused]] Scalar right) {
  if constexpr (Played::kFeet) {
    const Vec2<Scalar> orders(feet_order(Side::kLeft, left), feet_order(Side::kRight, right));
    scoring_.walk(orders, settings_, dt_);
  }
}

template <class SceneT>
Pose<typename Duel<SceneT>::Scalar> Duel<SceneT>::X_WF(Side side) const {
  if constexpr (Played::kFeet) return settings_.salle.X_WF(side, feet(side).way());
  return settings_.salle.X_WF(side);
}

template <class SceneT>
void Duel<SceneT>::move_hand(Side side, const MapPlace<Scalar>& asked) {
  DuelSide& place = at(side);
  place.hand = hand_at(asked, X_WF(side));

  auto& actor = *world_.steer(place.blade);
  if constexpr (Played::kTargets) {
    scoring_.follow(side, {X_WF(side), place.hand.X_WH}, actor, dt_);
  }
  actor.controller.command(chained(place.hand.X_WH, place.weapon.X_HB), dt_);
}

/// Blades that the world held together stood while a body went on into one of them: it carries
/// both, which stay as they are to each other.
template <class SceneT>
void Duel<SceneT>::carry_blades() {
  if constexpr (Played::kTargets) {
    for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
      const Vec3<Scalar> way_W = scoring_.way_out(side, blade_of(side));
      for (DuelSide& place : places_) {  // Bound: 2
        world_.steer(place.blade)->body.X_WB.p_W += way_W;
      }
    }
  }
}

template <class SceneT>
void Duel<SceneT>::add_up() {
  const StepReport<Scalar>& step = world_.report();
  scoring_.report.blows += step.collisions;
  scoring_.report.rests += step.separations;
  scoring_.report.evaluations += step.evaluations;
  scoring_.report.budget_outs += step.searches_cut;
  scoring_.report.searches_invalid += step.searches_invalid;
  if (!step.complete()) ++scoring_.report.incomplete_steps;
}

/// What was read is a state that steps can go on from: as far as an index, a conversion or a
/// precondition depends on it.
template <class SceneT>
bool Duel<SceneT>::is_sound() const {
  bool good = validate(settings_) == Status::kOk &&
              dt_ == static_cast<Scalar>(settings_.step_us) * kSecondsPerUs<Scalar>;
  for (const DuelSide& place : places_) {  // Bound: 2
    const auto* blade = world_.get(place.blade);
    good = good && blade != nullptr && parts_of(*blade) == Played::kCapsulesPerBody &&
           is_valid(part_of(*blade, 0));
  }
  if constexpr (Played::kFeet) good = good && scoring_.is_footing_sound(settings_);
  if constexpr (Played::kTargets) good = good && scoring_.is_sound(settings_, dt_);
  const bool both = at(Side::kLeft).blade != at(Side::kRight).blade;
  return good && both && world_.size() == 2;
}

template <class SceneT>
const Actor<typename Duel<SceneT>::SceneType>& Duel<SceneT>::blade_of(Side side) const {
  const auto* blade = world_.get(at(side).blade);
  BATUTA_ASSERT(blade != nullptr);
  return *blade;
}

template <class SceneT>
auto Duel<SceneT>::blade_W(Side side) const -> Capsule<Scalar> {
  const auto& blade = blade_of(side);
  return to_world(blade.body.X_WB, part_of(blade, 0));
}

}  // namespace batuta::fencing
