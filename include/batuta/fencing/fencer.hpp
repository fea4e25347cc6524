// SPDX-License-Identifier: MIT
#pragma once
// A fencer as data: what the stick means, weapon, grip and body. Frame F (skeleton.hpp). Two
// fencers come with the library; a new one is a new value of this struct.
//
// What the stick means (library_map(), for both fencers, seen by themselves; stick right = the
// fencer's own right, inside is the left of who holds the weapon in the right hand):
//   ( 0,  0)  guard
//   (-1,  0) quarte, (+1,  0) sixte, (-1, -1) septime, (+1, -1) octave: the parries, high inside,
//             high outside, low inside, low outside; on the way to the low ones the point drops
//             before the hand sweeps
//   ( 0, -1)  retreat: the arm drawn back, and the feet go back (DuelOptions::feet)
//   (-1, +1), (-0.5, +1), (+0.5, +1), (+1, +1)  lunges: high inside, low inside, low outside, high
//             outside; (0, +1) lies between the low ones
//   y = 0.5: the extensions, arm out and the point in its line: high inside -0.5 and beyond, low
//             inside -0.25, low outside 0.25, high outside 0.5 and beyond

#include "batuta/fencing/grip.hpp"
#include "batuta/fencing/map.hpp"
#include "batuta/fencing/skeleton.hpp"
#include "batuta/fencing/weapon.hpp"

namespace batuta::fencing {

/// A fencer as data.
template <class Scalar>
struct Fencer {
  FencerMap<Scalar> map;      ///< what the stick means; its keys are not in here
  WeaponBody<Scalar> weapon;  ///< what the hand holds: weapon_body() makes one of its parts
  GripSettings<Scalar> grip;  ///< how firmly it holds it
  FencerBuild<Scalar> build;  ///< the body that can be touched
};

/// A function that makes a fencer, such as first_fencer<float>.
template <class Scalar>
using FencerMaker = Fencer<Scalar> (*)();

/// The epee that both fencers of the library hold, by its parts: 0.77 kg.
template <class Scalar>
Weapon<Scalar> epee();

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
