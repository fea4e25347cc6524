// SPDX-License-Identifier: MIT
#pragma once
// A bound for fast spin: along a fixed direction an end swings no further than its amplitude,
// however often it turns. Derivation: advancement.md, "Fast spin".

#include "expansion.hpp"

namespace batuta {

/// Range of direction . x of an axis, without its steady motion.
template <class Scalar>
struct SwingRange {
  Scalar low = 0;
  Scalar high = 0;
};

template <class Scalar>
SwingRange<Scalar> swing_range(const CapsulePath<Scalar>& path, const Vec3<Scalar>& direction) {
  SwingRange<Scalar> range{std::numeric_limits<Scalar>::max(),
                           std::numeric_limits<Scalar>::lowest()};
  for (const EndPath<Scalar>& end : path.ends) {  // Bound: two ends
    const Scalar along_arm = direction.dot(end.arm);
    const Scalar along_side = direction.dot(end.side);
    const Scalar amplitude = std::sqrt(along_arm * along_arm + along_side * along_side);
    const Scalar middle = direction.dot(end.start) - along_arm;
    range.low = min_of(range.low, middle - amplitude);
    range.high = max_of(range.high, middle + amplitude);
  }
  return range;
}

/// The time up to which n separates the pair whatever the turn; at least theta.
/// @param pair   in units of its duration
/// @param least  what the distance of the axes has to exceed, rounding included, m
template <class Scalar>
Scalar free_until_by_spin(const MovingPair<Scalar>& pair, const Vec3<Scalar>& n, Scalar least,
                          Scalar theta) {
  const Scalar parting = n.dot(pair.B.v);
  const Scalar apart =
      (swing_range(pair.B, n).low - swing_range(pair.A, n).high) - least + parting * theta;
  if (!(apart > Scalar(0))) return theta;
  if (apart + parting * (1 - theta) > Scalar(0)) return Scalar(1);
  return theta - kRoundDown<Scalar> * (apart / parting);
}

}  // namespace batuta
