// SPDX-License-Identifier: MIT
#pragma once
// A bound for fast spin: along a fixed direction an end swings no further than
// its amplitude, however often it turns. Derivation: advancement.md, "Fast
// spin".

#include "expansion.hpp"

namespace batuta {

/// The furthest that an axis reaches along a direction, without its steady
/// motion.
template <class Scalar>
Scalar swing_support(const detail::CapsulePath<Scalar>& path, const Vec3<Scalar>& direction) {
  Scalar furthest = std::numeric_limits<Scalar>::lowest();
  for (const detail::EndPath<Scalar>& end : path.ends) {  // Bound: two ends
    const Scalar along_arm = direction.dot(end.arm);
    const Scalar along_side = direction.dot(end.side);
    const Scalar amplitude = std::sqrt(along_arm * along_arm + along_side * along_side);
    furthest = max_of(furthest, (direction.dot(end.start) - along_arm) + amplitude);
  }
  return furthest;
}

/// The time up to which n separates the pair whatever the turn; at least theta.
/// @param travel  of B in the unit of time
/// @param least   what the distance of the axes has to exceed, rounding
/// included
template <class Scalar>
Scalar free_until_by_spin(const MovingPair<Scalar>& pair, const Vec3<Scalar>& travel,
                          const Vec3<Scalar>& n, Scalar least, Scalar theta) {
  const Scalar parting = n.dot(travel);
  const Scalar apart =
      -(swing_support<Scalar>(pair.B, -n) + swing_support(pair.A, n)) - least + parting * theta;
  if (!(apart > Scalar(0))) return theta;
  if (apart + parting * (1 - theta) > Scalar(0)) return Scalar(1);
  return theta - kRoundDown<Scalar> * (apart / parting);
}

}  // namespace batuta
