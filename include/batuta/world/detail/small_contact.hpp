// SPDX-License-Identifier: MIT
#pragma once
// SmallWorld: what a contact is answered with, and who goes on together. Included by
// small_world.hpp.

#include "batuta/world/detail/small_world.hpp"

namespace batuta::detail {

template <class SceneT>
void SmallWorld<SceneT>::resolve(const Meeting& meeting) {
  const std::size_t a = meeting.pair / kSlots;
  const std::size_t b = meeting.pair % kSlots;
  const bool is_contact = is_of_contact(meeting.outcome);
  const bool are_alone = group_[a] == alone(a) && group_[b] == alone(b);
  if (!is_contact || contacts_resolved_ == SceneT::kMaxContacts) {
    const bool is_cut = meeting.outcome == Outcome::kBudget;
    ++(is_contact ? report_.contacts_dropped
       : is_cut   ? report_.searches_cut
                  : report_.searches_invalid);
    return weld(a, b);
  }
  ++contacts_resolved_;
  return are_alone ? hit(a, b) : weld(a, b);
}

/// A body goes with others. @param mass  of all that go, kg; 0: they stand
/// @param sum_W  of their momenta. @param fall  of all of them
template <class SceneT>
void SmallWorld<SceneT>::take_in(std::size_t slot, Scalar mass, const Vec3<Scalar>& sum_W,
                                 [[maybe_unused]] const SmallFallSums& fall) {
  const bool goes = mass > Scalar(0);
  const Scalar share = goes ? 1 / (mass * inverse_mass_[slot]) : Scalar(0);
  for (int i = 0; i < 3; ++i) actors_.at(slot).body.momentum_W[i] = share * sum_W[i];  // Bound: 3
  if constexpr (SceneT::kGravity) {
    falls_.lag[slot] = fall.lag;
    falls_.loaded[slot] = fall.loaded;
  }
  if (!goes) inverse_mass_[slot] = 0;
}

/// The two, and who goes with one of them already, go on together, with their common velocity;
/// where one of them does not move, they stand (world.md, "Together").
template <class SceneT>
void SmallWorld<SceneT>::weld(std::size_t a, std::size_t b) {
  const auto both = static_cast<Slots>(group_[a] | group_[b]);
  const bool goes = inverse_mass_[a] > Scalar(0) && inverse_mass_[b] > Scalar(0);
  Scalar mass = 0;
  Vec3<Scalar> sum_W = Vec3<Scalar>::Zero();
  SmallFallSums fall;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!is_in(both, slot)) continue;
    mass += 1 / inverse_mass_[slot];
    for (int i = 0; i < 3; ++i) sum_W[i] += actors_.at(slot).body.momentum_W[i];  // Bound: 3
    if constexpr (SceneT::kGravity) {
      fall.lag += falls_.lag[slot] / inverse_mass_[slot];
      fall.loaded = fall.loaded || falls_.loaded[slot];
    }
  }
  if constexpr (SceneT::kGravity) fall.lag /= mass;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (!is_in(both, slot)) continue;
    take_in(slot, goes ? mass : Scalar(0), sum_W, fall);
    group_[slot] = both;
  }
  report_.time_held = max_of(report_.time_held, left_);
}

template <class SceneT>
void SmallWorld<SceneT>::hit(std::size_t a, std::size_t b) {
  const ActorType& A = actors_.at(a);
  const ActorType& B = actors_.at(b);
  Scalar restitution = 0;
  if constexpr (SceneT::kRestitution) {
    restitution = pair_restitution(A.restitution, B.restitution);
  }
  const Vec3<Scalar> normal_W = Kinematics::normal_BA(A, B);
  auto hit = strike(a, b, normal_W, restitution);
  if constexpr (SceneT::kGravity) {
    if (takes_load(a, b, normal_W)) {
      hit.impulse += strike(a, b, normal_W, Scalar(0)).impulse;
    }
  }
  if (hit.impulse > Scalar(0)) ++report_.collisions;
}

/// A blow, with the velocities of now: momenta are those of the step's end.
template <class SceneT>
StraightHit<typename SmallWorld<SceneT>::Scalar> SmallWorld<SceneT>::strike(
    std::size_t a, std::size_t b, const Vec3<Scalar>& normal_W, Scalar restitution) {
  StraightBody<Scalar>& A = actors_.at(a).body;
  StraightBody<Scalar>& B = actors_.at(b).body;
  if constexpr (SceneT::kGravity) {
    const auto fall_by = [this](std::size_t slot, Scalar time) {
      if (!falls(slot)) return;
      StraightBody<Scalar>& body = actors_.at(slot).body;
      body.momentum_W += (time / body.inverse_mass) * settings_.gravity_W;
    };
    fall_by(a, -left_);
    fall_by(b, -left_);
    const auto hit = straight_impulse(A, B, normal_W, restitution);
    fall_by(a, left_);
    fall_by(b, left_);
    return hit;
  } else {
    return straight_impulse(A, B, normal_W, restitution);
  }
}

/// As GeneralWorld: gravity would close the contact within the step.
template <class SceneT>
bool SmallWorld<SceneT>::takes_load(std::size_t a, std::size_t b, const Vec3<Scalar>& normal_W) {
  const bool falls_a = falls(a);
  if (falls_a == falls(b)) return false;
  const Vec3<Scalar> end_W = velocity_of(actors_.at(a).body) - velocity_of(actors_.at(b).body);
  if (!(normal_W.dot(end_W) < Scalar(0))) return false;
  falls_.loaded[falls_a ? a : b] = true;
  return true;
}

}  // namespace batuta::detail
