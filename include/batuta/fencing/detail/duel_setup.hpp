// SPDX-License-Identifier: MIT
#pragma once
// How both fencers of a duel come on guard: at the start of a bout, and again after a halt. Part of
// duel_definitions.hpp.

#include "batuta/fencing/duel.hpp"

namespace batuta::fencing {

template <class SceneT>
Status Duel<SceneT>::configure(const Settings& settings, const Fencer<Scalar>& left,
                               const Fencer<Scalar>& right) {
  const auto left_one = [&left]() -> const Fencer<Scalar>& { return left; };
  const auto right_one = [&right]() -> const Fencer<Scalar>& { return right; };
  return configure_with(settings, left_one, right_one);
}

template <class SceneT>
Status Duel<SceneT>::configure(const Settings& settings, FencerMaker<Scalar> left,
                               FencerMaker<Scalar> right) {
  if (left == nullptr || right == nullptr) return Status::kInvalidArgument;
  return configure_with(settings, left, right);
}

/// @param left, right  each is called whenever its fencer is needed: never is one there while the
/// stack is needed for something else
template <class SceneT>
template <class Left, class Right>
Status Duel<SceneT>::configure_with(const Settings& settings, const Left& left,
                                    const Right& right) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  if (!may_fence(left, settings.salle.X_WF(Side::kLeft)) ||
      !may_fence(right, settings.salle.X_WF(Side::kRight))) {
    return Status::kInvalidArgument;
  }

  // From here on nothing can be refused. The world begins anew: whoever is in it, also where bytes
  // that were refused have left others than the two blades, and what it told of the last step.
  settings_ = settings;
  world_.~WorldType();
  ::new (static_cast<void*>(&world_)) WorldType();  // deviation: placement-new
  (void)world_.configure(settings.world);
  if constexpr (Played::kTargets) scoring_.begin();
  if constexpr (Played::kFeet) scoring_.stand_feet();
  take_place(Side::kLeft, left);
  take_place(Side::kRight, right);
  BATUTA_INVARIANT(world_.size() == 2);
  scoring_.report = {};
  steps_ = 0;
  dt_ = static_cast<Scalar>(settings.step_us) * kSecondsPerUs<Scalar>;
  return Status::kOk;
}

/// Whether a fencer's data are in range.
template <class SceneT>
template <class Maker>
bool Duel<SceneT>::may_fence(const Maker& make, const Pose<Scalar>& X_WF) {
  const auto hand = hand_of(make, X_WF);
  Actor<SceneType> blade;
  return hand.ok() && arm(make, hand.value, blade) == Status::kOk;
}

/// Where a fencer's hand starts, W. @returns kOk | kInvalidArgument: body, weapon or map
template <class SceneT>
template <class Maker>
Result<Pose<typename Duel<SceneT>::Scalar>> Duel<SceneT>::hand_of(const Maker& make,
                                                                  const Pose<Scalar>& X_WF) {
  const Fencer<Scalar>& fencer = make();
  bool good = validate(fencer.weapon) == Status::kOk && validate(fencer.map) == Status::kOk;
  if constexpr (Played::kTargets) good = good && validate(fencer.build) == Status::kOk;
  return good ? success(hand_at_start(fencer.map, X_WF).X_WH)
              : failure<Pose<Scalar>>(Status::kInvalidArgument);
}

/// Where a stick starts.
template <class SceneT>
KeyedPose<typename Duel<SceneT>::Scalar> Duel<SceneT>::hand_at_start(const FencerMap<Scalar>& map,
                                                                     const Pose<Scalar>& X_WF) {
  return fencing::hand_at(map, Vec2<Scalar>(Vec2<Scalar>::Zero()), X_WF);
}

/// The blade in the hand. @param[out] blade  usable if the status is kOk
/// @returns kOk | kInvalidArgument (the grip's settings, or a blade that cannot be there)
template <class SceneT>
template <class Maker>
Status Duel<SceneT>::arm(const Maker& make, const Pose<Scalar>& X_WH, Actor<SceneType>& blade) {
  const Fencer<Scalar>& fencer = make();
  const WeaponBody<Scalar>& weapon = fencer.weapon;
  const Pose<Scalar> X_WB = chained(X_WH, weapon.X_HB);
  if constexpr (Played::kCapsulesPerBody == 1) {
    blade.capsule_B = weapon.blade_B;
  } else {
    blade.capsules_B.push(weapon.blade_B);
    blade.capsules_B.push(weapon.guard_B);
    blade.capsules_B.push(weapon.hand_B);
  }
  if constexpr (Played::kRestitution) blade.restitution = weapon.restitution;
  const Status status = put(blade, weapon, X_WB);
  if (status != Status::kOk) return status;
  if (!batuta::detail::may_come(blade)) return Status::kInvalidArgument;
  return blade.controller.take(X_WB, fencer.grip, to_body(weapon.X_HB, Vec3<Scalar>(0, 0, 0)));
}

/// A weapon somewhere, at rest. @returns kOk | kInvalidArgument: it cannot be there
template <class SceneT>
Status Duel<SceneT>::put(Actor<SceneType>& blade, const WeaponMass<Scalar>& weapon,
                         const Pose<Scalar>& X_WB) {
  const auto body = make_body(X_WB, weapon.mass, weapon.moments);
  blade.body = body.value;
  return body.status;
}

/// @pre may_fence(); the blade of the earlier bout is out of the world
template <class SceneT>
template <class Maker>
void Duel<SceneT>::take_place(Side side, const Maker& make) {
  enter(side, make);
  DuelSide& place = at(side);
  (void)place.stick.configure(settings_.stick);
  Actor<SceneType> blade;
  (void)arm(make, hand_at_start(place.map, X_WF(side)).X_WH, blade);
  stand(side, blade);
}

/// What of a fencer is kept.
template <class SceneT>
template <class Maker>
void Duel<SceneT>::enter(Side side, const Maker& make) {
  const Fencer<Scalar>& fencer = make();
  at(side).map = fencer.map;
  at(side).weapon = static_cast<const WeaponMass<Scalar>&>(fencer.weapon);
  if constexpr (Played::kTargets) scoring_.take_place(side, fencer.build);
}

/// On guard, with a blade that is at rest. What was restored may be such that no blade can be
/// there: the duel is then one that was not configured. @pre it is not in the world
template <class SceneT>
void Duel<SceneT>::stand(Side side, Actor<SceneType>& blade) {
  DuelSide& place = at(side);
  place.hand = hand_at_start(place.map, X_WF(side));
  const Pose<Scalar> X_WB = chained(place.hand.X_WH, place.weapon.X_HB);
  const Status status = put(blade, place.weapon, X_WB);
  blade.controller.place(X_WB);
  if constexpr (Played::kTargets) scoring_.stand(side, {X_WF(side), place.hand.X_WH}, X_WB);
  const auto added = world_.add(blade);
  if (status != Status::kOk || !added.ok()) dt_ = 0;
  place.blade = added.value;
}

/// The next exchange. Each blade leaves the world and comes back: it keeps nothing of them.
template <class SceneT>
void Duel<SceneT>::resume_after_halt() {
  if constexpr (Played::kFeet) scoring_.stand_feet();
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    at(side).stick.start_from_centre();
    Actor<SceneType> blade = blade_of(side);
    (void)world_.remove(at(side).blade);
    stand(side, blade);
  }
  if constexpr (Played::kTargets) scoring_.resume();
}

}  // namespace batuta::fencing
