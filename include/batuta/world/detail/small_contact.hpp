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
  bool is_loads = false;
  if constexpr (SceneT::kGravity) is_loads = !is_blow(a, b, normal_W);
  auto hit = strike(a, b, normal_W, is_loads ? Scalar(0) : restitution);
  if constexpr (SceneT::kGravity) {
    if (is_loads) {  // what two give each other that can both be moved stays theirs
      if (!(inverse_mass_[b] > Scalar(0))) note_support(a, hit.impulse * normal_W);
      if (!(inverse_mass_[a] > Scalar(0))) note_support(b, -hit.impulse * normal_W);
    }
    hit.impulse += take_load(a, b, normal_W);
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

/// As GeneralWorld: where gravity would close the contact within the step, what falls is carried.
/// @returns the impulse of that, N s, or 0
template <class SceneT>
typename SmallWorld<SceneT>::Scalar SmallWorld<SceneT>::take_load(std::size_t a, std::size_t b,
                                                                  const Vec3<Scalar>& normal_W) {
  const bool falls_a = falls(a);
  if (falls_a == falls(b)) return 0;
  StraightBody<Scalar>& A = actors_.at(a).body;
  StraightBody<Scalar>& B = actors_.at(b).body;
  const Scalar at_end = normal_W.dot(velocity_of(A) - velocity_of(B));
  if (!(at_end < Scalar(0))) return 0;
  const std::size_t slot = falls_a ? a : b;
  falls_.loaded[slot] = true;
  StraightBody<Scalar>& body = falls_a ? A : B;
  const Vec3<Scalar> towards_W = falls_a ? normal_W : Vec3<Scalar>(-normal_W);
  Vec3<Scalar> on_carried_W = (-at_end / body.inverse_mass) * towards_W;
  body.momentum_W += on_carried_W;
  give_way(slot, falls_a ? b : a, towards_W, -at_end, on_carried_W);
  note_support(slot, on_carried_W);
  return on_carried_W.dot(towards_W);
}

/// As GeneralWorld: whether a load goes on to somebody who is not given it.
template <class SceneT>
bool SmallWorld<SceneT>::is_lost_below(std::size_t carrier, const Vec3<Scalar>& load_W) const {
  if constexpr (SceneT::kMaxBodies <= 3) return false;  // three, and what is below them
  const Scalar share = along_support(load_W, falls_.support_W[carrier]);
  return share * length(falls_.reaction_W[carrier]) >
         kLoadRoundings * kRoundOff<Scalar> * length(load_W);
}

/// As GeneralWorld: who is carried himself gives way across his support, and the load is less.
template <class SceneT>
void SmallWorld<SceneT>::give_way(std::size_t carried, std::size_t carrier,
                                  const Vec3<Scalar>& towards_W, Scalar speed,
                                  Vec3<Scalar>& on_carried_W) {
  if (!falls_.loaded[carrier] || !(inverse_mass_[carrier] > Scalar(0))) return;
  if (is_lost_below(carrier, on_carried_W)) ++report_.resolutions_invalid;
  const Vec3<Scalar> across_W = across_support(on_carried_W, falls_.support_W[carrier]);
  const Scalar gives = inverse_mass_[carrier] * across_W.dot(towards_W);
  if (!(gives > Scalar(0))) return;
  const Scalar kept = speed / (speed + gives);
  actors_.at(carried).body.momentum_W += (kept - 1) * on_carried_W;
  on_carried_W *= kept;
  actors_.at(carrier).body.momentum_W -= kept * across_W;
  if (!(left_ > Scalar(0))) return;
  if (falls_.carrier[carried] != carrier) falls_.reaction_W[carried].setZero();
  falls_.carrier[carried] = static_cast<std::uint8_t>(carrier);
  falls_.reaction_W[carried] -= (kept / left_) * across_W;
}

/// As GeneralWorld. @param times  s: < 0: what the rest of the step would have taken comes back
template <class SceneT>
void SmallWorld<SceneT>::give_reaction(std::size_t slot, Scalar times) {
  const std::size_t carrier = falls_.carrier[slot];
  if (is_zero(falls_.reaction_W[slot]) || !(inverse_mass_[carrier] > Scalar(0))) return;
  actors_.at(carrier).body.momentum_W += times * falls_.reaction_W[slot];
}

/// As GeneralWorld.
template <class SceneT>
void SmallWorld<SceneT>::note_support(std::size_t slot, const Vec3<Scalar>& impulse_W) {
  if (!falls_.loaded[slot] || !(left_ > Scalar(0))) return;
  falls_.support_W[slot] += impulse_W / left_;
}

template <class SceneT>
Vec3<typename SmallWorld<SceneT>::Scalar> SmallWorld<SceneT>::velocity_now(std::size_t slot) const {
  const Vec3<Scalar> v_W = velocity_of(actors_.at(slot).body);
  return falls(slot) ? Vec3<Scalar>(v_W - left_ * settings_.gravity_W) : v_W;
}

/// As GeneralWorld: what is carried falls, and its support gives no more. @returns what that gave
template <class SceneT>
Vec3<typename SmallWorld<SceneT>::Scalar> SmallWorld<SceneT>::release(std::size_t slot) {
  const Vec3<Scalar> support_W = falls_.support_W[slot];
  if (is_zero(support_W)) return support_W;
  actors_.at(slot).body.momentum_W -= left_ * support_W;
  give_reaction(slot, -left_);
  falls_.loaded[slot] = false;
  falls_.support_W[slot].setZero();
  return support_W;
}

/// As GeneralWorld: whether a contact is a blow, before which who is carried falls.
template <class SceneT>
bool SmallWorld<SceneT>::is_blow(std::size_t a, std::size_t b, const Vec3<Scalar>& normal_W) {
  if (is_zero(falls_.support_W[a]) && is_zero(falls_.support_W[b])) return true;
  const Vec3<Scalar> momentum_A_W = actors_.at(a).body.momentum_W;
  const Vec3<Scalar> momentum_B_W = actors_.at(b).body.momentum_W;
  const Vec3<Scalar> of_A_W = release(a);
  const Vec3<Scalar> of_B_W = release(b);
  const Vec3<Scalar> v_A_W = velocity_now(a);
  const Vec3<Scalar> v_B_W = velocity_now(b);
  const Scalar scale = length(v_A_W) + length(v_B_W) + left_ * length(settings_.gravity_W);
  const Scalar rounding = kLoadRoundings * kRoundOff<Scalar> * scale;
  if (normal_W.dot(v_A_W - v_B_W) < -rounding) {
    falls_.reaction_W[a].setZero();
    falls_.reaction_W[b].setZero();
    return true;
  }
  // First what each gave the other: each is then put back as it was.
  if (!is_zero(of_A_W)) give_reaction(a, left_);
  if (!is_zero(of_B_W)) give_reaction(b, left_);
  restore(a, momentum_A_W, of_A_W);
  restore(b, momentum_B_W, of_B_W);
  return false;
}

template <class SceneT>
void SmallWorld<SceneT>::restore(std::size_t slot, const Vec3<Scalar>& momentum_W,
                                 const Vec3<Scalar>& support_W) {
  if (is_zero(support_W)) return;
  actors_.at(slot).body.momentum_W = momentum_W;
  falls_.support_W[slot] = support_W;
  falls_.loaded[slot] = true;
}

}  // namespace batuta::detail
