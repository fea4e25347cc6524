// SPDX-License-Identifier: MIT
#pragma once
// A weapon as the sum of its parts. Frame H: the hand, origin in the middle of the grip, x along
// the blade to the tip.

#include <array>

#include "batuta/mechanics/body.hpp"

namespace batuta::fencing {

/// A part of a weapon, in the frame H of the hand.
template <class Scalar>
struct WeaponPart {
  Capsule<Scalar> capsule_H;  ///< a sphere of radius 0 is a point mass
  Scalar mass = 0;            ///< kg, > 0, evenly spread over the capsule
};

/// Blade, guard, grip, pommel, and the hand around the grip. Blade, guard and hand collide.
template <class Scalar>
struct Weapon {
  static constexpr int kParts = 4;  ///< blade, guard, grip, pommel
  std::array<WeaponPart<Scalar>, static_cast<std::size_t>(kParts)> parts;  ///< the blade first
  /// The hand as what strikes it finds it; what it weighs is the arm's.
  Capsule<Scalar> hand_H;
  Scalar restitution = 0;  ///< C of the blade, in [0, 1]
};

/// How a weapon resists being moved. B: its centre of mass and principal axes.
template <class Scalar>
struct WeaponMass {
  Scalar mass = 0;                              ///< kg
  Vec3<Scalar> moments = Vec3<Scalar>::Zero();  ///< principal moments of inertia, kg m^2
  Pose<Scalar> X_HB;                            ///< fixed
};

/// What the world needs of a weapon. No weapon has no mass: a duel refuses WeaponBody{}.
template <class Scalar>
struct WeaponBody : WeaponMass<Scalar> {
  Capsule<Scalar> blade_B;  ///< these three collide
  Capsule<Scalar> guard_B;  ///< the bell
  Capsule<Scalar> hand_B;   ///< that holds it
  Scalar restitution = 0;   ///< C of the blade, in [0, 1]
};

/// What a weapon of these parts is to the world.
/// @returns kOk | kInvalidArgument (a part's mass or shape, the hand's shape, or the restitution,
/// is out of range) Bound: kParts parts.
template <class Scalar>
Result<WeaponBody<Scalar>> weapon_body(const Weapon<Scalar>& weapon);

/// @returns kOk | kInvalidArgument: a mass or a moment that is not positive or has no inverse, a
/// frame that is none, a capsule that is none, or the restitution is out of range
template <class Scalar>
Status validate(const WeaponBody<Scalar>& weapon);

/// X_AC = X_AB X_BC, the quaternion renewed.
template <class Scalar>
Pose<Scalar> chained(const Pose<Scalar>& X_AB, const Pose<Scalar>& X_BC);

/// X_BA of X_AB.
template <class Scalar>
Pose<Scalar> inverse(const Pose<Scalar>& X_AB);

}  // namespace batuta::fencing
