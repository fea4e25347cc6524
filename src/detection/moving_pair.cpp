// SPDX-License-Identifier: MIT
#include "batuta/detection/moving_pair.hpp"

#include "round_up.hpp"

namespace batuta {

namespace {

template <class Scalar>
EndPath<Scalar> end_path(const Vec3<Scalar>& center, const Vec3<Scalar>& lever,
                         const Vec3<Scalar>& axis) {
  const Vec3<Scalar> arm = lever - axis * axis.dot(lever);
  return {center + lever, arm, axis.cross(arm)};
}

template <class Scalar>
Vec3<Scalar> end_at(const EndPath<Scalar>& end, const SinCos<Scalar>& turn,
                    const Vec3<Scalar>& travel) {
  return end.start + (travel + (turn.sin * end.side - (Scalar(1) - turn.cos) * end.arm));
}

template <class Scalar>
SinCos<Scalar> turn_at(const CapsulePath<Scalar>& path, Scalar t) {
  return path.turn_rate == Scalar(0) ? SinCos<Scalar>{} : sin_cos(path.turn_rate * t);
}

/// Velocity of the axis point with parameter s at time t.
template <class Scalar>
Vec3<Scalar> axis_velocity(const CapsulePath<Scalar>& path, Scalar s, Scalar t) {
  const SinCos<Scalar> turn = turn_at(path, t);
  const Vec3<Scalar> arm = path.ends[0].arm + s * (path.ends[1].arm - path.ends[0].arm);
  const Vec3<Scalar> side = path.ends[0].side + s * (path.ends[1].side - path.ends[0].side);
  return path.v + path.turn_rate * (turn.cos * side - turn.sin * arm);
}

/// No point of the axis is further from the centre of mass, but for rounding.
template <class Scalar>
Scalar reach(const Capsule<Scalar>& capsule_B) {
  return max_of(length(capsule_B.axis.a), length(capsule_B.axis.b));
}

template <class Scalar>
bool is_valid(const MovingCapsule<Scalar>& moving) {
  return is_valid(moving.capsule_B) && is_valid(moving.motion);
}

}  // namespace

template <class Scalar>
CapsulePath<Scalar> capsule_path(const MovingCapsule<Scalar>& moving, const Vec3<Scalar>& origin_W,
                                 const Vec3<Scalar>& origin_v_W) {
  const Pose<Scalar>& X_WB = moving.motion.X_WB;
  const Twist<Scalar>& twist = moving.motion.twist;
  CapsulePath<Scalar> path;
  path.v = twist.v_W - origin_v_W;
  path.turn_rate = length(twist.w_W);
  path.radius = moving.capsule_B.radius;
  path.reach = reach(moving.capsule_B);
  const bool turns = path.turn_rate > Scalar(0);
  const Vec3<Scalar> axis = turns ? Vec3<Scalar>(twist.w_W / path.turn_rate) : Vec3<Scalar>::Zero();
  const Vec3<Scalar> center = X_WB.p_W - origin_W;
  const Capsule<Scalar> turned =
      to_world(Pose<Scalar>{Vec3<Scalar>::Zero(), X_WB.q_WB}, moving.capsule_B);
  if (turns) {
    path.ends = {end_path(center, turned.axis.a, axis), end_path(center, turned.axis.b, axis)};
    path.longest_arm = max_of(length(path.ends[0].arm), length(path.ends[1].arm));
  } else {
    path.ends[0].start = center + turned.axis.a;
    path.ends[1].start = center + turned.axis.b;
  }
  return path;
}

template <class Scalar>
Capsule<Scalar> capsule_at(const CapsulePath<Scalar>& path, Scalar t) {
  const SinCos<Scalar> turn = turn_at(path, t);
  const Vec3<Scalar> travel = path.v * t;
  return {{end_at(path.ends[0], turn, travel), end_at(path.ends[1], turn, travel)}, path.radius};
}

template <class Scalar>
Result<MovingPair<Scalar>> make_moving_pair(const MovingCapsule<Scalar>& A,
                                            const MovingCapsule<Scalar>& B) {
  using Answer = MovingPair<Scalar>;
  if (!is_valid(A) || !is_valid(B)) return failure<Answer>(Status::kInvalidArgument);
  if (A.motion.duration != B.motion.duration) return failure<Answer>(Status::kInvalidArgument);
  Answer pair;
  pair.origin_W = A.motion.X_WB.p_W;
  pair.origin_v_W = A.motion.twist.v_W;
  pair.duration = A.motion.duration;
  pair.A = capsule_path(A, pair.origin_W, pair.origin_v_W);
  pair.B = capsule_path(B, pair.origin_W, pair.origin_v_W);
  const Scalar apart = length<Scalar>(B.motion.X_WB.p_W - pair.origin_W);
  const Scalar travel = length(pair.B.v) * pair.duration;
  const Scalar sizes = (pair.A.reach + pair.B.reach) + (pair.A.radius + pair.B.radius);
  pair.scale = kRoundUp<Scalar> * (apart + travel + sizes);
  if (!(pair.scale <= kLargestCoordinate<Scalar>)) return failure<Answer>(Status::kInvalidArgument);
  return success(pair);
}

template <class Scalar>
CapsulesAt<Scalar> capsules_at(const MovingPair<Scalar>& pair, Scalar t) {
  return {capsule_at(pair.A, t), capsule_at(pair.B, t)};
}

template <class Scalar>
CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>& pair, Scalar t) {
  const CapsulesAt<Scalar> capsules = capsules_at(pair, t);
  if (!is_valid(capsules.A) || !is_valid(capsules.B)) return {};
  return gap_at(pair, closest_points(capsules.A.axis, capsules.B.axis), t);
}

template <class Scalar>
CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>& pair, const ClosestPoints<Scalar>& axes,
                          Scalar t) {
  CapsuleGap<Scalar> gap = capsule_gap(axes, pair.A.radius, pair.B.radius);
  const Vec3<Scalar> travelled = pair.origin_v_W * t;
  gap.axes.p_A += travelled;
  gap.axes.p_B += travelled;
  gap.surface_A += travelled;
  gap.surface_B += travelled;
  return gap;
}

template <class Scalar>
Scalar gap_rate_at(const MovingPair<Scalar>& pair, const CapsuleGap<Scalar>& witness, Scalar t) {
  const Vec3<Scalar> v_A = axis_velocity(pair.A, witness.axes.s, t);
  const Vec3<Scalar> v_B = axis_velocity(pair.B, witness.axes.u, t);
  return witness.axes.normal_AB.dot(v_B - v_A);
}

#define BATUTA_INSTANTIATE(Scalar)                                                             \
  template CapsulePath<Scalar> capsule_path(const MovingCapsule<Scalar>&, const Vec3<Scalar>&, \
                                            const Vec3<Scalar>&);                              \
  template Capsule<Scalar> capsule_at(const CapsulePath<Scalar>&, Scalar);                     \
  template Result<MovingPair<Scalar>> make_moving_pair(const MovingCapsule<Scalar>&,           \
                                                       const MovingCapsule<Scalar>&);          \
  template CapsulesAt<Scalar> capsules_at(const MovingPair<Scalar>&, Scalar);                  \
  template CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>&, Scalar);                       \
  template CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>&, const ClosestPoints<Scalar>&,  \
                                     Scalar);                                                  \
  template Scalar gap_rate_at(const MovingPair<Scalar>&, const CapsuleGap<Scalar>&, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
