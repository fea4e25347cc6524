// SPDX-License-Identifier: MIT
#pragma once
// A body from its shape: a solid capsule of uniform density, wherever it lies in the frame G in
// which the caller thinks of it. Frames: W world; B body: origin in the capsule's middle, axes the
// principal axes of inertia. SI units.

#include "batuta/mechanics/body.hpp"

namespace batuta {

/// A body, and its shape as it sees it.
template <class Scalar>
struct SolidBody {
  Body<Scalar> body;          ///< its origin is the middle of the capsule
  Capsule<Scalar> capsule_B;  ///< about the origin of B
};

/// Where the capsule lies along an axis of G, or is a ball, B has the axes of G; else z of B lies
/// along the capsule, on the shortest way from z of G. Where it lies about the origin of G as well,
/// B is G, to the rounding of its orientation.
/// @param density  kg/m^3; infinity: the body is fixed
/// @param X_WG  where G is in W
/// @param twist  of the body: velocity of the capsule's middle, and angular velocity; of a ball and
///   of a rod all components count
/// @returns kOk | kInvalidArgument: a number that is not finite (but the density); an orientation
///   of length 0; a negative radius; a coordinate beyond kLargestCoordinate; a density that is
///   zero, negative or NaN; mass or moments that vanish or overflow, or their inverses (radius 0
///   has no volume, and is fixed or refused); momenta that overflow; a fixed body that is to move
/// Bound: no loop.
template <class Scalar>
Result<SolidBody<Scalar>> solid_body(const Capsule<Scalar>& capsule_G, Scalar density,
                                     const Pose<Scalar>& X_WG, const Twist<Scalar>& twist);

}  // namespace batuta
