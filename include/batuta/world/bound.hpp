// SPDX-License-Identifier: MIT
#pragma once
// Which volume holds a capsule over a step, for the Bound of a Scene. What a scene does not name is
// not linked.

#include "batuta/detection/swept_volume.hpp"

namespace batuta {

/// The smallest box, in closed form. The default: fewest pairs.
struct SweptBox {
  /// swept_aabb().
  template <class Scalar>
  static Aabb<Scalar> of(const MovingCapsule<Scalar>& moving) {
    return swept_aabb(moving);
  }
};

/// A larger box without an arc tangent: for bodies that turn by less than 1/16 rad a step, where it
/// is larger by a 256th of the lever at most and takes a quarter of the time, or by more than about
/// half a radian.
struct CoarseBox {
  /// coarse_swept_aabb().
  template <class Scalar>
  static Aabb<Scalar> of(const MovingCapsule<Scalar>& moving) {
    return detail::coarse_swept_aabb(moving);
  }
};

}  // namespace batuta
