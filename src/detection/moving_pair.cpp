// SPDX-License-Identifier: MIT
#include "batuta/detection/moving_pair.hpp"

#include "round_up.hpp"

namespace batuta {

namespace {

template <class Scalar>
Vec3<Scalar> end_at(const detail::EndPath<Scalar>& end, const detail::SinCos<Scalar>& turn,
                    const Vec3<Scalar>& travel) {
  return end.start + (travel + (turn.sin * end.side - (Scalar(1) - turn.cos) * end.arm));
}

template <class Scalar>
detail::SinCos<Scalar> turn_at(const detail::CapsulePath<Scalar>& path, Scalar t) {
  return path.turn_rate == Scalar(0) ? detail::SinCos<Scalar>{}
                                     : detail::sin_cos(path.turn_rate * t);
}

/// Velocity of the axis point with parameter s at time t.
template <class Scalar>
Vec3<Scalar> axis_velocity(const detail::CapsulePath<Scalar>& path, Scalar s, Scalar t) {
  const detail::SinCos<Scalar> turn = turn_at(path, t);
  const Vec3<Scalar> arm = path.ends[0].arm + s * (path.ends[1].arm - path.ends[0].arm);
  const Vec3<Scalar> side = path.ends[0].side + s * (path.ends[1].side - path.ends[0].side);
  return path.v + path.turn_rate * (turn.cos * side - turn.sin * arm);
}

/// All that the size of the pair does not tell (make_moving_pair): an orientation is no part of it,
/// and of two ends of an axis it may leave out one.
template <class Scalar>
bool is_usable(const MovingCapsule<Scalar>& moving) {
  using detail::nan_unless_finite;
  const Capsule<Scalar>& capsule = moving.capsule_B;
  const Motion<Scalar>& motion = moving.motion;
  const Vec3<Scalar> end_W = motion.X_WB.p_W + motion.duration * motion.twist.v_W;
  const Scalar lost = nan_unless_finite(capsule.axis.a) + nan_unless_finite(capsule.axis.b) +
                      nan_unless_finite(motion.X_WB.q_WB) + nan_unless_finite(end_W);
  const Vec3<Scalar> turn = motion.duration * motion.twist.w_W;
  return lost == Scalar(0) && capsule.radius >= Scalar(0) && motion.duration >= Scalar(0) &&
         turn.squaredNorm() <= detail::kMaxAngle<Scalar> * detail::kMaxAngle<Scalar>;
}

/// @param axis  of rotation; @returns the length of the arm
template <class Scalar>
Scalar set_arm(detail::EndPath<Scalar>& end, const Vec3<Scalar>& lever, const Vec3<Scalar>& axis) {
  const Vec3<Scalar> arm = lever - axis * axis.dot(lever);
  end.arm = arm;
  end.side = axis.cross(arm);
  return length(arm);
}

/// How far the ends of an axis are from the body's centre of mass.
template <class Scalar>
Scalar reach_of(const MovingCapsule<Scalar>& moving) {
  const Segment<Scalar>& axis_B = moving.capsule_B.axis;
  return max_of(length(axis_B.a), length(axis_B.b));
}

/// capsule_path() in place. @pre `path` is as it was made, but for its bounding radius
template <class Scalar>
void set_path(detail::CapsulePath<Scalar>& path, const MovingCapsule<Scalar>& moving,
              const Vec3<Scalar>& origin_W, const Vec3<Scalar>& origin_v_W) {
  const Pose<Scalar>& X_WB = moving.motion.X_WB;
  const Segment<Scalar>& axis_B = moving.capsule_B.axis;
  const Vec3<Scalar> center = X_WB.p_W - origin_W;
  const Scalar turn_rate = length(moving.motion.twist.w_W);
  path.v = moving.motion.twist.v_W - origin_v_W;
  path.turn_rate = turn_rate;
  path.radius = moving.capsule_B.radius;
  const Vec3<Scalar> lever_a = X_WB.q_WB * axis_B.a;
  const Vec3<Scalar> lever_b = X_WB.q_WB * axis_B.b;
  path.ends[0].start = center + lever_a;
  path.ends[1].start = center + lever_b;
  if (!(turn_rate > Scalar(0))) return;
  const Vec3<Scalar> axis = moving.motion.twist.w_W / turn_rate;
  path.longest_arm =
      max_of(set_arm(path.ends[0], lever_a, axis), set_arm(path.ends[1], lever_b, axis));
}

}  // namespace

template <class Scalar>
detail::CapsulePath<Scalar> detail::capsule_path(const MovingCapsule<Scalar>& moving,
                                                 const Vec3<Scalar>& origin_W,
                                                 const Vec3<Scalar>& origin_v_W) {
  detail::CapsulePath<Scalar> path;
  path.bounding_radius = reach_of(moving);
  set_path(path, moving, origin_W, origin_v_W);
  return path;
}

template <class Scalar>
Capsule<Scalar> detail::capsule_at(const detail::CapsulePath<Scalar>& path, Scalar t) {
  const detail::SinCos<Scalar> turn = turn_at(path, t);
  const Vec3<Scalar> travel = path.v * t;
  return {{end_at(path.ends[0], turn, travel), end_at(path.ends[1], turn, travel)}, path.radius};
}

template <class Scalar>
Result<MovingPair<Scalar>> make_moving_pair(const MovingCapsule<Scalar>& A,
                                            const MovingCapsule<Scalar>& B) {
  Result<MovingPair<Scalar>> made;
  if (!is_usable(A) || !is_usable(B) || A.motion.duration != B.motion.duration) return made;
  const Scalar reach_A = reach_of(A);
  const Scalar reach_B = reach_of(B);
  const Scalar apart = length<Scalar>(B.motion.X_WB.p_W - A.motion.X_WB.p_W);
  const Scalar speed = length<Scalar>(B.motion.twist.v_W - A.motion.twist.v_W);
  const Scalar sizes = (reach_A + reach_B) + (A.capsule_B.radius + B.capsule_B.radius);
  const Scalar scale = kRoundUp<Scalar> * (apart + speed * A.motion.duration + sizes);
  if (!(scale <= kLargestCoordinate<Scalar>)) return made;
  made.status = Status::kOk;
  MovingPair<Scalar>& pair = made.value;
  pair.scale = scale;
  pair.origin_W = A.motion.X_WB.p_W;
  pair.origin_v_W = A.motion.twist.v_W;
  pair.duration = A.motion.duration;
  pair.A.bounding_radius = reach_A;
  pair.B.bounding_radius = reach_B;
  set_path(pair.A, A, pair.origin_W, pair.origin_v_W);
  set_path(pair.B, B, pair.origin_W, pair.origin_v_W);
  return made;
}

template <class Scalar>
detail::CapsulesAt<Scalar> detail::capsules_at(const MovingPair<Scalar>& pair, Scalar t) {
  return {detail::capsule_at(pair.A, t), detail::capsule_at(pair.B, t)};
}

template <class Scalar>
CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>& pair, Scalar t) {
  const detail::CapsulesAt<Scalar> capsules = detail::capsules_at(pair, t);
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
Scalar detail::gap_rate_at(const MovingPair<Scalar>& pair, const CapsuleGap<Scalar>& witness,
                           Scalar t) {
  const Vec3<Scalar> v_A = axis_velocity(pair.A, witness.axes.s, t);
  const Vec3<Scalar> v_B = axis_velocity(pair.B, witness.axes.u, t);
  return witness.axes.normal_AB.dot(v_B - v_A);
}

#define BATUTA_INSTANTIATE(Scalar)                                                            \
  template detail::CapsulePath<Scalar> detail::capsule_path(                                  \
      const MovingCapsule<Scalar>&, const Vec3<Scalar>&, const Vec3<Scalar>&);                \
  template Capsule<Scalar> detail::capsule_at(const detail::CapsulePath<Scalar>&, Scalar);    \
  template Result<MovingPair<Scalar>> make_moving_pair(const MovingCapsule<Scalar>&,          \
                                                       const MovingCapsule<Scalar>&);         \
  template detail::CapsulesAt<Scalar> detail::capsules_at(const MovingPair<Scalar>&, Scalar); \
  template CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>&, Scalar);                      \
  template CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>&, const ClosestPoints<Scalar>&, \
                                     Scalar);                                                 \
  template Scalar detail::gap_rate_at(const MovingPair<Scalar>&, const CapsuleGap<Scalar>&, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
