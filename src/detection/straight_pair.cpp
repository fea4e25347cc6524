// SPDX-License-Identifier: MIT
#include "batuta/detection/straight_pair.hpp"

#include "round_up.hpp"
#include "straight_extent.hpp"

namespace batuta {

namespace {

template <class Scalar>
Scalar bounding_radius_of(const Capsule<Scalar>& capsule_B) {
  return max_of(length(capsule_B.axis.a), length(capsule_B.axis.b));
}

/// @pre `path` is as it was made
template <class Scalar>
void set_straight_path(detail::CapsulePath<Scalar>& path, const Capsule<Scalar>& capsule_B,
                       const Vec3<Scalar>& start, Scalar bounding_radius) {
  path.ends[0].start = start + capsule_B.axis.a;
  path.ends[1].start = start + capsule_B.axis.b;
  path.bounding_radius = bounding_radius;
  path.radius = capsule_B.radius;
}

}  // namespace

template <class Scalar>
Result<MovingPair<Scalar>> detail::make_straight_pair(const Capsule<Scalar>& A_B,
                                                      const detail::StraightMotion<Scalar>& A,
                                                      const Capsule<Scalar>& B_B,
                                                      const detail::StraightMotion<Scalar>& B) {
  Result<MovingPair<Scalar>> made;
  const bool is_usable = is_valid(A_B) && is_valid(B_B) && A.duration >= Scalar(0);
  if (!is_usable || A.duration != B.duration) return made;
  const Vec3<Scalar> between = B.p_W - A.p_W;
  const Vec3<Scalar> v = B.v_W - A.v_W;
  const Scalar bounding_radius_A = bounding_radius_of(A_B);
  const Scalar bounding_radius_B = bounding_radius_of(B_B);
  const Scalar sizes = (bounding_radius_A + bounding_radius_B) + (A_B.radius + B_B.radius);
  const Scalar scale = kRoundUp<Scalar> * (length(between) + length(v) * A.duration + sizes);
  // What is not finite in a motion is not finite in what it differs from another by.
  const bool is_finite_motion = is_finite(between) && is_finite(v);
  if (!is_finite_motion || !(scale <= kLargestCoordinate<Scalar>)) return made;
  made.status = Status::kOk;
  MovingPair<Scalar>& pair = made.value;
  set_straight_path<Scalar>(pair.A, A_B, Vec3<Scalar>::Zero(), bounding_radius_A);
  set_straight_path(pair.B, B_B, between, bounding_radius_B);
  pair.B.v = v;
  pair.origin_W = A.p_W;
  pair.origin_v_W = A.v_W;
  pair.duration = A.duration;
  pair.scale = scale;
  return made;
}

template <class Scalar>
Aabb<Scalar> detail::straight_aabb(const Capsule<Scalar>& capsule_B,
                                   const detail::StraightMotion<Scalar>& motion) {
  Aabb<Scalar> box;
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    const Scalar a = capsule_B.axis.a[i];
    const Scalar b = capsule_B.axis.b[i];
    const SweptExtent<Scalar> extent =
        swept_extent<Scalar>(motion.p_W[i], motion.v_W[i] * motion.duration,
                             {min_of(a, b) - capsule_B.radius, max_of(a, b) + capsule_B.radius});
    box.low[static_cast<std::size_t>(i)] = extent.low;
    box.high[static_cast<std::size_t>(i)] = extent.high;
  }
  return box;
}

#define BATUTA_INSTANTIATE(S)                                                 \
  template Result<MovingPair<S>> detail::make_straight_pair(                  \
      const Capsule<S>&, const detail::StraightMotion<S>&, const Capsule<S>&, \
      const detail::StraightMotion<S>&);                                      \
  template Aabb<S> detail::straight_aabb(const Capsule<S>&, const detail::StraightMotion<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
