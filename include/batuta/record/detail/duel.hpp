// SPDX-License-Identifier: MIT
#pragma once
// The members of a duel's parts, for record/archive.hpp.

#include "batuta/fencing/duel.hpp"
#include "batuta/record/detail/control.hpp"
#include "batuta/record/detail/port.hpp"
#include "batuta/record/detail/world.hpp"

namespace batuta::fencing {

constexpr Side last_of(Side) {
  return Side::kRight;
}
constexpr BodyPart last_of(BodyPart) {
  return BodyPart::kRearShin;
}
constexpr CatchWeight last_of(CatchWeight) {
  return CatchWeight::kLinear;
}
constexpr BoutState last_of(BoutState) {
  return BoutState::kHalt;
}

template <class Scalar>
void archive(Archive& ar, GripSettings<Scalar>& settings) {
  auto& [torque, force, min_regain, max_regain, recover_time, largest_turn, forte, composure,
         settle_torque, max_lost, weight] = settings;
  ar(torque, force, min_regain, max_regain, recover_time, largest_turn, forte, composure,
     settle_torque, max_lost, weight);
}

template <class Scalar>
void archive(Archive& ar, Bone<Scalar>& bone) {
  auto& [start_P, capsule_J] = bone;
  ar(start_P, capsule_J);
}

template <class Scalar>
void archive(Archive& ar, Limb<Scalar>& limb) {
  auto& [goal_F, bend_F] = limb;
  ar(goal_F, bend_F);
}

template <class Scalar>
void archive(Archive& ar, FencerBuild<Scalar>& build) {
  auto& [bones, weapon_arm, other_arm, front_leg, rear_leg, guard_hand_x, lunge_hand_x,
         lunge_shift_F, stride_F, lunge_lean, shoulder_give] = build;
  ar(bones, weapon_arm, other_arm, front_leg, rear_leg, guard_hand_x, lunge_hand_x, lunge_shift_F,
     stride_F, lunge_lean, shoulder_give);
}

template <class Scalar>
void archive(Archive& ar, WeaponMass<Scalar>& weapon) {
  auto& [mass, moments, X_HB] = weapon;
  ar(mass, moments, X_HB);
}

template <class Scalar>
void archive(Archive& ar, Salle<Scalar>& salle) {
  auto& [distance] = salle;
  ar(distance);
}

template <class Scalar>
void archive(Archive& ar, FeetSettings<Scalar>& settings) {
  auto& [forward_speed, backward_speed, acceleration] = settings;
  ar(forward_speed, backward_speed, acceleration);
}

template <class Scalar>
void archive(Archive& ar, Strip<Scalar>& strip) {
  auto& [length, end_room, least_distance, corps_a_corps_us] = strip;
  ar(length, end_room, least_distance, corps_a_corps_us);
}

template <class SceneT>
void archive(Archive& ar, FootworkSettings<SceneT>& settings) {
  auto& [feet, strip] = settings;
  ar(feet, strip);
}

template <class Scalar>
void archive(Archive& ar, Moment<Scalar>& moment) {
  auto& [step, in_step] = moment;
  ar(step, in_step);
}

template <class Scalar>
void archive(Archive& ar, Waypoint<Scalar>& waypoint) {
  auto& [time, X_WB] = waypoint;
  ar(time, X_WB);
}

template <class Scalar, int N>
void archive(Archive& ar, Corners<Scalar, N>& way) {
  auto& [corners, first_blow, is_cut, steel] = way;
  ar(corners, first_blow, is_cut);
  steel = ar.reading() ? nullptr : steel;  // between steps there is none
}

template <class SceneT>
void archive(Archive& ar, BladeController<SceneT>& controller) {
  using batuta::detail::Nothing;
  static_assert(batuta::detail::takes<BladeController<SceneT>, Nothing, Nothing>() &&
                    !batuta::detail::takes<BladeController<SceneT>, Nothing, Nothing, Nothing>(),
                "archive: BladeController has other bases or members than those listed below");
  ar(static_cast<CornersOf<SceneT>&>(controller), controller.carrier);
}

template <class SceneT>
void archive(Archive& ar, TouchSettings<SceneT>& settings) {
  auto& [touches, halt_us, double_window_us, point_length, least_speed, least_control, largest_slip,
         touch, target] = settings;
  ar(touches, halt_us, double_window_us, point_length, least_speed, least_control, largest_slip,
     touch, target);
}

template <class SceneT>
void archive(Archive& ar, DuelSettings<SceneT>& settings) {
  using Settings = DuelSettings<SceneT>;
  using batuta::detail::Nothing;
  static_assert(
      batuta::detail::takes<Settings, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing>() &&
          !batuta::detail::takes<Settings, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing,
                                 Nothing>(),
      "archive: DuelSettings has other bases or members than those listed below");
  ar(static_cast<TouchSettingsOf<SceneT>&>(settings),
     static_cast<FootworkSettingsOf<SceneT>&>(settings), settings.step_us, settings.stick,
     settings.world, settings.salle);
}

template <class Scalar>
void archive(Archive& ar, Touch<Scalar>& touch) {
  auto& [by, part, when, contact, place, certain] = touch;
  ar(by, part, when, contact, place, certain);
}

template <class Scalar>
void archive(Archive& ar, Bout<Scalar>& bout) {
  auto& [state, annulled, score, touches, exchange, halt_steps] = bout;
  ar(state, annulled, score, touches, exchange, halt_steps);
}

inline void archive(Archive& ar, DuelReport& report) {
  auto& [blows, rests, evaluations, touch_searches, incomplete_steps, budget_outs,
         searches_invalid] = report;
  ar(blows, rests, evaluations, touch_searches, incomplete_steps, budget_outs, searches_invalid);
}

}  // namespace batuta::fencing
