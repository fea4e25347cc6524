// SPDX-License-Identifier: MIT
#include "batuta/detection/speed_bound.hpp"

#include "round_up.hpp"

namespace batuta {

namespace {

/// Largest speed that turning gives an end of the axis, and so any of its points, to within
/// kRoundUp.
template <class Scalar>
Scalar turning_speed(const detail::CapsulePath<Scalar>& path) {
  return path.turn_rate * path.longest_arm;
}

template <class Scalar>
bool moves(const detail::CapsulePath<Scalar>& path) {
  return path.turn_rate > Scalar(0) || path.v != Vec3<Scalar>::Zero();
}

/// Upper bound of a sum of speeds; above zero for whatever moves, even where the products
/// underflowed.
template <class Scalar>
Scalar rounded_up(Scalar speed) {
  return kRoundUp<Scalar> * speed + std::numeric_limits<Scalar>::min();
}

}  // namespace

template <class Scalar>
Scalar speed_bound(const MovingCapsule<Scalar>& moving) {
  const Vec3<Scalar> at_rest = Vec3<Scalar>::Zero();
  const detail::CapsulePath<Scalar> path =
      detail::capsule_path(moving, moving.motion.X_WB.p_W, at_rest);
  if (!moves(path)) return Scalar(0);
  return rounded_up(length(path.v) + turning_speed(path) + path.turn_rate * path.radius);
}

template <class Scalar>
Scalar closing_speed_bound(const MovingPair<Scalar>& pair) {
  if (!moves(pair.A) && !moves(pair.B)) return Scalar(0);
  return rounded_up(length(pair.B.v) + turning_speed(pair.A) + turning_speed(pair.B));
}

#define BATUTA_INSTANTIATE(Scalar)                           \
  template Scalar speed_bound(const MovingCapsule<Scalar>&); \
  template Scalar closing_speed_bound(const MovingPair<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
