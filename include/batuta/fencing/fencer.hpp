// SPDX-License-Identifier: MIT
#pragma once
// A fencer as data: what the stick means, weapon, grip and body. Frame F (skeleton.hpp). Two
// fencers come with the library; a new one is a new value of this struct.
//
// What the stick means (both fencers, seen by themselves; stick right = the fencer's own right):
//   ( 0,  0)  guard: the blades are engaged, a finger's breadth apart
//   ( 0, +1)  full lunge, straight; reaches the opponent's chest
//   (-1, +1), (+1, +1)  lunge into the left (high) and the right (low) line
//   (-1, -1 ... 0)  parry left: the hand goes to the left, the point stays in; beats the guard
//   (+1, -1 ... 0)  parry right: the same; the guard is not on that side
//   ( 0, -1)  back guard: out of the opponent's reach, blade high

#include "batuta/control/keyframes.hpp"
#include "batuta/fencing/grip.hpp"
#include "batuta/fencing/skeleton.hpp"
#include "batuta/fencing/weapon.hpp"

namespace batuta::fencing {

/// Hand poses of a fencer: three columns from left to right, three rows from the back to the front.
template <class Scalar>
using FencerGrid = KeyframeGrid<Scalar, 3, 3>;

/// A fencer as data.
template <class Scalar>
struct Fencer {
  typename FencerGrid<Scalar>::Keys
      keys_FH;                ///< hand poses; row by row from the back, left to right
  Weapon<Scalar> weapon;      ///< what the hand holds
  GripSettings<Scalar> grip;  ///< how firmly it holds it
  FencerBuild<Scalar> build;  ///< the body that can be touched
};

/// Of medium height.
template <class Scalar>
Fencer<Scalar> first_fencer();

/// Taller, with a longer reach.
template <class Scalar>
Fencer<Scalar> second_fencer();

/// One of the two fencers: of the left blade or of the right one.
enum class Side : std::uint8_t {
  kLeft,   ///< looks along +x of W
  kRight,  ///< looks along -x of W
};

/// The opponent's side.
constexpr Side other(Side side) {
  return side == Side::kLeft ? Side::kRight : Side::kLeft;
}
/// 0 or 1; as for other(), what is not kLeft counts as kRight.
constexpr std::size_t index_of(Side side) {
  return side == Side::kLeft ? 0 : 1;
}

/// Where the fencers stand. W: x along the piste from the left fencer to the right one, origin
/// midway on the floor, z up.
template <class Scalar>
struct Salle {
  /// Between the origins of the two F, m: guards do not reach the opponent, blades overlap, a full
  /// lunge hits.
  Scalar distance = Scalar(2.25);

  /// Where a fencer's frame F is in W: x towards the opponent.
  /// @param way  that his feet have gone forward, m
  Pose<Scalar> X_WF(Side side, Scalar way = Scalar(0)) const;
};

}  // namespace batuta::fencing
