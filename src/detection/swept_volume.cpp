// SPDX-License-Identifier: MIT
#include "batuta/detection/swept_volume.hpp"

#include "round_up.hpp"

namespace batuta {

namespace {

/// Everything is rounded outward by this times u times the sum of the lengths involved
/// (swept_volume.md).
template <class Scalar>
inline constexpr Scalar kOutward = 64 * kRoundOff<Scalar>;

/// From this turn on, rad, the box of the whole circle is never larger than chord and sagitta
/// (swept_volume.md), and the end pose need not be known.
template <class Scalar>
inline constexpr Scalar kLongTurn = Scalar(4);

/// The ends of one path at both ends of the motion, relative to its centre of mass at the start.
template <class Scalar>
struct SweptEnd {
  EndPath<Scalar> path;
  Vec3<Scalar> travel;  ///< v T
  Vec3<Scalar> last;    ///< at the end of the motion; not used for a long turn
  Scalar turn = 0;      ///< |w| T, rad
};

/// Upper end of direction . x over the path: chord + sagitta, or the whole circle carried along,
/// whichever is less.
template <class Scalar>
Scalar highest(const SweptEnd<Scalar>& end, const Vec3<Scalar>& direction) {
  const Scalar along_arm = direction.dot(end.path.arm);
  const Scalar along_side = direction.dot(end.path.side);
  const Scalar amplitude = length(Vec3<Scalar>(along_arm, along_side, Scalar(0)));
  const Scalar first = direction.dot(end.path.start);
  const Scalar travel = direction.dot(end.travel);
  const Scalar circle = first - along_arm + max_of(Scalar(0), travel) + amplitude;
  if (end.turn >= kLongTurn<Scalar>) return circle;
  const Scalar sagitta = end.turn * end.turn * amplitude / 8;
  return min_of(circle, max_of(first, direction.dot(end.last)) + sagitta);
}

/// Sum of all lengths that enter a face of the volume, m.
template <class Scalar>
Scalar size_of(const MovingCapsule<Scalar>& moving) {
  const Segment<Scalar>& axis_B = moving.capsule_B.axis;
  const Scalar travel = length(moving.motion.twist.v_W) * moving.motion.duration;
  const Scalar reach = max_of(length(axis_B.a), length(axis_B.b));
  return length(moving.motion.X_WB.p_W) + travel + reach + moving.capsule_B.radius;
}

/// The whole space.
template <class Scalar, int K>
Kdop<Scalar, K> unbounded() {
  Kdop<Scalar, K> all;
  all.low.fill(std::numeric_limits<Scalar>::lowest());
  all.high.fill(std::numeric_limits<Scalar>::max());
  return all;
}

}  // namespace

template <class Scalar>
SweptSphere<Scalar> swept_sphere(const MovingCapsule<Scalar>& moving) {
  const Segment<Scalar>& axis_B = moving.capsule_B.axis;
  const Vec3<Scalar>& start_W = moving.motion.X_WB.p_W;
  const Vec3<Scalar> travel = moving.motion.twist.v_W * moving.motion.duration;
  const Scalar reach = max_of(length(axis_B.a), length(axis_B.b));
  const Scalar outward = kOutward<Scalar> * size_of(moving);
  return {start_W, start_W + travel, reach + moving.capsule_B.radius + outward};
}

template <class Scalar, int K>
Kdop<Scalar, K> swept_kdop(const MovingCapsule<Scalar>& moving) {
  const Vec3<Scalar>& start_W = moving.motion.X_WB.p_W;
  const Scalar duration = moving.motion.duration;
  const CapsulePath<Scalar> path = capsule_path(moving, start_W, Vec3<Scalar>::Zero().eval());
  const Scalar turn = path.turn_rate * duration;
  const Scalar size = size_of(moving);
  // Where a sum of lengths may overflow, 0 * infinity could make a face vanish.
  if (!(size <= kLargestCoordinate<Scalar> && turn >= Scalar(0))) return unbounded<Scalar, K>();
  const bool is_long = turn >= kLongTurn<Scalar>;
  const Segment<Scalar> last = capsule_at(path, is_long ? Scalar(0) : duration).axis;
  const Vec3<Scalar> travel = path.v * duration;
  const SweptEnd<Scalar> end_a{path.ends[0], travel, last.a, turn};
  const SweptEnd<Scalar> end_b{path.ends[1], travel, last.b, turn};
  Kdop<Scalar, K> swept;
  for (int i = 0; i < Kdop<Scalar, K>::kDirections; ++i) {  // Bound: K / 2
    const Vec3<Scalar> up = kdop_direction<Scalar, K>(i);
    const Vec3<Scalar> down = -up;
    const Scalar origin = up.dot(start_W);
    const auto k = static_cast<std::size_t>(i);
    swept.high[k] = origin + max_of(highest(end_a, up), highest(end_b, up));
    swept.low[k] = origin - max_of(highest(end_a, down), highest(end_b, down));
  }
  return inflated(swept, path.radius + kOutward<Scalar> * size);
}

template <class Scalar>
Aabb<Scalar> swept_aabb(const MovingCapsule<Scalar>& moving) {
  return swept_kdop<Scalar, 6>(moving);
}

template <class Scalar>
bool overlaps(const SweptSphere<Scalar>& P, const SweptSphere<Scalar>& Q) {
  const Vec3<Scalar> travel_P = P.end_W - P.start_W;
  const Vec3<Scalar> travel_Q = Q.end_W - Q.start_W;
  const Vec3<Scalar> between = Q.start_W - P.start_W;
  const Scalar size = length(travel_P) + length(travel_Q) + length(between);
  // Seen from P's start, so that the distance from the world's origin costs nothing.
  const Segment<Scalar> axis_P{Vec3<Scalar>::Zero(), travel_P};
  const Segment<Scalar> axis_Q{between, between + travel_Q};
  const Scalar apart = closest_points(axis_P, axis_Q).distance - kOutward<Scalar> * size;
  return !(apart > kRoundUp<Scalar> * (P.radius + Q.radius));
}

#define BATUTA_INSTANTIATE(Scalar)                                         \
  template SweptSphere<Scalar> swept_sphere(const MovingCapsule<Scalar>&); \
  template Aabb<Scalar> swept_aabb(const MovingCapsule<Scalar>&);          \
  template Kdop<Scalar, 6> swept_kdop(const MovingCapsule<Scalar>&);       \
  template Kdop<Scalar, 14> swept_kdop(const MovingCapsule<Scalar>&);      \
  template Kdop<Scalar, 18> swept_kdop(const MovingCapsule<Scalar>&);      \
  template Kdop<Scalar, 26> swept_kdop(const MovingCapsule<Scalar>&);      \
  template bool overlaps(const SweptSphere<Scalar>&, const SweptSphere<Scalar>&);
BATUTA_INSTANTIATE(float)
BATUTA_INSTANTIATE(double)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
