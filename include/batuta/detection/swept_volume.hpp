// SPDX-License-Identifier: MIT
#pragma once
// Volumes that hold a moving capsule during a whole step [Kavan §3.2, eq. 19]: if two do not meet,
// neither do the capsules.

#include "batuta/detection/moving_pair.hpp"
#include "batuta/geometry/kdop.hpp"

namespace batuta {

/// The ball about the centre of mass that holds the capsule however it turns, swept along the
/// motion: its centres run from start_W to end_W.
template <class Scalar>
struct SweptSphere {
  Vec3<Scalar> start_W = Vec3<Scalar>::Zero();
  Vec3<Scalar> end_W = Vec3<Scalar>::Zero();
  Scalar radius = 0;
};
template <class Scalar>
SweptSphere<Scalar> swept_sphere(const MovingCapsule<Scalar>& moving);

/// A box in W that holds the capsule at every time of its motion: union of the boxes at both ends
/// of the step, grown by how far an arc can leave its chord, and never larger than that of the
/// swept sphere (src/detection/swept_volume.md). Without bounds (lowest() ... max()) where the
/// lengths sum up to more than kLargestCoordinate.
template <class Scalar>
Aabb<Scalar> swept_aabb(const MovingCapsule<Scalar>& moving);

/// The same in k directions.
template <class Scalar, int K>
Kdop<Scalar, K> swept_kdop(const MovingCapsule<Scalar>& moving);

/// Whether two swept spheres meet, rounded towards yes.
template <class Scalar>
bool overlaps(const SweptSphere<Scalar>& P, const SweptSphere<Scalar>& Q);

}  // namespace batuta
